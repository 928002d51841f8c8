// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of another make, from CAD and scans, that stand on a flat face of theirs: pressed onto a
// block and slid. Reference: the closed form. All of the part is on one side of the face's plane
// and its centre of mass over the face, so that the depth is how far it is pressed, and the force
// k times that along the normal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/penetration/search/coherent.hpp"
#include "tests/engine/penetration/conforming_checks.hpp"
#include "tests/support/half_space.hpp"
#include "tests/support/real_meshes.hpp"

namespace sonde {
namespace {

struct Part {
  const char* file;
  Vec3 down;             ///< outward normal of the face it stands on, in the part's frame
  std::size_t at_least;  ///< so many triangles in that face
};

/// Outermost and tessellated faces, found by grouping the triangles of all meshes by normal.
const std::vector<Part> parts = {
    {"fandisk.off", {0, 1, 0}, 3000},      {"anchor_dense.off", {1, 0, 0}, 700},
    {"couplingdown.off", {0, 0, -1}, 200}, {"rotor_small.off", {1, 0, 0}, 250},
    {"turbine.off", {1, 0, 0}, 200},       {"joint.off", {0, -1, 0}, 60},
    {"oblong.off", {0, 0, 1}, 80},         {"cheese.off", {0, 0, -1}, 400},
};

constexpr double size = 0.05;  ///< of the part, its radius, m

/// The part standing on z = 0, its centre of mass over the origin.
struct Standing {
  std::shared_ptr<const Body> body;
  std::size_t triangles = 0;  ///< in the face that it stands on
};

Standing stand(const Part& part) {
  const auto given = load_body(test::real_mesh(part.file).string(), Model::automatic, 1);
  const double scale = size / given->mass.radius;
  const Quat q = Quat::FromTwoVectors(part.down, -Vec3::UnitZ());
  PolygonSoup soup;
  for (const Vec3& x : given->soup.vertices) soup.points.push_back(q * (scale * x));
  const Vec3 com = q * (scale * given->mass.com);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& x : soup.points) lowest = std::min(lowest, x.z());
  for (Vec3& x : soup.points) x -= Vec3(com.x(), com.y(), lowest);
  Standing out;
  for (const Triangle& t : given->soup.triangles) {
    soup.polygons.push_back({t[0], t[1], t[2]});
    out.triangles += std::all_of(t.begin(), t.end(),
                                 [&](std::uint32_t i) { return soup.points[i].z() < 1e-6 * size; });
  }
  out.body = test::body(soup);
  return out;
}

void press_and_slide(const Part& part, int n) {
  const std::string what = std::string(part.file) + ", n = " + std::to_string(n);
  const Standing standing = stand(part);
  ASSERT_GE(standing.triangles, part.at_least) << what;
  constexpr double thick = 0.06, pressed = 0.002, clear = 5.1e-4;
  const Pose deep{Quat::Identity(), Vec3(0, 0, -pressed)};
  ASSERT_NEAR(test::half_space_depth(*standing.body, deep, 0, 1, 8), pressed, 1e-3 * pressed)
      << what << ": does not stand there";
  const auto slab = test::cut_block({0.4, 0.4, thick}, {n});
  std::vector<Pose> path;
  std::vector<test::Felt> want;
  for (int i = 0; i <= 140; ++i) {
    const double in = std::min({i, 140 - i, 30}) / 30.0,
                 along = std::clamp((i - 30) / 80.0, 0., 1.);
    const double z = clear - (clear + pressed) * in;
    path.push_back({Quat(Eigen::AngleAxisd(0.3 * along, Vec3::UnitZ())),
                    Vec3(0.01 * along, 0.004 * std::sin(6 * along), thick / 2 + z)});
    want.emplace_back();
    want.back().force.z() = test::felt_stiffness * std::max(0.0, -z);
  }
  const auto felt = test::follow({standing.body, test::body(slab)}, path);
  test::expect_followed(felt, 0, what);
  test::expect_free_at_the_ends(felt, what);
  test::expect_felt_as(felt, want, size, 0.01, what);
  test::expect_no_friction_and_no_glue(felt, Vec3::UnitZ(), what);
}

// On two triangles, and on many of about the size of the part's own.
TEST(FlatParts, stand_on_a_block_and_slide) { press_and_slide(parts.front(), 1); }
TEST(FlatParts, Full_all_stand_on_a_block_and_slide) {
  for (const Part& part : parts)
    for (const int n : {1, 40}) press_and_slide(part, n);
}

}  // namespace
}  // namespace sonde
