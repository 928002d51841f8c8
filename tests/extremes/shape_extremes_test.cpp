// SPDX-License-Identifier: GPL-3.0-or-later
// Static searches of shapes that nobody would model: needles, leaves, faces that repeat or lie in
// one plane, one triangle and a million. The reference is geometry by hand: a box that lies flat in
// a plate comes out straight up by as much as it is in; any probe within a ball about its centre of
// mass, deep in a box, must come out to the nearest face.
#include <algorithm>
#include <random>

#include "engine/penetration/search/static_search.hpp"
#include "tests/extremes/press.hpp"
#include "tests/reference/brute_search.hpp"
#include "tests/reference/depths_file.hpp"

namespace sonde {
namespace {

using test::brick;
using test::expect_between;
using test::expect_depth;
using test::flat_in_plate;
using test::plate;

std::shared_ptr<const Body> the_plate() { return test::body(test::box(plate)); }

/// Reference: a search with hundreds of random starts (tests/reference), an upper bound that
/// repeats to 0.3 %; and below, what is known by hand.
void expect_as_by_brute_force(const char* what, const Pair& pair, const Pose& X_FM, double least) {
  const double brute =
      reference::brute_search(pair.probe(), pair.fixed(), X_FM, {.starts = 200, .hops = 50}).depth;
  const double repeats = reference::repeats_to * brute;
  test::expect_answer(what, pair, separate_static(pair, X_FM), std::max(least, brute - repeats),
                      brute, repeats);
}

TEST(ShapeExtremes, faces_that_say_nothing_new) {
  const auto with = [](auto change) {
    PolygonSoup soup = test::box(brick);
    change(soup);
    return soup;
  };
  const std::pair<const char*, PolygonSoup> probes[] = {
      {"every face twice", with([](PolygonSoup& s) {
         const auto faces = s.polygons;
         s.polygons.insert(s.polygons.end(), faces.begin(), faces.end());
       })},
      {"every face a thousand times", with([](PolygonSoup& s) {
         const auto faces = s.polygons;
         for (int i = 1; i < 1000; ++i)
           s.polygons.insert(s.polygons.end(), faces.begin(), faces.end());
       })},
      {"inside out", with([](PolygonSoup& s) {
         for (auto& face : s.polygons) std::ranges::reverse(face);
       })},
      {"faces without area", with([](PolygonSoup& s) {
         s.polygons.push_back({0, 1, 1});
         s.polygons.push_back({2, 2, 2});
         s.points.push_back((s.points[0] + s.points[1]) / 2);  // three corners in a line
         s.polygons.push_back({0, s.points.size() - 1, 1});
       })}};
  for (const auto& [name, soup] : probes)
    expect_depth(name, {test::body(soup), the_plate()}, flat_in_plate(0.01), 0.01);
}

/// The brick, and so many triangles of its bottom's own plane, within it, that cover each other.
PolygonSoup brick_with_coplanar_triangles(int count) {
  PolygonSoup soup = test::box(brick);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> along(-0.5, 0.5);
  for (int i = 0; i < count; ++i) {
    const std::size_t first = soup.points.size();
    for (int k = 0; k < 3; ++k)
      soup.points.emplace_back(brick.x() * along(random), brick.y() * along(random),
                               -brick.z() / 2);
    soup.polygons.push_back({first, first + 1, first + 2});
  }
  return soup;
}

// In either role: the same faces are then in the plane of the other's top.
TEST(ShapeExtremes, hundreds_of_triangles_that_overlap_in_one_plane) {
  const auto many = test::body(brick_with_coplanar_triangles(300));
  expect_depth("300 overlapping triangles in one plane", {many, the_plate()}, flat_in_plate(0.01),
               0.01);
  const Separation flush = separate_static({many, the_plate()}, flat_in_plate(0));
  EXPECT_EQ(flush.status, Status::penetrating);
  EXPECT_LE(flush.depth, 2e-9);
  std::printf("  the same, flush with the other's face: %.2g m\n", flush.depth);
}

// Reference: the centre of mass of both is as deep as the pose says, and has to come out. The cap
// lies flat, so that is enough.
TEST(ShapeExtremes, needles_and_caps_of_aspect_1e10) {
  const auto needle = test::body({{{0, 0, 0}, {0, 1e-11, 0.1}, {0, 0, 0.1}}, {{0, 1, 2}}});
  const auto cap = test::body({{{-0.05, 0, 0}, {0.05, 0, 0}, {0, 0, -1e-11}}, {{0, 1, 2}}});
  expect_depth("cap of aspect 1e10", {cap, the_plate()}, {Quat::Identity(), Vec3(0.02, 0, 0.49)},
               0.01);
  expect_as_by_brute_force("needle of aspect 1e10, on end", {needle, the_plate()},
                           {Quat::Identity(), Vec3(0.02, 0, 0.42)}, 0.5 - 0.42 - 0.1 * 2 / 3);
}

TEST(ShapeExtremes, one_triangle_through_one_triangle) {
  const auto flat = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const auto upright = test::body({{{-0.2, 0, -0.5}, {0.2, 0, -0.5}, {0, 0, 0.1}}, {{0, 1, 2}}});
  expect_as_by_brute_force("one triangle through one", {upright, flat}, {}, 0);
}

// Reference: no two cubes of one centre are apart before the one has gone half a side at least (the
// centre must come out), and a whole side is enough.
TEST(ShapeExtremes, identical_bodies_at_one_pose_and_nested_ones) {
  const auto cube = test::body(test::box({1, 1, 1})), small = test::body(test::box(brick));
  expect_between("identical cubes at one pose", {cube, cube}, {}, 0.5, 1);
  // Its centre of mass has to come to the face.
  expect_between("a brick in the middle of a cube", {small, cube}, {}, 0.5, 0.53);
}

TEST(ShapeExtremes, flat_and_line_like_probes) {
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  const auto needle = test::body({{{0, 0, 0}, {0.2, 0, 0}, {0.2, 1e-10, 0}}, {{0, 1, 2}}});
  const auto leaf = test::body(test::box({0.1, 0.15, 0}));
  const auto under_the_face = [&](const char* what, const std::shared_ptr<const Body>& probe) {
    const Pose flat{Quat::Identity(), Vec3(0.05, 0.03, 0.045) - probe->mass.com};
    expect_depth(what, {probe, block}, flat, 0.005);
  };
  under_the_face("line-like", needle);
  under_the_face("flat", leaf);
}

/// The brick with sides and top dented inwards at random, all but the bottom, which is as it was:
/// about `count` triangles, no two of which lie in one plane.
PolygonSoup dented_brick(int count) {
  const int n = static_cast<int>(std::sqrt(count / 4.0)), rows = n / 2;
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> dent(0.9, 1);
  PolygonSoup soup;
  // Rings of points about the axis from the bottom's rim upwards, and a point on top.
  for (int row = 0; row <= rows; ++row)
    for (int k = 0; k < 4 * n; ++k) {
      const double t = static_cast<double>(k % n) / n;
      const Vec3 corners[] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}};
      const Vec3 rim = (1 - t) * corners[k / n] + t * corners[k / n + 1];
      const double in = row == 0 ? 1 : dent(random);
      soup.points.emplace_back(0.5 * brick.x() * rim.x() * in, 0.5 * brick.y() * rim.y() * in,
                               brick.z() * (static_cast<double>(row) / rows - 0.5));
    }
  soup.points.emplace_back(0, 0, 0.5 * brick.z());
  const auto at = [&](int row, int k) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(4 * n) +
           static_cast<std::size_t>(k % (4 * n));
  };
  std::vector<std::size_t> bottom;
  for (int k = 4 * n; k-- > 0;) {
    bottom.push_back(at(0, k));
    soup.polygons.push_back({at(rows, k), at(rows, k + 1), soup.points.size() - 1});
    for (int row = 0; row < rows; ++row) {
      soup.polygons.push_back({at(row, k), at(row, k + 1), at(row + 1, k + 1)});
      soup.polygons.push_back({at(row, k), at(row + 1, k + 1), at(row + 1, k)});
    }
  }
  soup.polygons.push_back(bottom);
  return soup;
}

