// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Which triangles of a soup may be left out, since others have the same corners. One of either
/// orientation stays, as the two sides of a sheet. With `solid`, as many stay in the one or the
/// other as leave all winding numbers in proportion: what turns as often one way as the other stays
/// once in each. Throws Cancelled.
std::vector<bool> repeated_triangles(const Soup& soup, bool solid, const Progress& progress = {});

}  // namespace sonde
