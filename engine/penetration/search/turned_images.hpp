// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/geometry/chart.hpp"

namespace sonde {

struct MassProperties;

/// The images of a separated pose under possible rotational symmetries of the bodies (bits, plugs,
/// gears and bolts have such symmetries): the probe is turned by m/n of a round, for every n up to
/// 12, about each principal axis of either body, through its centre of mass. A finer symmetry has
/// images so close together that a descent goes from one to the next. The caller must test whether
/// an image is free, since most bodies have none of these symmetries.
/// @param chart of the device pose, with the probe's mass properties
/// @param fixed the fixed body's mass properties
/// @param end y of the separated pose
/// @param nearer m: only images with a smaller |y| are returned
/// @return their y, the nearest first
std::vector<Vec6> turned_images(const Chart& chart, const MassProperties& fixed, const Vec6& end,
                                double nearer);

}  // namespace sonde
