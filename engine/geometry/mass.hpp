// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

struct Soup;

/// Mass properties at density 1 (by volume for a solid, by area for a surface).
struct MassProperties {
  bool by_volume = false;  ///< of a solid, by volume; else of a surface, by area
  double measure =
      0;  ///< V: volume in m³ or area in m²; a solid's is signed (negative: inside out)
  Vec3 com = Vec3::Zero();  ///< centre of mass in the mesh frame, m
  /// Rotation from principal axes to mesh axes. Its columns are the principal axes, with ascending
  /// inertia and canonical signs: the largest component of the first two is positive, and the third
  /// completes a right-handed frame. The identity where all three inertias agree to rounding.
  Mat3 R_MP = Mat3::Identity();
  /// Principal moments of Î = I/V in m², ascending, never negative. A moment that cannot be told
  /// from zero (≤ 1e-14 of the largest) is exactly zero: a turn about that axis moves nothing.
  Vec3 inertia = Vec3::Zero();
  double radius = 0;  ///< R: largest distance of a vertex of a triangle from com, m
};

// Not of the public face from here on (engine/sonde.hpp).

/// Integrals of 1, x and x xᵀ over a region, with x from an origin (m), in the mesh frame. They may
/// be negative: what is to be taken off.
struct MassMoments {
  Vec3 origin = Vec3::Zero();
  double measure = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

/// Of the region that the triangles bound, each place as often as they wind around it, and of
/// `more`.
MassProperties mass_by_volume(const Soup& soup, const Progress& progress = {},
                              const MassMoments& more = {});
/// Largest distance of a vertex of a triangle from a centre of mass, m.
double radius_about(const Soup& soup, const Vec3& com);
MassProperties mass_by_area(const Soup& soup, const Progress& progress = {});

}  // namespace sonde
