// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/base/elementary.hpp"
#include "engine/geometry/chart.hpp"

namespace sonde {

/// SplitMix64 (Steele, Lea and Flood, 2014): the same numbers on every machine, which the
/// distributions of the standard library do not guarantee.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// Uniform in [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }
  /// Uniform in the six-dimensional ball of this radius.
  Vec6 in_ball(double radius) {
    for (;;) {
      Vec6 y;
      for (int i = 0; i < 6; ++i) y[i] = uniform(-1, 1);
      if (y.squaredNorm() <= 1) return radius * y;
    }
  }
  /// Uniform over all rotations (Shoemake, 1992).
  Quat rotation() {
    const double u = uniform(0, 1), turn = 2 * std::numbers::pi;
    const double a = turn * uniform(0, 1), b = turn * uniform(0, 1);
    return {std::sqrt(1 - u) * elementary::sin(a), std::sqrt(1 - u) * elementary::cos(a),
            std::sqrt(u) * elementary::sin(b), std::sqrt(u) * elementary::cos(b)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace sonde
