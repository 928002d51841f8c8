// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

/// The default view direction of a scene: towards the eye, with z up, a little above, from the
/// front left.
inline Vec3 default_view_direction() { return Vec3(-0.45, -1, 0.55).normalized(); }

}  // namespace sonde::ui
