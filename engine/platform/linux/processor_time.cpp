// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/processor_time.hpp"

#include <time.h>

namespace sonde {

double processor_time_us() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e6 + static_cast<double>(t.tv_nsec) * 1e-3;
}

}  // namespace sonde
