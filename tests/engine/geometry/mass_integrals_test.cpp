// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/mass_integrals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::soup_of;

Soup moved(Soup soup, const Quat& q, const Vec3& p) {
  for (Vec3& x : soup.vertices) x = q * x + p;
  return soup;
}

Soup scaled(Soup soup, double s) {
  for (Vec3& x : soup.vertices) x *= s;
  return soup;
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " against " << b.transpose();
}

Mat3 tensor(const MassProperties& m) {
  return m.R_MP * m.inertia.asDiagonal() * m.R_MP.transpose();
}

// Reference: the box a×b×c has V = abc and Î = ((b²+c²), (a²+c²), (a²+b²))/12.
TEST(Mass, box) {
  const MassProperties m = mass_by_volume(soup_of(test::box({1, 2, 3})));
  EXPECT_TRUE(m.by_volume);
  EXPECT_NEAR(m.measure, 6, 1e-14);
  expect_near(m.com, Vec3::Zero(), 1e-15);
  expect_near(m.inertia, Vec3(5, 10, 13) / 12, 1e-14);
  EXPECT_NEAR(m.radius, std::sqrt(14.0) / 2, 1e-15);
  Mat3 axes;  // z is the axis of least inertia, then y; signs as documented
  axes << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  EXPECT_LE((m.R_MP - axes).norm(), 1e-14);
}

// Reference: the surface of a cube of edge a has area 6a² and Î = 5a²/18 about each axis
// (two faces across the axis: a²/6 each; four beside it: a²/12 + a²/4 each).
TEST(Mass, surface_of_a_cube) {
  const MassProperties m = mass_by_area(soup_of(test::box({2, 2, 2})));
  EXPECT_FALSE(m.by_volume);
  EXPECT_NEAR(m.measure, 24, 1e-13);
  expect_near(m.inertia, Vec3::Constant(4 * 5.0 / 18), 1e-14);
  EXPECT_EQ(m.R_MP, Mat3::Identity());
}

// Reference: the regular tetrahedron of edge L has V = L³/(6√2), Î = L²/20, R = L√(3/8).
TEST(Mass, regular_tetrahedron) {
  const double edge = 3 * std::numbers::sqrt2;
  const MassProperties m = mass_by_volume(soup_of(test::tetrahedron(3)));
  EXPECT_NEAR(m.measure, edge * edge * edge / (6 * std::numbers::sqrt2), 1e-13);
  expect_near(m.inertia, Vec3::Constant(edge * edge / 20), 1e-14);
  EXPECT_NEAR(m.radius, edge * std::sqrt(3.0 / 8), 1e-14);
  EXPECT_EQ(m.R_MP, Mat3::Identity());
}

// Reference: the ball has V = 4πr³/3 and Î = 2r²/5, the sphere A = 4πr² and Î = 2r²/3; the error of
// an inscribed polyhedron falls with the square of the edge length.
TEST(Mass, sphere_converges) {
  const double r = 2;
  double last[4] = {1e9, 1e9, 1e9, 1e9};
  for (const int n : {16, 32, 64, 128}) {
    const Soup soup = soup_of(test::sphere(r, n, 2 * n));
    const MassProperties v = mass_by_volume(soup), a = mass_by_area(soup);
    const double error[4] = {std::abs(v.measure / (4 * std::numbers::pi * r * r * r / 3) - 1),
                             (v.inertia / (0.4 * r * r) - Vec3::Ones()).norm(),
                             std::abs(a.measure / (4 * std::numbers::pi * r * r) - 1),
                             (a.inertia / (2 * r * r / 3) - Vec3::Ones()).norm()};
    for (int i = 0; i < 4; ++i) {
      EXPECT_LT(error[i], 0.3 * last[i]);
      last[i] = error[i];
    }
    expect_near(v.com, Vec3::Zero(), 1e-14);
  }
  for (const double error : last) EXPECT_LT(error, 2e-3);
}

