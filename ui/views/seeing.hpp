// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

/// How a body is drawn.
enum class Look { opaque, xray, wireframe, hidden };

/// A plane that cuts bodies: the side that its normal points to is not drawn.
struct CutPlane {
  bool on = false;
  bool fixed = true;  ///< cuts the fixed body
  bool probe = false;
  Vec3 point = Vec3::Zero();    ///< in the fixed body's mesh frame, m
  Vec3 normal = Vec3::UnitX();  ///< unit
  bool cuts_away(const Vec3& x) const { return on && (x - point).dot(normal) > 0; }
};

/// The settings for seeing inside.
struct Seeing {
  Look probe = Look::opaque, fixed = Look::opaque;
  CutPlane cut;
};

/// A place of a body that is pointed out.
struct PointedPlace {
  bool on_probe = false;
  Vec3 at = Vec3::Zero();       ///< in that body's mesh frame, m
  Vec3 outward = Vec3::Zero();  ///< there, unit; zero: none
  double size = 0;              ///< m, of a ball about `at`
  QString text;
};

}  // namespace sonde::ui
