// SPDX-License-Identifier: GPL-3.0-or-later
// The one source of the tests that sees CGAL.
#include "tests/support/exact_reference.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sonde::test {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Kernel>
struct Shape {
  std::array<typename Kernel::Point_3, 3> corner;
  explicit Shape(const Corners& t)
      : corner{typename Kernel::Point_3(t[0].x(), t[0].y(), t[0].z()),
               typename Kernel::Point_3(t[1].x(), t[1].y(), t[1].z()),
               typename Kernel::Point_3(t[2].x(), t[2].y(), t[2].z())} {}
  typename Kernel::Segment_3 edge(std::size_t i) const { return {corner[i], corner[(i + 1) % 3]}; }
  typename Kernel::Triangle_3 face() const { return {corner[0], corner[1], corner[2]}; }
  /// Corners in one line: the three edges are all that there is of it.
  bool flat() const { return CGAL::collinear(corner[0], corner[1], corner[2]); }
};

/// Either may be a point.
bool segments_meet(const Predicates::Segment_3& s, const Predicates::Segment_3& t) {
  if (s.is_degenerate()) return t.is_degenerate() ? s.source() == t.source() : t.has_on(s.source());
  return t.is_degenerate() ? s.has_on(t.source()) : CGAL::do_intersect(s, t);
}

bool an_edge_meets(const Shape<Predicates>& a, const Shape<Predicates>& b, bool b_is_flat) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto s = a.edge(i);
    if (b_is_flat) {
      for (std::size_t j = 0; j < 3; ++j)
        if (segments_meet(s, b.edge(j))) return true;
    } else if (s.is_degenerate() ? b.face().has_on(s.source()) : CGAL::do_intersect(s, b.face())) {
      return true;
    }
  }
  return false;
}

/// The double nearest to an exact number, or next to it.
double value(const Exact::FT& x) {
  const auto close = [](const std::pair<double, double>& i) {
    return i.second - i.first <= 1e-13 * std::abs(i.first);
  };
  auto interval = CGAL::to_interval(x);
  if (!close(interval)) interval = CGAL::to_interval(x.exact());
  return interval.first + (interval.second - interval.first) / 2;
}

/// A lower bound of the distance: the gap along some direction, less its rounding. True whatever
/// the direction; where closest_points is right, nearly the distance.
double lower_bound(const Corners& a, const Corners& b) {
  const ClosestPoints c = closest_points(a, b);
  if (!(c.distance > 0)) return 0;
  const Vec3 n = (c.a - c.b).normalized();
  double size = 0;
  for (const Corners* t : {&a, &b})
    for (const Vec3& x : *t) size = std::max(size, x.cwiseAbs().maxCoeff());
  return (gap_along(n, a, b) - 1e-14 * size) * (1 - 1e-9);
}

bool boxes_meet(const Placed& a, std::size_t i, const Placed& b, std::size_t j) {
  return (a.low[i].array() <= b.high[j].array()).all() &&
         (b.low[j].array() <= a.high[i].array()).all();
}

}  // namespace

bool meet_by_edges(const Corners& a, const Corners& b) {
  const Shape<Predicates> sa(a), sb(b);
  return an_edge_meets(sa, sb, sb.flat()) || an_edge_meets(sb, sa, sa.flat());
}

double exact_distance(const Corners& a, const Corners& b) {
  if (meet_by_edges(a, b)) return 0;
  const Shape<Exact> sa(a), sb(b);
  double squared = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Exact::FT& x) { squared = std::min(squared, value(x)); };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) offer(CGAL::squared_distance(sa.edge(i), sb.edge(j)));
  if (!sb.flat())
    for (const auto& x : sa.corner) offer(CGAL::squared_distance(x, sb.face()));
  if (!sa.flat())
    for (const auto& x : sb.corner) offer(CGAL::squared_distance(x, sa.face()));
  return std::sqrt(squared);
}

double exact_gap_along(const Vec3& n, const Corners& a, const Corners& b) {
  const auto height = [&](const Vec3& x) {
    return Exact::FT(n.x()) * Exact::FT(x.x()) + Exact::FT(n.y()) * Exact::FT(x.y()) +
           Exact::FT(n.z()) * Exact::FT(x.z());
  };
  const Exact::FT low = std::min({height(a[0]), height(a[1]), height(a[2])});
  const Exact::FT high = std::max({height(b[0]), height(b[1]), height(b[2])});
  return value(low - high) / n.norm();
}

Placed::Placed(const Body& body, const Transform& X) : triangles(placed_triangles(body, X)) {
  for (const Corners& t : triangles) {
    low.emplace_back(t[0].cwiseMin(t[1]).cwiseMin(t[2]));
    high.emplace_back(t[0].cwiseMax(t[1]).cwiseMax(t[2]));
  }
}

bool any_meet(const Placed& a, const Placed& b) {
  for (std::size_t i = 0; i < a.triangles.size(); ++i)
    for (std::size_t j = 0; j < b.triangles.size(); ++j)
      if (boxes_meet(a, i, b, j) && meet_by_edges(a.triangles[i], b.triangles[j])) return true;
  return false;
}

double below_distance_of_boxes(const Placed& a, std::size_t i, const Placed& b, std::size_t j) {
  const Vec3 out = (a.low[i] - b.high[j]).cwiseMax(b.low[j] - a.high[i]).cwiseMax(0.0);
  return out.norm() * (1 - 1e-9);
}

double least_exact_distance(const Placed& a, const Placed& b) {
  struct Item {
    double bound;
    std::size_t i, j;
  };
  std::vector<Item> items;
  for (std::size_t i = 0; i < a.triangles.size(); ++i)
    for (std::size_t j = 0; j < b.triangles.size(); ++j)
      items.push_back({below_distance_of_boxes(a, i, b, j), i, j});
  const auto nearer_first = [](const Item& x, const Item& y) { return x.bound > y.bound; };
  std::make_heap(items.begin(), items.end(), nearer_first);
  double best = std::numeric_limits<double>::infinity();
  while (!items.empty() && best > 0 && items.front().bound < best) {
    const Corners &ta = a.triangles[items.front().i], &tb = b.triangles[items.front().j];
    if (lower_bound(ta, tb) < best) best = std::min(best, exact_distance(ta, tb));
    std::pop_heap(items.begin(), items.end(), nearer_first);
    items.pop_back();
  }
  return best;
}

bool apart_by(const Placed& a, const Placed& b, double distance) {
  for (std::size_t i = 0; i < a.triangles.size(); ++i)
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      if (below_distance_of_boxes(a, i, b, j) >= distance) continue;
      const Corners &ta = a.triangles[i], &tb = b.triangles[j];
      if (lower_bound(ta, tb) < distance && exact_distance(ta, tb) < distance) return false;
    }
  return true;
}

}  // namespace sonde::test
