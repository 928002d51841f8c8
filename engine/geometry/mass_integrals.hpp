// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/geometry/mass.hpp"

namespace sonde {

struct Soup;

/// Integrals of 1, x and x xᵀ over a region, with x relative to an origin (m), in the mesh frame.
/// They may be negative, to be subtracted.
struct MassMoments {
  Vec3 origin = Vec3::Zero();
  double measure = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

/// Mass properties of the region that the triangles bound, weighted by the winding number, plus
/// `more`.
MassProperties mass_by_volume(const Soup& soup, const Progress& progress = {},
                              const MassMoments& more = {});
/// Largest distance of a vertex of a triangle from a centre of mass, m.
double radius_about(const Soup& soup, const Vec3& com);
MassProperties mass_by_area(const Soup& soup, const Progress& progress = {});

}  // namespace sonde
