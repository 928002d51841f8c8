// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/joints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/region_mass.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A wire of a square section, 2 t wide and high, bent at the points of a path over the xy plane:
/// its sections at the bends are mitres, upright. Its volume is (2 t)² times its length over xy.
PolygonSoup wire(const std::vector<Vec3>& path, double t) {
  PolygonSoup out;
  const std::size_t n = path.size();
  const auto way = [&](std::size_t k) {
    return Eigen::Vector2d((path[k + 1] - path[k]).head<2>().normalized());
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector2d in = way(k == 0 ? 0 : k - 1), on = way(k + 1 < n ? k : n - 2);
    const Eigen::Vector2d along = (in + on).normalized(), left(-along.y(), along.x());
    const Eigen::Vector2d off = t / along.dot(on) * left;
    for (const auto& [side, up] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
      out.points.push_back(path[k] + Vec3(side * off.x(), side * off.y(), up * t));
    for (std::size_t i = 0; k > 0 && i < 4; ++i) {
      const std::size_t a = 4 * k - 4 + i, b = 4 * k - 4 + (i + 1) % 4;
      out.polygons.push_back({a, a + 4, b + 4, b});
    }
  }
  out.polygons.push_back({0, 1, 2, 3});
  out.polygons.push_back({4 * n - 1, 4 * n - 2, 4 * n - 3, 4 * n - 4});
  return test::triangulated(out);
}

double length_over_xy(const std::vector<Vec3>& path) {
  double sum = 0;
  for (std::size_t k = 1; k < path.size(); ++k) sum += (path[k] - path[k - 1]).head<2>().norm();
  return sum;
}

PolygonSoup turned(const PolygonSoup& soup, const Quat& by) {
  return test::moved(soup, [by](const Vec3& x) { return Vec3(by * x); });
}

Region region_of(const PolygonSoup& mesh) {
  const Soup soup = test::soup_of(mesh);
  return find_region(soup, std::vector<std::uint32_t>(soup.triangles.size(), 0));
}

struct Bent {
  std::vector<Vec3> path;
  double common;  ///< what is there twice, in units of t³
};

/// Wires of one piece whose legs go through each other, `up` the one over the other's middle.
std::vector<Bent> bent(double t, double up) {
  const double z = up * t, thick = 4 * (2 - up);
  // It rises where it is straight, so that its faces are flat.
  const auto on = [&](std::vector<Vec3> rest) {
    std::vector<Vec3> path{{-1, 0, 0}, {1, 0, 0}, {1, 0.3, 0}, {1, 0.7, z}};
    for (Vec3& x : rest) path.push_back(x + z * Vec3::UnitZ());
    return path;
  };
  return {
      // A loop, square and askew.
      {on({{1, 1, 0}, {0.1, 1, 0}, {0.1, -1, 0}}), thick},
      {on({{1, 1, 0}, {0.5, 1, 0}, {-0.4, -1, 0}}), thick * std::hypot(0.9, 2) / 2},
      // A pretzel with three places.
      {on({{1, 1, 0},
           {0.6, 1, 0},
           {0.6, -1, 0},
           {0.05, -1, 0},
           {0.05, 1, 0},
           {-0.5, 1, 0},
           {-0.5, -1, 0}}),
       3 * thick},
      // It ends inside the other leg, a quarter from its far side.
      {on({{1, 1, 0}, {-0.3, 1, 0}, {-0.3, -0.5 * t, 0}}), 0.75 * thick},
  };
}

// Reference: closed forms, above. The sum over the triangles has what is there twice, twice.
TEST(Joints, one_part_that_crosses_itself_thinly_counts_once) {
  std::mt19937_64 random(5);
  for (const double t : {0.01, 0.003, 0.001})
    for (const double up : {0.0, 0.3, 1.1})
      for (const Bent& b : bent(t, up))
        for (int i = 0; i < 3; ++i) {
          const PolygonSoup mesh = turned(
              wire(b.path, t), i == 0 ? Quat(Quat::Identity()) : test::random_rotation(random));
          const double common = b.common * t * t * t,
                       volume = 4 * t * t * length_over_xy(b.path) - common;
          const Region region = region_of(mesh);
          ASSERT_TRUE(region.overlaps) << t << " " << up;
          EXPECT_FALSE(region.unknown);
          const double found = mass_of(region).measure;
          EXPECT_LE(std::abs(found - volume), region.error * volume + 1e-11)
              << t << " " << up << " off by " << (found - volume) / common << " of the joint, said "
              << region.error * volume / common;
          // Where few of the lines through all of it meet it, the error is large, but said.
          EXPECT_LT(region.error * volume, 12 * common);
          const Region back = region_of(test::turned_over(mesh));
          EXPECT_LE(std::abs(mass_of(back).measure - volume), back.error * volume + 1e-11);
        }
}

TEST(Joints, are_none_of_a_part_that_only_touches_or_folds) {
  const double t = 0.01;
  const std::vector<Vec3> apart{
      {-1, 0, 0}, {1, 0, 0}, {1, 1, 3 * t}, {0, 1, 3 * t}, {0, -1, 3 * t}};
  for (const PolygonSoup& mesh :
       {wire(apart, t), test::torus(1, 0.01, 60, 8), test::torus_knot(2, 3, 1, 0.4, 0.02, 200, 8),
        test::icosphere(1, 3)}) {
    const Soup soup = test::soup_of(mesh);
    const Joints joints =
        find_joints(soup, std::vector<std::uint32_t>(soup.triangles.size(), 0), 1e-3, 1e-9);
    EXPECT_FALSE(joints.any);
    EXPECT_TRUE(joints.complete);
    EXPECT_FALSE(region_of(mesh).overlaps);
  }
}

}  // namespace
}  // namespace sonde
