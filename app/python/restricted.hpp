// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/shared_pair.hpp"

namespace sonde::python {

/// Declares Pair.depth_along, Pair.depth_about and Pair.depth_in_plane: depths among fewer motions.
void declare_restricted(PairClass& pair);

}  // namespace sonde::python
