// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/mending/edge_uses.hpp"

namespace sonde {

/// How open edges are brought together. A crack is closed by name alone: no coordinate changes, so
/// nothing that is felt moves.
struct SeamTuning {
  /// Of the diagonal of the soup's box: how far corners of open edges may be apart, or from an open
  /// edge that they lie on, to count as joined. Tried in this order, each from the soup as it is: a
  /// step is kept only where it shortens the border of the best before it by a fifth. The last one
  /// is ten times the rounding of a file with six digits; what is further apart stays open.
  double reaches[4] = {0, 1e-7, 1e-6, 1e-5};
  /// Of the largest coordinate: how far apart rounding to single precision puts what was one place.
  /// Far from the origin this is more than the last reach, and takes its place. Of the diagonal,
  /// it is never more than `farthest_rounding`.
  double single_precision = 2.1e-7;
  double farthest_rounding = 1e-3;
  double shorter = 0.8;
  /// Of the shortest open edge there: a reach beyond would close what is drawn that small.
  double of_edge = 0.2;
  /// Of the diagonal: what lies on an edge but for the rounding of its coordinates.
  double rounding = 1e-12;
  /// Corners on edges are looked for where at most so many edges, or a tenth of all, are open:
  /// more are no cracks in a surface, but loose triangles. Counted in Seams::unsearched.
  std::size_t most_open = 20'000;
};
inline constexpr SeamTuning seam_tuning;

/// Which corners of open edges belong together.
struct Seams {
  /// For each vertex the one that stands for it, itself where it is alone.
  std::vector<std::uint32_t> label;
  /// All uses of edges between labels, sorted. An open edge that corners lie on is cut at them: it
  /// has a use for each piece.
  std::vector<EdgeUse> uses;
  /// A side (3 i + k) that is cut, and the labels on it in its own direction. Ascends by side.
  struct Cut {
    std::uint32_t side;
    std::vector<std::uint32_t> at;
  };
  std::vector<Cut> cuts;
  std::size_t joined = 0;      ///< vertices that another one stands for
  std::size_t on_edges = 0;    ///< corners found on open edges (T-junctions)
  double reach = 0;            ///< m, up to which corners are joined
  std::size_t unsearched = 0;  ///< open edges on which no corners were looked for
};

/// `uses` are all those of the soup (edge_uses). Open is an edge of an odd number of them. Throws
/// Cancelled.
Seams find_seams(const Soup& soup, const std::vector<EdgeUse>& uses, const Progress& progress = {});

}  // namespace sonde
