// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/freed_memory.hpp"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sonde::ui {

void return_freed_memory() {
#ifdef __GLIBC__
  constexpr int lies_together = 1 << 20;  // bytes
  constexpr int heaps = 2;
  mallopt(M_ARENA_MAX, heaps);
  mallopt(M_TRIM_THRESHOLD, lies_together);  // which also ends the growth of the threshold of mmap
#endif
}

}  // namespace sonde::ui
