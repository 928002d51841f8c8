// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// How far the faces of a body are from those of its mesh, and where they could not go as far.
struct FaceOffset {
  double by = 0;        ///< m, outwards; negative: inwards; 0: the body is its mesh
  double furthest = 0;  ///< m, the longest way of a corner: to sharp edges it is more than |by|
  /// Corners where not every face has gone as far, to 1e-4 of it: saddles where no point is deep
  /// enough below all faces, and of a body taken larger the tips of blades.
  std::size_t held_back = 0;
  double least = 0;  ///< m, the least way of a face at one of them, |by| where there is none
  std::size_t vanished = 0;  ///< triangles that are gone: rounded edges finer than the offset, ...
  std::size_t folded = 0;    ///< slivers flatter than the offset, left turned over
  std::size_t filled = 0;    ///< of a body taken larger: triangles in gaps narrower than twice |by|
};

}  // namespace sonde
