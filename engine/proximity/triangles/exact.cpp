// SPDX-License-Identifier: GPL-3.0-or-later
// The only source of the proximity queries that includes CGAL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>

#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_3 point(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

bool collinear(const Corners& t) { return CGAL::collinear(point(t[0]), point(t[1]), point(t[2])); }

/// The longest edge of a triangle with collinear corners, which equals the whole triangle.
Kernel::Segment_3 longest_edge(const Corners& t) {
  int best = 0;
  double longest = -1;
  for (int i = 0; i < 3; ++i) {
    const double length =
        (t[static_cast<std::size_t>((i + 1) % 3)] - t[static_cast<std::size_t>(i)]).squaredNorm();
    if (length > longest) longest = length, best = i;
  }
  return {point(t[static_cast<std::size_t>(best)]),
          point(t[static_cast<std::size_t>((best + 1) % 3)])};
}

Kernel::Triangle_3 triangle(const Corners& t) { return {point(t[0]), point(t[1]), point(t[2])}; }
}  // namespace

bool meet_exactly(const Corners& a, const Corners& b) {
  // Rounding a placed needle can make its corners exactly collinear. CGAL requires triangles with
  // an area, so such a triangle is tested as the segment that it is.
  const bool line_a = collinear(a);
  const bool line_b = collinear(b);
  if (line_a && line_b) {
    const auto s = longest_edge(a), t = longest_edge(b);
    if (s.is_degenerate())
      return t.is_degenerate() ? s.source() == t.source() : t.has_on(s.source());
    if (t.is_degenerate()) return s.has_on(t.source());
    return CGAL::do_intersect(s, t);
  }
  if (line_a || line_b) {
    const auto s = longest_edge(line_a ? a : b);
    const auto t = triangle(line_a ? b : a);
    return s.is_degenerate() ? t.has_on(s.source()) : CGAL::do_intersect(t, s);
  }
  return CGAL::do_intersect(triangle(a), triangle(b));
}

}  // namespace sonde
