// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/clock.hpp"

#include <chrono>
#include <thread>

namespace sonde {

std::int64_t monotonic_ns() noexcept {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

void sleep_until_ns(std::int64_t due) noexcept {
  using namespace std::chrono;
  std::this_thread::sleep_until(
      steady_clock::time_point(duration_cast<steady_clock::duration>(nanoseconds(due))));
}

}  // namespace sonde
