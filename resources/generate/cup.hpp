// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"

namespace sonde::generate {

/// A cup with its handle, one closed surface; its foot on z = 0, its handle towards +x.
Soup cup_mesh();

}  // namespace sonde::generate
