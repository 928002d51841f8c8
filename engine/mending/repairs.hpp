// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// What was done to a mesh so that it has an inside. No coordinate is ever moved.
struct Repairs {
  std::size_t joined = 0;      ///< corners of open edges that count as one with another
  double reach = 0;            ///< m: joined corners, and corners on edges, are no further apart
  std::size_t on_edges = 0;    ///< corners that lie on an edge and cut it (T-junctions)
  std::size_t unsearched = 0;  ///< open edges on which none were looked for: too many are open
  std::size_t repeated = 0;    ///< triangles with the corners of others, counted once
  std::size_t turned_triangles = 0;  ///< to agree with their neighbours
  std::size_t turned_parts = 0;      ///< whole parts that were inside out
  std::size_t caps = 0;              ///< openings closed, in parts that count as solid
  std::size_t cap_triangles = 0;     ///< the triangles of these, which collide and count
  double cap_area = 0;               ///< m²
  double widest_cap = 0;        ///< of a part as it is seen from all around, the widest one's share
  std::size_t parts = 0;        ///< closed by themselves, once mended
  std::size_t solid_parts = 0;  ///< of these, whose inside counts
  std::size_t torn_parts = 0;   ///< that have no two sides (non-orientable)
  std::size_t hidden = 0;       ///< triangles inside, where nothing touches them: left out
  /// Of the parts that are no solids, the largest's widest opening, as its share of what is seen
  /// from all around; 0 where there is none.
  double widest_mouth = 0;
  bool could_be_solid = false;  ///< that part, once it is closed, mostly bounds an inside
  bool overlaps = false;        ///< parts overlap, or one crosses itself: counted once
  /// Of the mass of what overlaps, relative to it; 0 where it is exact.
  double overlap_error = 0;

  /// Whether anything was done at all.
  bool any() const {
    return joined + on_edges + repeated + turned_triangles + turned_parts + caps + hidden > 0 ||
           overlaps;
  }
};

}  // namespace sonde
