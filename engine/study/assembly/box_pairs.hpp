// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// A box along the axes.
struct AxisBox {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

/// The pairs of boxes that meet or touch, the lower number first, in ascending order (CGAL's
/// box intersection, after Zomorodian and Edelsbrunner, 2002).
std::vector<std::array<std::size_t, 2>> pairs_that_meet(const std::vector<AxisBox>& boxes);

}  // namespace sonde
