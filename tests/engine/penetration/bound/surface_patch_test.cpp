// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/surface_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

LocalSurface all_of(const Body& body, const Vec3& x = Vec3::Zero()) {
  std::int64_t work = 0;
  return local_surface(body, Transform(), x, 100, 5000, work);
}

// By hand: a closed mesh has a neighbour across every edge, and that one has it back.
TEST(SurfacePatch, neighbours_are_mutual) {
  for (const PolygonSoup& soup : {test::box({1, 2, 3}), test::torus(1, 0.3, 12, 8)}) {
    const auto body = test::body(soup);
    const LocalSurface surface = all_of(*body);
    ASSERT_EQ(surface.size(), body->soup.triangles.size());
    for (std::uint32_t i = 0; i < surface.size(); ++i)
      for (const std::uint32_t j : surface.neighbour[i]) {
        ASSERT_NE(j, LocalSurface::none);
        EXPECT_EQ(std::ranges::count(surface.neighbour[j], i), 1);
      }
  }
}

// By hand: no more triangles than there is room for, about the pole that was asked for.
TEST(SurfacePatch, near_a_point_are_the_nearest) {
  const auto ball = test::body(test::sphere(1, 20, 30));
  std::int64_t work = 0;
  const LocalSurface near = local_surface(*ball, Transform(), Vec3(0, 0, 1), 100, 80, work);
  EXPECT_LE(near.size(), 80u);
  EXPECT_GT(near.size(), 20u);
  EXPECT_GT(work, 0);
  for (const Vec3& x : near.soup.vertices) EXPECT_GT(x.z(), 0);
  EXPECT_EQ(local_surface(*ball, Transform(), Vec3(0, 0, 3), 1, 80, work).size(), 0u);
}

// By hand: 3000 triangles of a cone meet at its tip, however short the reach.
TEST(SurfacePatch, at_a_tip_are_as_many_as_there_is_room_for) {
  PolygonSoup cone;
  cone.points.emplace_back(0, 0, 1);
  constexpr std::size_t sides = 3000;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / sides;
    cone.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    cone.polygons.push_back({0, i + 1, (i + 1) % sides + 1});
  }
  const auto body = test::body(cone);
  ASSERT_FALSE(scans_mesh(*body));
  std::int64_t work = 0;
  EXPECT_EQ(local_surface(*body, Transform(), Vec3(0, 0, 1), 1, 1000, work).size(), 1000u);
}

// By hand: a needle of 1 m by 1e-7 m, askew, and segments across it that end just off its plane.
// The normal that rounding leaves of it is off by more than they are.
TEST(SurfacePatch, needles_are_pierced_too) {
  std::mt19937_64 random(8);
  int doubtful = 0;
  for (int i = 0; i < 2000; ++i) {
    const Mat3 R = test::random_rotation(random).toRotationMatrix();
    const double width = std::pow(10, test::uniform(random, -9, -3));
    const Vec3 o(0.3, -0.2, 0.7), along = R.col(0), across = R.col(1), up = R.col(2);
    TriangleSet set;
    set.add({o, o + along, Vec3(o + along + width * across)});
    const double s = test::uniform(random, 0.5, 0.95);
    const Vec3 x = o + s * along + 0.4 * s * width * across;
    const double low = std::pow(10, test::uniform(random, -10, -1)),
                 high = std::pow(10, test::uniform(random, -10, -1));
    std::int64_t work = 0;
    const auto pierced = set.pierced(x - low * up, x + high * up, 1e-14, work);
    doubtful += !pierced;
    EXPECT_TRUE(!pierced || *pierced == 1) << width << " " << low << " " << high;
  }
  EXPECT_LT(doubtful, 500);
}

// By hand: from a face of a box no further than its rim, four sides of 1 to 3 m.
TEST(SurfacePatch, of_a_box_is_a_face) {
  const auto body = test::body(test::box({1, 2, 3}));
  const LocalSurface surface = all_of(*body);
  for (std::uint32_t seed = 0; seed < surface.size(); ++seed) {
    const SurfacePatch patch = patch_about(surface, seed, 0.2);
    EXPECT_EQ(patch.triangles.size(), 2u);
    EXPECT_EQ(patch.border.size(), 4u);
    std::int64_t work = 0;
    EXPECT_EQ(patch.border.distance({surface.at(seed)[0], surface.at(seed)[0], surface.at(seed)[0]},
                                    work),
              0);
  }
}

