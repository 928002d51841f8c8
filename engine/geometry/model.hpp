// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// What counts of a body: its interior and its triangles (solid, of a closed mesh), its triangles
/// alone (surface, of any soup), or solid where the mesh is closed and has a volume (automatic).
enum class Model { automatic, solid, surface };

}  // namespace sonde
