// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/separating_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {
namespace {

Corners random_triangle(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Corners out;
  for (Vec3& corner : out)
    for (double& x : corner) x = normal(random);
  return out;
}

OtherAxes every_axis(const Corners& a, const Corners& b) {
  return other_axes(a, b, Vec3::Zero(), -std::numeric_limits<double>::infinity());
}

/// The axes of the theorem written out: two normals and nine products of edges.
double largest_gap(const Corners& a, const Corners& b) {
  std::vector<Vec3> axes{area_normal(a), area_normal(b)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      axes.push_back((a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]));
  double out = -std::numeric_limits<double>::infinity();
  for (const Vec3& axis : axes) {
    const Vec3 n = axis.normalized();
    out = std::max({out, gap_along(n, a, b), gap_along(-n, a, b)});
  }
  return out;
}

double largest_of(const OtherAxes& axes) {
  double out = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < axes.size; ++i) out = std::max(out, axes.items[i].gap);
  return out;
}

// Reference: CGAL's exact predicate; triangles in general position are apart exactly if an axis of
// the theorem separates them.
TEST(SeparatingAxes, one_of_them_separates_what_is_apart_and_none_what_meets) {
  std::mt19937_64 random(3);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Corners a = random_triangle(random), b = random_triangle(random);
    apart += !meet_exactly(a, b);
    EXPECT_EQ(largest_gap(a, b) > 0, !meet_exactly(a, b)) << i;
    EXPECT_EQ(largest_of(every_axis(a, b)) > 0, !meet_exactly(a, b)) << i;
  }
  EXPECT_GT(apart, 500);
  EXPECT_LT(apart, 1900);
}

TEST(SeparatingAxes, parallel_edges_and_triangles_without_area_give_no_zero_axis) {
  const Corners flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
      needle{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(2, 0, 1)};
  const OtherAxes axes = every_axis(flat, needle);
  EXPECT_GE(axes.size, 2u) << "both sides of the one face";
  for (std::size_t i = 0; i < axes.size; ++i) {
    EXPECT_NEAR(std::abs(axes.items[i].normal.z()), 1, 1e-12) << "both lie across z";
    EXPECT_NEAR(std::abs(axes.items[i].gap), 1, 1e-12);
  }
}

// Reference: by hand. A corner above a face, near one of its edges, past which A goes on downwards:
// A's edge and the face's are apart by √2 · 10⁻⁶ along (1, 0, 1).
TEST(SeparatingAxes, a_corner_beside_an_edge_is_apart_along_others_than_the_face_s_normal) {
  const Corners face{Vec3(-1, -1, 0), Vec3(0, -1, 0), Vec3(0, 1, 0)};  // an edge along x = 0
  const Corners corner{Vec3(-1e-6, 0, 3e-6), Vec3(1, 0.2, -1), Vec3(1, 0, 1)};
  const OtherAxes others = other_axes(corner, face, Vec3::UnitZ(), 1e-6);
  ASSERT_GT(others.size, 0u);
  double nearest = 1;
  for (std::size_t i = 0; i < others.size; ++i) {
    const Contact& other = others.items[i];
    EXPECT_GE(other.gap, 1e-6);
    EXPECT_NEAR(other.gap, gap_along(other.normal, corner, face), 1e-15);
    EXPECT_NEAR((other.on_probe - other.on_fixed - other.gap * other.normal).norm(), 0, 1e-15);
    EXPECT_LT(other.normal.z(), 1 - 1e-6);
    nearest = std::min(nearest, (other.normal - Vec3(1, 0, 1).normalized()).norm());
    if (nearest < 1e-5) {
      EXPECT_NEAR(other.gap, std::sqrt(2) * 1e-6, 1e-11);
      EXPECT_NEAR(other.on_fixed.x(), 0, 1e-15) << "on the face's edge";
    }
  }
  EXPECT_LT(nearest, 1e-5);
  EXPECT_EQ(other_axes(corner, face, Vec3::UnitZ(), 4e-6).size, 0u) << "none by more than it is";
}

}  // namespace
}  // namespace sonde
