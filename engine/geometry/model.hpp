// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// Which part of a body counts: its interior and its triangles (solid, for a closed mesh), its
/// triangles alone (surface, for any soup), or solid where the mesh is closed and has a volume,
/// else surface (automatic).
enum class Model { automatic, solid, surface };

}  // namespace sonde
