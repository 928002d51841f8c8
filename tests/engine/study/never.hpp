// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/progress.hpp"

namespace sonde::test {

/// Nobody stops what is computed.
inline const Stop never = [] { return false; };

}  // namespace sonde::test
