// SPDX-License-Identifier: GPL-3.0-or-later
// Reference for boxes along the axes: what they do not fill is a grid of boxes too, and the
// distance to each of these is a formula. Rotated, it is the same. For balls: the sphere of either,
// or the circle in which they cross.
#include "engine/proximity/queries/covered.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/ray_hit.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

struct AxesBox {
  Vec3 low, high;
  double distance(const Vec3& x) const { return (x - x.cwiseMax(low).cwiseMin(high)).norm(); }
  bool holds(const Vec3& x) const {
    return (x.array() > low.array()).all() && (x.array() < high.array()).all();
  }
};
using BoxList = std::vector<AxesBox>;

/// The grid of all planes of the boxes: those of its cells that none of them fills.
BoxList cells_outside(const BoxList& boxes) {
  std::array<std::vector<double>, 3> planes;
  for (int k = 0; k < 3; ++k) {
    std::set<double> at{-endless, endless};
    for (const AxesBox& box : boxes) at.insert({box.low[k], box.high[k]});
    planes[static_cast<std::size_t>(k)].assign(at.begin(), at.end());
  }
  const auto middle = [](double a, double b) {
    return std::isinf(a) ? b - 1 : std::isinf(b) ? a + 1 : 0.5 * (a + b);
  };
  BoxList out;
  for (std::size_t i = 1; i < planes[0].size(); ++i)
    for (std::size_t j = 1; j < planes[1].size(); ++j)
      for (std::size_t k = 1; k < planes[2].size(); ++k) {
        const AxesBox cell{{planes[0][i - 1], planes[1][j - 1], planes[2][k - 1]},
                           {planes[0][i], planes[1][j], planes[2][k]}};
        Vec3 at;
        for (int m = 0; m < 3; ++m) at[m] = middle(cell.low[m], cell.high[m]);
        if (std::ranges::none_of(boxes, [&](const AxesBox& b) { return b.holds(at); }))
          out.push_back(cell);
      }
  return out;
}

double least_distance(const BoxList& boxes, const Vec3& x) {
  double least = endless;
  for (const AxesBox& box : boxes) least = std::min(least, box.distance(x));
  return least;
}

/// Where a line is in a box; empty where the first number is not less.
std::array<double, 2> span_of(const AxesBox& box, const Vec3& from, const Vec3& along) {
  const Vec3 a = (box.low - from).cwiseQuotient(along), b = (box.high - from).cwiseQuotient(along);
  return {a.cwiseMin(b).maxCoeff(), a.cwiseMax(b).minCoeff()};
}

/// Where a ray first enters what the boxes fill together, or leaves it if it begins there.
double first_border(const BoxList& boxes, const Vec3& from, const Vec3& along) {
  std::vector<std::array<double, 2>> spans;
  for (const AxesBox& box : boxes) {
    const auto span = span_of(box, from, along);
    if (span[0] < span[1] && span[1] > 0) spans.push_back(span);
  }
  std::ranges::sort(spans);
  if (spans.empty()) return endless;
  if (spans[0][0] > 0) return spans[0][0];
  double end = 0;
  for (const auto& span : spans)
    if (span[0] <= end) end = std::max(end, span[1]);
  return end;
}

/// A box with each face cut into n × n squares.
void add_box(PolygonSoup& out, const AxesBox& box, std::size_t n) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true})
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          Polygon face;
          for (const auto& [du, dv] : {std::array<std::size_t, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            Vec3 x = high ? box.high : box.low;
            const auto at = [&](int k, std::size_t step) {
              return step == n
                         ? box.high[k]
                         : box.low[k] + (box.high[k] - box.low[k]) * static_cast<double>(step) /
                                            static_cast<double>(n);
            };
            x[u] = at(u, i + du), x[v] = at(v, j + dv);
            face.push_back(out.points.size());
            out.points.push_back(x);
          }
          if (!high) std::ranges::reverse(face);
          out.polygons.push_back(face);
        }
}

