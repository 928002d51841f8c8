// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The corners of a solid: at each vertex, the triangles that go round one corner of the material.
/// Where two parts touch at a vertex or along an edge, the vertex has a corner of each.
struct Fans {
  std::vector<std::array<std::uint32_t, 3>> of;  ///< of each triangle's corners, 0 .. count − 1
  std::vector<std::uint32_t> vertex;             ///< of each fan
  /// Triangles on whose edge a fan's vertex lies without being a corner of them (an edge that is
  /// cut on one of its sides alone): fan and triangle.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> beside;

  std::size_t count() const { return vertex.size(); }
};

/// The fans of a soup with one vertex for each place, counter-clockwise seen from outside. At an
/// edge of more than two triangles, those go together that have material between them. Within
/// `flatness` (m) of an edge is on it. Throws Cancelled.
Fans find_fans(const Soup& soup, double flatness, const Progress& progress = {});

/// For each triangle, the piece that it belongs to (0, 1, ...): what hangs together by fans.
std::vector<std::uint32_t> pieces_of(const Fans& fans);

/// Disjoint sets of 0 .. n − 1, each known by its least member.
class Sets {
 public:
  explicit Sets(std::size_t n);
  std::uint32_t of(std::uint32_t i);
  /// Returns whether they were two.
  bool join(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace sonde