// Reference: the right triangle with legs a, b along x and y has area ab/2 and, about its centroid,
// mean squares a²/18 and b²/18 and mean product −ab/36; the rest is a 2×2 eigenvalue problem.
TEST(Mass, triangle_surface) {
  const double a = 3, b = 2;
  Soup soup;
  soup.vertices = {{0, 0, 5}, {a, 0, 5}, {0, b, 5}, {100, 100, 100}};  // the last is not used
  soup.triangles = {{0, 1, 2}};
  const MassProperties m = mass_by_area(soup);
  EXPECT_NEAR(m.measure, a * b / 2, 1e-14);
  expect_near(m.com, Vec3(a / 3, b / 3, 5), 1e-14);
  const double mean = (a * a + b * b) / 36, half = std::hypot((a * a - b * b) / 36, a * b / 36);
  expect_near(m.inertia, Vec3(mean - half, mean + half, 2 * mean), 1e-14);
  EXPECT_NEAR(m.radius, std::hypot(2 * a / 3, b / 3), 1e-14);  // the far vertex does not count
}

// Reference: moving a body moves its centre of mass and turns its inertia tensor, no more.
TEST(Mass, moves_with_the_body) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const Soup soup = soup_of(test::box({1, 2, 3}));
    const Quat q = test::random_rotation(random);
    const Vec3 p = test::random_in_ball(random, 10);
    for (const bool volume : {true, false}) {
      const auto mass = [volume](const Soup& s) {
        return volume ? mass_by_volume(s) : mass_by_area(s);
      };
      const MassProperties there = mass(moved(soup, q, p)), here = mass(soup);
      expect_near(there.com, q * here.com + p, 1e-13);
      expect_near(there.inertia, here.inertia, 1e-13);
      EXPECT_LE((tensor(there) - q * tensor(here) * q.conjugate()).norm(), 1e-13);
      EXPECT_LE((there.R_MP.transpose() * there.R_MP - Mat3::Identity()).norm(), 1e-14);
      EXPECT_NEAR(there.R_MP.determinant(), 1, 1e-14);
      for (int k = 0; k < 2; ++k) {
        int largest = 0;
        there.R_MP.col(k).cwiseAbs().maxCoeff(&largest);
        EXPECT_GT(there.R_MP(largest, k), 0);
      }
    }
  }
}

// Reference: the closed forms of the box; vertices a million away are rounded to about 1e-10.
TEST(Mass, far_from_the_origin) {
  const Vec3 far(1e6, -2e6, 3e6);
  const MassProperties m =
      mass_by_volume(moved(soup_of(test::box({1, 2, 3})), Quat::Identity(), far));
  EXPECT_NEAR(m.measure, 6, 1e-8);
  expect_near(m.com, far, 1e-9);
  expect_near(m.inertia, Vec3(5, 10, 13) / 12, 1e-8);
}

// Reference: powers of two scale every number exactly: V by s³, A by s², Î by s², R by s.
TEST(Mass, powers_of_two_scale_exactly) {
  const Soup soup =
      moved(soup_of(test::torus(1, 0.3, 9, 7)), Quat(1, 2, 3, 4).normalized(), {1, 2, 3});
  for (const double s : {0x1p-200, 0x1p-10, 0x1p10, 0x1p200}) {
    for (const bool volume : {true, false}) {
      const auto mass = [volume](const Soup& x) {
        return volume ? mass_by_volume(x) : mass_by_area(x);
      };
      const MassProperties one = mass(soup), other = mass(scaled(soup, s));
      EXPECT_EQ(other.measure, one.measure * s * s * (volume ? s : 1));
      EXPECT_EQ(other.com, one.com * s);
      EXPECT_EQ(other.inertia, Vec3(one.inertia * s * s));
      EXPECT_EQ(other.R_MP, one.R_MP);
      EXPECT_EQ(other.radius, one.radius * s);
    }
  }
}

