// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// µs of processor time of the calling thread, without that of other work.
double processor_time_us();

/// Runs the work and returns the µs of processor time that it took on this thread.
double processor_time_us(const auto& work) {
  const double begin = processor_time_us();
  work();
  return processor_time_us() - begin;
}

}  // namespace sonde
