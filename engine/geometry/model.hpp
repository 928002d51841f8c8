// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// Which part of a body counts. solid: its interior and its triangles, for any mesh that bounds an
/// inside once its openings are closed. surface: its triangles only, for any soup. automatic: for
/// each part, solid if it is closed except for openings that are small as seen from outside,
/// otherwise surface.
enum class Model { automatic, solid, surface };

/// What is done to a mesh that is not closed. automatic: whatever makes it closed to the eye
/// (corners joined by index, triangles and parts turned, small openings capped; no coordinate
/// moves). none: nothing; a mesh with an open edge is a surface.
enum class Repair { automatic, none };

}  // namespace sonde