// Reference: the box; rounding of the turned vertices is 1e-16 of its length, so 1e-12 of its
// width.
TEST(Mass, slanted_needle_keeps_its_smallest_inertia) {
  std::mt19937_64 random(2);
  const Vec3 size(1, 1e-4, 2e-4);
  for (int i = 0; i < 20; ++i) {
    const Soup needle = moved(soup_of(test::box(size)), test::random_rotation(random),
                              test::random_in_ball(random, 1));
    const MassProperties m = mass_by_volume(needle);
    EXPECT_NEAR(m.inertia[0] / (5e-8 / 12), 1, 1e-8);
    EXPECT_NEAR(m.inertia[2] / ((1 + 4e-8) / 12), 1, 1e-12);
  }
}

// Reference: the triangle of base 1 and height h has Î = h²/18 about its length; the largest is
// about 1/24.
TEST(Mass, line_like_inertia_is_exactly_zero) {
  const auto inertia = [](double h) {
    Soup soup;
    soup.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}};
    soup.triangles = {{0, 1, 2}};
    return mass_by_area(soup).inertia;
  };
  EXPECT_EQ(inertia(1e-9)[0], 0);
  EXPECT_NEAR(inertia(1e-5)[0] / (1e-10 / 18), 1, 1e-9);
}

TEST(Mass, flat_closed_mesh_has_no_volume_and_no_na_n) {
  Soup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {0.3, 0.7, 0.9}};
  soup.triangles = {{0, 1, 2}, {0, 2, 1}};
  const MassProperties m = mass_by_volume(soup);
  EXPECT_EQ(m.measure, 0);
  EXPECT_TRUE(m.com.allFinite() && m.inertia.allFinite() && m.R_MP.allFinite());
}

TEST(Mass, inside_out_has_negative_volume_and_the_same_inertia) {
  Soup soup = soup_of(test::box({1, 2, 3}));
  for (Triangle& t : soup.triangles) std::swap(t[0], t[1]);
  const MassProperties m = mass_by_volume(soup);
  EXPECT_NEAR(m.measure, -6, 1e-14);
  expect_near(m.inertia, Vec3(5, 10, 13) / 12, 1e-14);
}

// Where two inertias agree the axes are the mesh's own, projected: rounding noise must not show.
TEST(Mass, equal_inertias_give_canonical_axes) {
  std::mt19937_64 random(3);
  Mat3 axes;
  axes << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // z, x, y
  for (int i = 0; i < 20; ++i) {
    Soup prism = soup_of(test::box({1, 1, 3}));
    for (Vec3& x : prism.vertices) x += test::random_in_ball(random, 1e-13);
    const MassProperties m = mass_by_volume(prism);
    EXPECT_LE((m.R_MP - axes).norm(), 1e-11);
    EXPECT_EQ(m.inertia[1], m.inertia[2]);
    Soup plate = soup_of(test::box({2, 2, 1}));
    for (Vec3& x : plate.vertices) x += test::random_in_ball(random, 1e-13);
    const MassProperties p = mass_by_volume(plate);
    EXPECT_LE((p.R_MP - Mat3::Identity()).norm(), 1e-11);
    EXPECT_EQ(p.inertia[0], p.inertia[1]);
  }
}

// Reference: the closed form of two boxes apart from each other, of which one is given by its
// moments about another place.
TEST(Mass, moments_are_added_to_those_of_the_triangles) {
  const Soup box = soup_of(test::box({2, 4, 6}));
  const Vec3 away(10, 1, 2), origin(3, -2, 5);
  MassMoments more;
  more.origin = origin;
  more.measure = 8;  // a cube of side 2
  const Vec3 middle = away - origin;
  more.first = 8 * middle;
  more.second = 8 * (middle * middle.transpose() + Mat3(Vec3::Constant(4.0 / 12).asDiagonal()));
  const MassProperties mass = mass_by_volume(box, {}, more);
  EXPECT_NEAR(mass.measure, 56, 1e-12);
  EXPECT_LT((mass.com - away * 8 / 56).norm(), 1e-13);
  const Soup both = soup_of(test::joined(test::box({2, 4, 6}), test::box({2, 2, 2}), away));
  expect_near(mass.inertia, mass_by_volume(both).inertia, 1e-12);
}

}  // namespace
}  // namespace sonde
