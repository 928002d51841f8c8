// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// Which part of a body counts: its interior and its triangles (solid, for any mesh that bounds an
/// inside once its openings are closed), its triangles alone (surface, for any soup), or, part by
/// part, solid where it is closed but for openings that are small as seen from outside, else
/// surface (automatic).
enum class Model { automatic, solid, surface };

/// What is done to a mesh that is not closed as it is: what makes it closed to the eye (automatic:
/// corners joined by name, triangles and parts turned, small openings capped; no coordinate moves),
/// or nothing (none: a mesh with an open edge is a surface).
enum class Repair { automatic, none };

}  // namespace sonde
