// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "engine/proximity/queries/inside.hpp"
#include "tests/support/columns.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/real_meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Eigen::AlignedBox3d bounds_of(const Body& body) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : body.soup.vertices) box.extend(x);
  return box;
}

/// Solid angles over 4π (Van Oosterom and Strackee, 1983): a whole number for closed meshes.
double winding(const std::vector<std::array<Vec3, 3>>& triangles, const Vec3& x) {
  double sum = 0;
  for (const auto& t : triangles) {
    const Vec3 a = t[0] - x, b = t[1] - x, c = t[2] - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

/// Random points in the bounds: inside where the winding number rounds to anything but 0.
void expect_inside_is_right(const Body& body, int points, std::uint64_t seed) {
  const auto triangles = test::boundary(body);
  const Eigen::AlignedBox3d box = bounds_of(body);
  std::mt19937_64 random(seed);
  for (int k = 0; k < points; ++k) {
    Vec3 x;
    for (Eigen::Index i = 0; i < 3; ++i) x[i] = test::uniform(random, box.min()[i], box.max()[i]);
    EXPECT_EQ(winds_around(body, x), std::abs(winding(triangles, x)) >= 0.5)
        << body.name << " at " << x.transpose();
  }
}

void expect_mass_is_right(const Body& body, int count, double tolerance) {
  const test::Moments found = test::moments_by_columns(body, count);
  EXPECT_NEAR(body.mass.measure, found.measure, tolerance * found.measure) << body.name;
  EXPECT_LT((body.mass.com - found.com).norm(), tolerance * body.mass.radius) << body.name;
  // The trace of the spread is half of that of the inertia.
  const double inertia = body.mass.inertia.sum(), spread = 2 * found.covariance.trace();
  EXPECT_NEAR(inertia, spread, 2 * tolerance * spread) << body.name;
  EXPECT_TRUE(bounds_of(body).contains(body.mass.com)) << body.name;
}

/// Every n-th of the real meshes that are solids; at least some.
template <class Use>
void each_real_solid(std::size_t every, Use use) {
  std::size_t n = 0, solids = 0;
  for (const auto& file : test::real_meshes()) {
    if (n++ % every != 0) continue;
    std::shared_ptr<const Body> body;
    try {
      body = load_body(file.string(), Model::automatic);
    } catch (const InputError&) {
      continue;  // a few are no meshes
    }
    if (!body->solid) continue;
    ++solids;
    use(*body);
  }
  EXPECT_GE(solids, 90 / every);
}

// Reference: exact winding numbers, and an integration over them along columns that shares no code
// with the engine's (its own error is that of some 10⁵ columns).
TEST(InsideReal, every_fifth_mesh_has_the_inside_of_its_winding_numbers) {
  each_real_solid(5, [](const Body& body) {
    expect_inside_is_right(body, 200, 1);
    expect_mass_is_right(body, 300, 3e-3);
  });
}

TEST(InsideReal, Full_all_meshes_have_the_inside_of_their_winding_numbers) {
  each_real_solid(1, [](const Body& body) {
    expect_inside_is_right(body, 1000, 2);
    expect_mass_is_right(body, 600, 1e-3);
  });
}

TEST(InsideReal, broken_meshes_have_the_inside_of_their_winding_numbers) {
  std::uint64_t seed = 0;
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::icosphere(0.02, 3), test::torus(50, 12, 40, 20)}) {
    double size = 0;
    for (const Vec3& x : mesh.points) size = std::max(size, x.norm());
    const PolygonSoup away = test::placed(mesh, {3 * size, 0, 0});
    for (const PolygonSoup& broken :
         {test::cracked(mesh, 1e-6 * size, ++seed), test::cut_beyond(mesh, Vec3(1, 2, 3), 0),
          test::cut_beyond(mesh, Vec3(1, 2, 3), 0, 1e-7 * size),
          test::joined(mesh, test::turned_over(away)),
          test::joined(mesh, test::placed(mesh, Vec3::Constant(size / 5))),
          test::without(mesh, [n = 0](const Vec3&) mutable { return ++n == 7; })}) {
      const auto body = test::body(broken, Model::solid);
      ASSERT_TRUE(body->solid);
      expect_inside_is_right(*body, 500, ++seed);
      expect_mass_is_right(*body, 300, 3e-3);
    }
  }
}

// A sheet beside a solid is touched, and has no inside.
TEST(InsideReal, what_is_loose_does_not_wind) {
  const PolygonSoup sheet =
      test::without(test::box({9, 9, 1}), [](const Vec3& x) { return x.z() > -0.49; });
  const auto body =
      test::body(test::joined(test::icosphere(1, 3), test::placed(sheet, {0, 0, -2})));
  ASSERT_EQ(std::count(body->loose.begin(), body->loose.end(), true), 2);
  EXPECT_TRUE(winds_around(*body, {0, 0.1, 0.2}));
  EXPECT_FALSE(winds_around(*body, {3, 0.1, -2.2}));
  EXPECT_FALSE(winds_around(*body, {3, 0.1, -2.6}));
  EXPECT_FALSE(winds_around(*body, {0, 0.1, -2}));
}

}  // namespace
}  // namespace sonde
