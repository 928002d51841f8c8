// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/study/assembly/clash.hpp"

namespace sonde {

/// A section through two parts that clash or are near, as an SVG file. The plane contains the
/// clash's place, the way out (or the line between the closest points) and the centre of mass of
/// the smaller part. The way out is shown as an arrow. For a pair without a place, the picture says
/// so.
std::string clash_picture(const AssemblyPart& a, const AssemblyPart& b, const Clash& clash);

}  // namespace sonde
