// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"

namespace sonde {

/// Whether there is a vertex at which the triangles are several fans: where shells touch that are
/// connected nowhere else, or one shell touches itself. Each edge must be of two triangles that
/// agree in orientation.
bool has_pinches(const Soup& soup);

}  // namespace sonde
