// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Mass properties at density 1.
struct MassProperties {
  /// By volume, for a solid; by area for a surface, and for a solid with open parts of consequence.
  bool by_volume = false;
  /// V: volume in m³ or area in m²; a volume is signed (negative: inside out).
  double measure = 0;
  Vec3 com = Vec3::Zero();  ///< centre of mass in the mesh frame, m
  /// Rotation from principal axes to mesh axes. Its columns are the principal axes, with ascending
  /// inertia and canonical signs: the largest component of the first two is positive, and the third
  /// completes a right-handed frame. The identity where all three inertias agree to rounding.
  Mat3 R_MP = Mat3::Identity();
  /// Principal moments of Î = I/V in m², ascending, never negative. A moment indistinguishable from
  /// zero (≤ 1e-14 of the largest) is exactly zero: a turn about that axis moves no mass.
  Vec3 inertia = Vec3::Zero();
  double radius = 0;  ///< R: largest distance of a vertex of a triangle from com, m
};

}  // namespace sonde