void press_dented_brick(const char* what, int count) {
  const auto probe = test::body(dented_brick(count));
  EXPECT_TRUE(probe->solid) << probe->why;
  EXPECT_GT(probe->soup.triangles.size(), 0.95 * count);
  EXPECT_LT(surface(*probe).triangles.size(), 1.05 * count) << "the bottom is one flat part";
  EXPECT_GT(surface(*probe).triangles.size(), 0.9 * count) << "and nothing else is";
  expect_depth(what, {probe, the_plate()}, flat_in_plate(0.01), 0.01);
}
TEST(ShapeExtremes, ten_thousand_triangles_no_two_in_one_plane) {
  press_dented_brick("10 thousand triangles, dented", 10'000);
}
TEST(ShapeExtremes, Full_a_million_triangles_no_two_in_one_plane) {
  press_dented_brick("a million triangles, dented", 1'000'000);
}

TEST(ShapeExtremes, Full_a_million_copies_of_one_triangle) {
  PolygonSoup many{{{-0.05, -0.04, -0.03}, {0.05, -0.04, -0.03}, {0, 0.04, -0.03}}, {}};
  many.polygons.assign(1'000'000, {0, 1, 2});
  expect_depth("a million copies of one triangle", {test::body(many), the_plate()},
               flat_in_plate(0.01), 0.01);
}

}  // namespace
}  // namespace sonde
