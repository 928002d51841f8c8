// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/to_float.hpp"

namespace sonde {

[[gnu::noinline]] float to_float(double x) { return static_cast<float>(x); }

}  // namespace sonde
