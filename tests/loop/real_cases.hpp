// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/loop/tick_cases.hpp"

namespace sonde::ticks {

/// Four pairs of real meshes of libcgal-demo, 20 to 140 thousand triangles a side: animals and
/// figures, and a part as CAD makes them.
std::vector<std::string> real_pairs();

/// One of them, the probe 5 cm and the fixed body 10 cm in radius, with a path of some seconds:
/// down to the surface, pressed by a few per cent of the probe's radius, about over the surface
/// while it turns, and off again; 0.05 to 0.2 m/s. Same bits every time. Throws where the start is
/// not free.
TickCase real_case(const std::string& name);

}  // namespace sonde::ticks
