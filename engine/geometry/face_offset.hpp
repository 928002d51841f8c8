// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The offset of a body's faces from those of its mesh, and where they could not move as far.
struct FaceOffset {
  double by = 0;        ///< m, outwards; negative: inwards; 0: the body is its mesh
  double furthest = 0;  ///< m, the largest displacement of a corner: at sharp edges it exceeds |by|
  /// Corners at which not every face has moved by the whole offset, to 1e-4 of it: saddles where no
  /// point is deep enough below all faces, and, for an enlarged body, the tips of blades.
  std::size_t held_back = 0;
  double least = 0;  ///< m, least displacement of a face at such a corner; |by| if there is none
  std::size_t vanished = 0;  ///< triangles removed: rounded edges finer than the offset, ...
  std::size_t folded = 0;    ///< slivers flatter than the offset, left inverted
  std::size_t filled = 0;    ///< enlarged body: triangles in gaps narrower than twice |by|
};

}  // namespace sonde
