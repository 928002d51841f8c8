// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/clock.hpp"

#include <time.h>

namespace sonde {
namespace {

constexpr std::int64_t second = 1'000'000'000;

}  // namespace

std::int64_t monotonic_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<std::int64_t>(t.tv_sec) * second + t.tv_nsec;
}

void sleep_until_ns(std::int64_t due) noexcept {
  timespec t{};
  t.tv_sec = static_cast<time_t>(due / second);
  t.tv_nsec = static_cast<long>(due % second);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr);
}

}  // namespace sonde
