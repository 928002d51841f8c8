// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/study/assembly/clash.hpp"

namespace sonde {

/// A section through two parts that clash or are near, as an SVG file: cut by the plane through
/// the clash's place that holds the way out (or the line between the nearest points) and goes
/// through the centre of mass of the smaller part. The way out is an arrow. Of a pair without a
/// place it says so.
std::string clash_picture(const AssemblyPart& a, const AssemblyPart& b, const Clash& clash);

}  // namespace sonde
