// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/corner_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/engine/offset/prisms.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A soup with its fans and planes, which refer to it.
struct Cornered {
  Soup soup;
  Fans fans;
  CornerPlanes planes;
  Cornered(const PolygonSoup& polygons, double by, double rounding = 0)
      : soup(triangulate_all(polygons)),
        fans(find_fans(soup, 0)),
        planes(soup, fans, by, rounding) {}
  const Vec3& at(std::uint32_t fan) const { return soup.vertices[fans.vertex[fan]]; }
};

// Reference: by hand. A corner of a box moves by the length along each axis.
TEST(CornerPlanes, corners_of_a_box_move_along_all_three_axes) {
  for (const double by : {0.01, -0.02}) {
    const Cornered box(test::box({1, 2, 3}), by);
    EXPECT_EQ(box.planes.way(), std::abs(by));
    EXPECT_EQ(box.planes.sign(), by < 0 ? -1 : 1);
    ASSERT_EQ(box.fans.count(), 8u);
    for (std::uint32_t fan = 0; fan < 8; ++fan) {
      const Vec3 outwards = box.at(fan).cwiseSign();
      EXPECT_LT((box.planes.way_of(fan) - by * outwards).norm(), 1e-15);
      const std::vector<HalfSpace3> planes = box.planes.planes_of(fan);
      EXPECT_EQ(planes.size(), 3u);  // however many triangles there are
      for (const HalfSpace3& plane : planes) {
        EXPECT_EQ(plane.least, std::abs(by));
        EXPECT_NEAR(plane.normal.dot((by < 0 ? -1 : 1) * outwards), 1, 1e-15);
      }
    }
    for (const Vec3& n : box.planes.normals()) EXPECT_EQ(n.cwiseAbs().sum(), 1);
    for (const char has_say : box.planes.have_say()) EXPECT_TRUE(has_say);
  }
}

// Reference: by hand. Where two planes meet along an edge at this angle, a corner on that edge goes
// by / sin(half of it) away from it, up to ten times the length; the three planes of a prism's
// corner have one point in common.
TEST(CornerPlanes, a_sharp_blade_is_held_back_outwards_alone) {
  const double by = 1e-3;
  for (const double half : {0.5, 0.2, 0.05, 0.02}) {  // rad
    const test::Outline blade{{0, 0}, {1, -std::tan(half)}, {1, std::tan(half)}};
    for (const double sign : {1.0, -1.0}) {
      const Cornered prism(test::prism(blade, 2), sign * by);
      const double along = by / std::sin(half), whole = std::hypot(along, by);
      const bool held = sign > 0 && whole > most_outward_way * by;
      for (std::uint32_t fan = 0; fan < prism.fans.count(); ++fan) {
        if (prism.at(fan).x() != 0) continue;
        const Vec3 up(0, 0, prism.at(fan).z() > 0 ? by : -by);
        Vec3 wanted = sign * (Vec3(-along, 0, 0) + up);
        if (held) wanted *= most_outward_way * by / whole;
        EXPECT_LT((prism.planes.way_of(fan) - wanted).norm(), 1e-12) << half << " " << sign;
      }
    }
  }
}

// Reference: the tip of a cone goes by / sin(half the angle) along its axis: on all its many
// planes. Their tilt is that of a regular pyramid's faces.
TEST(CornerPlanes, the_tip_of_a_pyramid_stays_on_all_its_planes) {
  const double by = 1e-3;
  for (const int sides : {3, 4, 12, 100}) {
    PolygonSoup pyramid;
    Polygon base;
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * std::numbers::pi * i / sides;
      pyramid.points.emplace_back(std::cos(a), std::sin(a), 0);
      base.insert(base.begin(), static_cast<std::size_t>(i));
    }
    const auto tip = static_cast<std::size_t>(sides);
    pyramid.points.emplace_back(0, 0, 2);
    pyramid.polygons.push_back(base);
    for (std::size_t i = 0; i < tip; ++i) pyramid.polygons.push_back({i, (i + 1) % tip, tip});
    const Cornered cone(pyramid, by);
    const double across = std::cos(std::numbers::pi / sides);  // the middle of a side
    const double wanted = by * std::hypot(2, across) / across;
    for (std::uint32_t fan = 0; fan < cone.fans.count(); ++fan) {
      if (cone.at(fan).z() != 2) continue;
      EXPECT_LT((cone.planes.way_of(fan) - Vec3(0, 0, wanted)).norm(), 1e-9 * by) << sides;
    }
  }
}

// Reference: each half-space at its word, and every one of many random ways that is in them all.
// Four planes of a corner have no point in common: the nearest point behind them all is taken.
TEST(CornerPlanes, a_corner_of_planes_without_a_common_point_goes_behind_them_all) {
  std::mt19937_64 random(1);
  PolygonSoup roof;  // an irregular pyramid
  roof.points = {{1, 0.3, 0},     {0.2, 1, 0},  {-1, 0.4, 0},
                 {-0.7, -0.6, 0}, {0.5, -1, 0}, {0.1, 0.05, 0.8}};
  roof.polygons = {{4, 3, 2, 1, 0}, {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}};
  for (const double by : {1e-3, -1e-3}) {
    const Cornered solid(roof, by);
    for (std::uint32_t fan = 0; fan < solid.fans.count(); ++fan) {
      if (solid.at(fan).z() == 0) continue;
      const std::vector<HalfSpace3> planes = solid.planes.planes_of(fan);
      ASSERT_EQ(planes.size(), 5u);
      const Vec3 way = solid.planes.way_of(fan);
      const auto behind_all = [&](const Vec3& x, double slack) {
        return std::ranges::all_of(
            planes, [&](const HalfSpace3& p) { return p.normal.dot(x) >= p.least - slack; });
      };
      EXPECT_TRUE(behind_all(way, 1e-12));
      int others = 0;
      for (int i = 0; i < 20000; ++i) {
        const Vec3 x = way + test::random_in_ball(random, 1e-3);
        if (!behind_all(x, 0)) continue;
        ++others;
        EXPECT_GE(x.norm(), way.norm() * (1 - 1e-9));
      }
      EXPECT_GT(others, 100);
    }
  }
}

// Reference: by hand. A sliver of 1e-9 m has no say at a rounding of 1e-7, but for a fan that has
// no other.
TEST(CornerPlanes, slivers_have_no_say_where_others_have) {
  PolygonSoup box = test::box({1, 1, 1});
  const Cornered exact(box, 0.01, 1e-7);
  // A needle along an edge of the box, beside it, which looks anywhere.
  PolygonSoup needle{{{3, 0, 0}, {4, 0, 0}, {3.5, 1e-9, 1e-9}}, {{0, 1, 2}, {0, 2, 1}}};
  const Cornered both(test::together(box, needle), 0.01, 1e-7);
  const std::vector<char>& says = both.planes.have_say();
  EXPECT_EQ(std::ranges::count(says, char(0)), 2);
  EXPECT_EQ(std::ranges::count(exact.planes.have_say(), char(0)), 0);
  for (std::uint32_t fan = 0; fan < both.fans.count(); ++fan) {
    std::size_t faces = 0, with_say = 0;
    both.planes.for_faces(fan, [&](std::uint32_t t) { ++faces, with_say += says[t] != 0; });
    EXPECT_GT(faces, 0u);
    EXPECT_EQ(with_say, both.at(fan).x() > 2 ? 0 : faces);
  }
  for (std::size_t t = 0; t < says.size(); ++t)
    EXPECT_EQ(both.planes.tilts()[t] > one_plane, !says[t]) << t;
}

}  // namespace
}  // namespace sonde
