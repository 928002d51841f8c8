// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace sonde::app {

/// Runs the work and returns the microseconds that it took.
double timed_us(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
  return took.count();
}

}  // namespace sonde::app
