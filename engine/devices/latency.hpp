// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/devices/device_sample.hpp"
#include "engine/haptics/loop/time_histogram.hpp"

namespace sonde {

/// Times from the arrival of a sample to the force that answers it, once for each sample.
class Latency {
 public:
  /// Reports that the force for the sample that arrived at `sampled` was output at `now`.
  void answered(DeviceClock::time_point sampled, DeviceClock::time_point now) noexcept {
    if (sampled == DeviceClock::time_point{} || sampled == last_) return;
    last_ = sampled;
    times_.add(std::chrono::duration<double, std::micro>(now - sampled).count());
  }
  void restart() noexcept { *this = {}; }

  const TimeHistogram& times() const noexcept { return times_; }

 private:
  TimeHistogram times_;
  DeviceClock::time_point last_{};
};

/// A summary for the user.
struct LatencySummary {
  double median = 0;          ///< µs
  double p999 = 0;            ///< µs, exceeded by one in a thousand
  std::uint64_t samples = 0;  ///< number of samples; 0: none yet
};
inline LatencySummary summary_of(const TimeHistogram& times) noexcept {
  return {times.quantile(0.5), times.quantile(0.999), times.total};
}

}  // namespace sonde
