// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that face each other all round or many times over, and motions that press and jam them.
#pragma once

#include <vector>

#include "tests/support/fitted_parts.hpp"

namespace sonde::test {

/// Balls in sockets, balls of few sides in channels, studs in wells and sheets in slots, three of
/// each, a nut that turns freely on its bolt and four that jam, in other sizes and tessellations.
std::vector<FittedScene> joint_scenes();

}  // namespace sonde::test
