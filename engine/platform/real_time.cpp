// SPDX-License-Identifier: GPL-3.0-or-later
// What no system need be asked for.
#include "engine/platform/real_time.hpp"

#include <cstddef>

namespace sonde {

void touch_stack() noexcept {
  constexpr std::size_t bytes = 256 * 1024, page = 4096;
  volatile char pages[bytes];
  for (std::size_t i = 0; i < bytes; i += page) pages[i] = 0;
  static_cast<void>(pages[0]);
}

int processor_for(LoopThread thread, const int* allowed, int count) noexcept {
  if (count <= 2) return -1;
  return allowed[thread == LoopThread::servo ? count - 1 : count - 2];
}

}  // namespace sonde
