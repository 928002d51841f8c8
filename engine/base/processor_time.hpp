// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// µs of processor time that the calling thread has had: what others do does not count.
double processor_time_us();

/// Does the work and returns the µs of processor time that it took on this thread.
double processor_time_us(const auto& work) {
  const double begin = processor_time_us();
  work();
  return processor_time_us() - begin;
}

}  // namespace sonde
