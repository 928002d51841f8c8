// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The repairs that gave a mesh an inside. No coordinate is ever moved.
struct Repairs {
  std::size_t joined = 0;      ///< corners of open edges that count as one with another
  double reach = 0;            ///< m: largest distance of joined corners, and of corners on edges
  std::size_t on_edges = 0;    ///< corners that lie on an edge and cut it (T-junctions)
  std::size_t unsearched = 0;  ///< open edges not searched for corners: too many are open
  std::size_t repeated = 0;    ///< triangles with the corners of others, counted once
  std::size_t turned_triangles = 0;  ///< to agree with their neighbours
  std::size_t turned_parts = 0;      ///< whole parts that were inside out
  std::size_t caps = 0;              ///< openings closed, in parts that count as solid
  std::size_t cap_triangles = 0;     ///< their triangles, which take part in contact and count
  double cap_area = 0;               ///< m²
  double widest_cap = 0;             ///< largest share of one cap in a part as seen from all around
  std::size_t parts = 0;             ///< number of parts that are closed, once mended
  std::size_t solid_parts = 0;       ///< number of parts whose inside counts
  std::size_t torn_parts = 0;        ///< number of parts that are not two-sided (non-orientable)
  std::size_t hidden = 0;            ///< triangles inside, where nothing can touch them: left out
  /// For the largest part that is no solid: its widest opening, as a share of what is seen from all
  /// around; 0 if there is no such part.
  double widest_mouth = 0;
  bool could_be_solid = false;  ///< once closed, that part mostly bounds an inside
  bool overlaps = false;        ///< parts overlap, or one crosses itself: counted once
  /// Relative error of the mass due to overlaps; 0 if it is exact.
  double overlap_error = 0;
  /// Parts cross in more places than can be looked at: how exact the mass is, is not known.
  bool overlap_unknown = false;

  /// Whether anything was repaired.
  bool any() const {
    return joined + on_edges + repeated + turned_triangles + turned_parts + caps + hidden > 0 ||
           overlaps;
  }
};

}  // namespace sonde
