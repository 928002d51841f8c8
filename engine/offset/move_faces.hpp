// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/face_offset.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/offset/fans.hpp"

namespace sonde {

/// A soup with its faces elsewhere.
struct MovedFaces {
  Soup soup;                        ///< one vertex for each place, no degenerate triangle
  std::vector<std::uint32_t> from;  ///< of its triangles, those that they were
  FaceOffset offset;
  /// Triangles of the given soup that are left inside out: no place is deep enough below all the
  /// faces round them. Inwards, the material is thinner there than twice the way.
  std::vector<std::uint32_t> turned_over;
  std::vector<std::uint32_t> folded;  ///< of the given soup: FaceOffset::folded
};

/// Moves each face of a solid by `by` (m) along its normal, outwards where positive. The corner of
/// a fan goes to where all its planes are (one, two, three independent ones, the tip of a cone);
/// where they have no such point, to the nearest one that is far enough from all of them. Where a
/// triangle is smaller than what its corners move, these become one corner of all faces round it.
/// The fans are those of the soup, whose
/// coordinates may be off by `rounding` (m). Deterministic. Throws Cancelled.
MovedFaces move_faces(const Soup& soup, const Fans& fans, double by, double rounding,
                      const Progress& progress = {});

}  // namespace sonde