// By hand: of a ball, what faces within 78 degrees of the seed: between those of 60 and 90.
TEST(SurfacePatch, of_a_ball_is_a_cap) {
  const auto body = test::body(test::sphere(1, 40, 60));
  const LocalSurface surface = all_of(*body);
  const std::uint32_t top = surface.about(Vec3(0.01, 0.02, 0.999), Vec3::UnitZ(), 0.01);
  ASSERT_NE(top, LocalSurface::none);
  const SurfacePatch patch = patch_about(surface, top, 0.2);
  std::size_t least = 0, most = 0;
  for (std::uint32_t i = 0; i < surface.size(); ++i) {
    const Corners t = surface.at(i);
    const double height = (t[0] + t[1] + t[2]).normalized().z();
    least += height > 0.5, most += height > 0;
  }
  EXPECT_GT(patch.triangles.size(), least);
  EXPECT_LT(patch.triangles.size(), most);
}

// By hand: a plane through the middle cuts a ball in a circle, whose two halves end at one point.
TEST(SurfacePatch, a_cut_goes_round_a_ball) {
  const auto body = test::body(test::sphere(1, 30, 50));
  const LocalSurface surface = all_of(*body);
  const Vec3 x = Vec3(0.9, 0.3, 0.31).normalized();
  const std::uint32_t seed = surface.about(x, x, 0.02);
  const auto cut = plane_cut(surface, seed, x * 0.999, Vec3(-0.3, 0.9, 0.02).cross(x), 1000);
  ASSERT_TRUE(cut.has_value());
  EXPECT_EQ(cut->ahead.back(), cut->behind.back());
  double length = 0;
  for (const auto& way : {cut->ahead, cut->behind})
    for (std::size_t i = 1; i + 1 < way.size(); ++i) length += (way[i + 1] - way[i]).norm();
  EXPECT_NEAR(length, 2 * std::numbers::pi, 0.3);
  for (const Vec3& p : cut->ahead) EXPECT_NEAR(p.norm(), 1, 0.02);
}

// Reference: every triangle by itself, and the sign of a segment's two heights over a plane.
TEST(SurfacePatch, distances_and_piercings_are_those_of_its_triangles) {
  std::mt19937_64 random(5);
  const auto body = test::body(test::torus(1, 0.4, 30, 16));
  const LocalSurface surface = all_of(*body);
  TriangleSet set;
  for (std::uint32_t i = 0; i < surface.size(); ++i) set.add(surface.at(i));
  int odd = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = test::random_in_ball(random, 1.5), q = test::random_in_ball(random, 1.5);
    double least = 1e300;
    int count = 0;
    for (std::uint32_t t = 0; t < surface.size(); ++t) {
      least = std::min(least, closest_points({p, q, q}, surface.at(t)).distance);
      count += classify({p, q, q}, surface.at(t)) == Meeting::meeting;
    }
    std::int64_t work = 0;
    EXPECT_EQ(set.distance({p, q, q}, work), least);
    const auto pierced = set.pierced(p, q, 1e-12, work);
    ASSERT_TRUE(pierced.has_value());
    EXPECT_EQ(*pierced, count);
    // By hand: an end in the ring and one out of it.
    const auto in_ring = [](const Vec3& x) {
      return std::hypot(std::hypot(x.x(), x.y()) - 1, x.z()) < 0.4 * std::cos(0.21);
    };
    const auto out_of_ring = [](const Vec3& x) {
      return std::hypot(std::hypot(x.x(), x.y()) - 1, x.z()) > 0.41;
    };
    if (in_ring(p) && out_of_ring(q)) {
      EXPECT_EQ(*pierced % 2, 1);
      ++odd;
    }
  }
  EXPECT_GT(odd, 10);
}

}  // namespace
}  // namespace sonde
