// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// While it exists, no processor of the machine enters a deep sleep state (Linux:
/// /dev/cpu_dma_latency held open at 0 µs). For a force device: waking from deep sleep takes up to
/// some 100 µs, at every tick. It costs power, so nothing else requests it.
class WakefulProcessors {
 public:
  explicit WakefulProcessors(bool wanted, const char* file = "/dev/cpu_dma_latency") noexcept;
  ~WakefulProcessors();
  WakefulProcessors(const WakefulProcessors&) = delete;
  WakefulProcessors& operator=(const WakefulProcessors&) = delete;

  bool granted() const noexcept { return file_ >= 0; }
  /// Static text: what was granted, or why not and what would permit it; "": not wanted.
  const char* words() const noexcept { return words_; }

 private:
  int file_ = -1;
  const char* words_ = "";
};

}  // namespace sonde
