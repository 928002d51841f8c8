// SPDX-License-Identifier: GPL-3.0-or-later
// No standard clock counts the time of a thread alone: here other work does count.
#include "engine/platform/processor_time.hpp"

#include "engine/platform/clock.hpp"

namespace sonde {

double processor_time_us() { return 1e-3 * static_cast<double>(monotonic_ns()); }

}  // namespace sonde
