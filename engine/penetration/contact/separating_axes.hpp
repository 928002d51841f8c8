// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// Calls visit(axis, i, j) for the cross products of edges i of A and j of B, not unit, until it
/// returns true. Edges that are nearly parallel (ContactTuning::parallel_edges) give none.
template <class Visit>
bool any_edges(const Corners& a, const Corners& b, const Visit& visit) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 u = edge_of(a, i), v = edge_of(b, j), axis = u.cross(v);
      if (axis.norm() > contact_tuning.parallel_edges * u.norm() * v.norm() && visit(axis, i, j))
        return true;
    }
  return false;
}

/// The corner with the least n·x.
inline const Vec3& lowest_corner(const Corners& t, const Vec3& n) {
  return *std::min_element(t.begin(), t.end(),
                           [&](const Vec3& x, const Vec3& y) { return n.dot(x) < n.dot(y); });
}

/// The point of A whose motion changes the gap along n. n (unit) is perpendicular to edge i of A
/// and edge j of B; `axis` is their cross product. If A's extreme edge along n is edge i and B's is
/// edge j, it is the point of A's line nearest to B's line. If A's extreme feature is another one,
/// it is A's lowest corner. No value if only A's edge is extreme.
std::optional<Vec3> point_between_edges(const Corners& a, std::size_t i, const Corners& b,
                                        std::size_t j, const Vec3& axis, const Vec3& n,
                                        double gap) noexcept;

/// Contacts of A and B along their separating axes: at most both directions of eleven axes.
struct OtherAxes {
  std::array<Contact, 22> items;
  std::size_t size = 0;
};
/// The axes along which A and B are apart by at least `least`, m, except one that is parallel to
/// `normal` (unit, from B to A). The points of a contact are those whose motion changes its gap:
/// for a corner and a face, the corner and its foot point; for two edges, the nearest points of
/// their lines. See point_between_edges() for pairs of edges that give none.
OtherAxes other_axes(const Corners& a, const Corners& b, const Vec3& normal, double least) noexcept;

}  // namespace sonde