PolygonSoup soup_of(const BoxList& boxes, std::size_t n, const Quat& q) {
  PolygonSoup out;
  for (const AxesBox& box : boxes) add_box(out, box, n);
  for (Vec3& x : out.points) x = q * x;
  return out;
}

AxesBox cube_at(const Vec3& x, double half = 0.5) {
  return {x - Vec3::Constant(half), x + Vec3::Constant(half)};
}

/// BoxList that overlap: two cubes, a cross, one within another, flush ones, ones that only share a
/// wall, and many small ones on a large one.
std::vector<BoxList> overlapping() {
  std::vector<BoxList> out;
  out.push_back({cube_at(Vec3::Zero()), cube_at({0.6, 0.1, 0.05})});
  out.push_back({{{-2, -0.3, -0.2}, {2, 0.3, 0.2}},
                 {{-0.3, -2, -0.25}, {0.3, 2, 0.15}},
                 {{-0.2, -0.25, -1}, {0.25, 0.2, 1}}});
  out.push_back({cube_at(Vec3::Zero()), cube_at({0.1, 0.05, 0}, 0.2)});
  out.push_back(
      {{{0, 0, 0}, {1, 1, 1}}, {{0.5, 0, 0}, {2, 1, 1}}, {{0.25, 0.25, 0.5}, {0.75, 0.75, 1}}});
  out.push_back({{{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}, {{0, 1, 0.25}, {1, 2, 0.75}}});
  BoxList many{{{-1, -1, -0.2}, {1, 1, 0.2}}};
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j)
      many.push_back(cube_at({0.25 * i, 0.25 * j, 0.15}, 0.1 + 0.01 * i));
  out.push_back(many);
  return out;
}

TEST(Covered, the_nearest_point_of_boxes_that_overlap_is_that_of_what_they_fill_together) {
  std::mt19937_64 random(11);
  int within = 0, moved = 0;
  for (const BoxList& boxes : overlapping())
    for (const std::size_t n : {1, 3}) {
      const BoxList around = cells_outside(boxes);
      for (const bool turned : {false, true}) {
        const Quat q = turned ? test::random_rotation(random) : Quat(Quat::Identity());
        const auto body = test::body(soup_of(boxes, n, q), Model::solid);
        for (int i = 0; i < 200; ++i) {
          const Vec3 x = test::random_in_ball(random, 1.5);
          const double out = least_distance(boxes, x), in = least_distance(around, x);
          const NearestPoint found = nearest_outside(*body, q * x);
          EXPECT_NEAR(found.distance, std::max(in, out), 1e-9) << x.transpose() << " " << n;
          EXPECT_NEAR((found.point - q * x).norm(), found.distance, 1e-12);
          EXPECT_EQ(winds_around(*body, q * x), out == 0);
          within += in > 0;
          moved += nearest_point(*body, q * x, 0).distance < found.distance - 1e-6;
        }
      }
    }
  EXPECT_GT(within, 200);
  EXPECT_GT(moved, 50) << "a wall within was nearer";
}

TEST(Covered, a_ray_meets_boxes_that_overlap_where_it_enters_or_leaves_them_all) {
  std::mt19937_64 random(12);
  int hits = 0, through = 0;
  for (const BoxList& boxes : overlapping())
    for (const std::size_t n : {1, 3}) {
      const Quat q = test::random_rotation(random);
      for (const Quat& turn : {Quat(Quat::Identity()), q}) {
        const auto body = test::body(soup_of(boxes, n, turn), Model::solid);
        for (int i = 0; i < 200; ++i) {
          const Vec3 from = test::random_in_ball(random, 1.5);
          const Vec3 along = test::random_in_ball(random, 1).normalized();
          const double expected = first_border(boxes, from, along);
          const auto found = first_hit(*body, turn * from, turn * along);
          ASSERT_EQ(found.has_value(), expected < endless) << i;
          if (!found) continue;
          EXPECT_NEAR(found->distance, expected, 1e-9) << from.transpose();
          ++hits;
          through +=
              ray_hit(surface(*body), turn * from, turn * along)->distance < found->distance - 1e-6;
        }
      }
    }
  EXPECT_GT(hits, 500);
  EXPECT_GT(through, 100);
}

