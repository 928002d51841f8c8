// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/mending/edge_uses.hpp"

namespace sonde {

/// How open edges are joined. A crack is closed by index only: no coordinate changes, so the
/// contact surface stays the same.
struct SeamTuning {
  /// Share of the diagonal of the soup's box: largest distance of corners of open edges from each
  /// other, or from an open edge that they lie on, for joining. Tried in this order, each from the
  /// original soup: a step is kept only if it shortens the border of the best one before by a
  /// fifth. The last value is ten times the rounding of a file with six digits; larger gaps stay
  /// open.
  double reaches[4] = {0, 1e-7, 1e-6, 1e-5};
  /// Times the last reach: tried in this order where that has joined some corners and left others
  /// open, since errors of about its size make half a body. Such a step is kept only if it closes
  /// everything, or if one `further` times as wide finds nothing more: then all the cracks are
  /// narrower than it, and what stays open is far wider.
  double wider[2] = {3, 10};
  double further = 3;
  /// Share of the largest coordinate: distance by which rounding to single precision separates
  /// equal points. Far from the origin it exceeds the last reach and replaces it. It is limited to
  /// `farthest_rounding` of the diagonal.
  double single_precision = 2.1e-7;
  double farthest_rounding = 1e-3;
  double shorter = 0.8;
  /// Share of the shortest open edge at a corner: a larger reach would close features of that size.
  double of_edge = 0.2;
  /// The same for the wider reaches, which must be well below all features.
  double of_edge_wider = 0.02;
  /// Share of the diagonal: tolerance for a point on an edge, from the rounding of coordinates.
  double rounding = 1e-12;
  /// Corners on edges are searched for only if at most this many edges, or a tenth of all, are
  /// open: more are no cracks in a surface, but loose triangles. Counted in Seams::unsearched.
  std::size_t most_open = 20'000;
};
inline constexpr SeamTuning seam_tuning;

/// Which corners of open edges belong together.
struct Seams {
  /// For each vertex its representative: itself if it is alone.
  std::vector<std::uint32_t> label;
  /// All uses of edges between labels, sorted. An open edge with corners on it is split there, and
  /// has a use for each piece.
  std::vector<EdgeUse> uses;
  /// A side (3 i + k) that is split, and the labels on it in its own direction. Ascending by side.
  struct Cut {
    std::uint32_t side;
    std::vector<std::uint32_t> at;
  };
  std::vector<Cut> cuts;
  std::size_t joined = 0;      ///< vertices with another representative
  std::size_t on_edges = 0;    ///< corners found on open edges (T-junctions)
  double reach = 0;            ///< m, up to which corners were joined
  std::size_t unsearched = 0;  ///< open edges not searched for corners
};

/// `uses` are all those of the soup (edge_uses). An edge with an odd number of uses is open. Throws
/// Cancelled.
Seams find_seams(const Soup& soup, const std::vector<EdgeUse>& uses, const Progress& progress = {});

/// What the seams of a soup are judged by, if it is not known yet which of its triangles stay.
struct SeamJudge {
  /// Whether an edge, with these uses, may be joined with others and cut.
  std::function<bool(std::span<const EdgeUse>)> open;
  /// m: the border that is left, given the uses of the edges that may be joined.
  std::function<double(const std::vector<EdgeUse>&)> border;
};

/// The same by that judge. Corners that lie exactly on open edges cut them, if that shortens the
/// border at all.
Seams find_seams(const Soup& soup, const std::vector<EdgeUse>& uses, const SeamJudge& judge,
                 const Progress& progress = {});

}  // namespace sonde
