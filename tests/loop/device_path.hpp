// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "engine/scene/poses.hpp"
#include "resources/generate/path.hpp"

namespace sonde::ticks {

/// The poses that a device on this path says at 1 kHz.
inline std::vector<TimedPose> sampled(const generate::Path& path) {
  constexpr double rate_hz = 1000;
  const auto last = static_cast<int>(std::floor(rate_hz * path.duration()));
  std::vector<TimedPose> out;
  for (int i = 0; i <= last; ++i) out.push_back({i / rate_hz, path.at(i / rate_hz)});
  return out;
}

}  // namespace sonde::ticks