// Rays along the axes run in the planes of walls, and points in the middle are as far from several.
TEST(Covered, what_is_along_walls_is_told_too) {
  const BoxList boxes{cube_at(Vec3::Zero()), cube_at({0.6, 0.1, 0.05})};
  const auto body = test::body(soup_of(boxes, 1, Quat::Identity()), Model::solid);
  // The edge at which the second cube comes out of the first one's side.
  EXPECT_NEAR(nearest_outside(*body, {0.12, 0.05, 0}).distance, std::hypot(0.02, 0.45), 1e-9);
  EXPECT_NEAR(nearest_outside(*body, {0.1, 0, 0}).distance, 0.5, 1e-9);
  EXPECT_NEAR(first_hit(*body, {-0.2, 0.05, 0}, Vec3::UnitX())->distance, 1.3, 1e-12);
  EXPECT_NEAR(first_hit(*body, {-0.2, 0.05, 0.05}, Vec3::UnitX())->distance, 1.3, 1e-12);
  EXPECT_NEAR(first_hit(*body, {-2, 0.05, 0}, Vec3::UnitX())->distance, 1.5, 1e-12);
  EXPECT_NEAR(first_hit(*body, {2, 0.05, 0}, -Vec3::UnitX())->distance, 0.9, 1e-12);
}

TEST(Covered, balls_that_overlap_are_one) {
  std::mt19937_64 random(13);
  for (const double apart : {0.3, 0.8, 1.4}) {
    const double r = 1, s = 0.7;
    const auto rings = static_cast<int>(64);
    PolygonSoup soup = test::sphere(r, rings, 2 * rings);
    const PolygonSoup other = test::sphere(s, rings, 2 * rings);
    const std::size_t first = soup.points.size();
    for (const Vec3& x : other.points) soup.points.push_back(x + Vec3(apart, 0, 0));
    for (Polygon polygon : other.polygons) {
      for (std::size_t& corner : polygon) corner += first;
      soup.polygons.push_back(polygon);
    }
    const auto body = test::body(soup, Model::solid);
    // The circle of the crossing.
    const double at = (apart * apart + r * r - s * s) / (2 * apart);
    const double rim = std::sqrt(std::max(0.0, r * r - at * at));
    const double rounding = 2e-3;  // by which chords fall short
    for (int i = 0; i < 60; ++i) {
      const Vec3 x = test::random_in_ball(random, 1.5);
      const Vec3 c(apart, 0, 0);
      const bool within = x.norm() < r || (x - c).norm() < s;
      double expected = std::min(std::abs(x.norm() - r), std::abs((x - c).norm() - s));
      if (within) {
        const double across = x.tail<2>().norm();
        const Vec3 of_first = r * x.normalized(), of_other = c + s * (x - c).normalized();
        expected = apart + s <= r ? endless : std::hypot(x.x() - at, across - rim);
        if ((of_first - c).norm() > s) expected = std::min(expected, r - x.norm());
        if (of_other.norm() > r) expected = std::min(expected, s - (x - c).norm());
      }
      const double found = nearest_outside(*body, x).distance;
      if (std::abs(x.norm() - r) < 0.01 || std::abs((x - c).norm() - s) < 0.01) continue;
      EXPECT_NEAR(found, expected, 3 * rounding) << apart << ": " << x.transpose();
    }
  }
}

// A surface has no inside: all its triangles count, wherever they are.
TEST(Covered, of_surfaces_nothing_is_covered) {
  const BoxList boxes{cube_at(Vec3::Zero()), cube_at({0.6, 0.1, 0.05})};
  const auto body = test::body(soup_of(boxes, 2, Quat::Identity()), Model::surface);
  EXPECT_NEAR(nearest_outside(*body, {0.12, 0.05, 0}).distance, 0.02, 1e-12);
  EXPECT_NEAR(first_hit(*body, {-0.2, 0.05, 0}, Vec3::UnitX())->distance, 0.3, 1e-12);
}

}  // namespace
}  // namespace sonde
