// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/free_handle.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

/// (1 − e^−z)/z, and (z − 1 + e^−z)/z²; for small z by their series.
double first_mean(double z) { return z < 1e-8 ? 1 - z / 2 : -elementary::expm1(-z) / z; }
double second_mean(double z) {
  return z < 1e-3 ? 0.5 - z / 6 + z * z / 24 : (z + elementary::expm1(-z)) / (z * z);
}

class FreeMotion {
 public:
  explicit FreeMotion(const FreeHandle& handle)
      : handle_(handle), rate_(handle.damping / handle.inertia) {}

  double position() const { return position_; }

  /// Advances under a constant command for `time` s, across stops and starts.
  void advance(double time, double command) {
    const double force = command + handle_.offset;
    while (time > 0) {
      if (velocity_ == 0 && std::abs(force) <= handle_.friction) return;
      const double way = velocity_ != 0 ? velocity_ : force;
      const double given = force - std::copysign(handle_.friction, way);
      const double acceleration = given / handle_.inertia - rate_ * velocity_;
      const double stop = time_to_stop(acceleration);
      if (stop >= time) return drift(time, acceleration);
      drift(stop, acceleration);
      velocity_ = 0;
      time -= stop;
    }
  }

 private:
  /// Time until the velocity is zero; infinite if it never is.
  double time_to_stop(double acceleration) const {
    if (velocity_ == 0 || velocity_ * acceleration >= 0) return HUGE_VAL;
    const double undamped = -velocity_ / acceleration;
    const double share = rate_ * undamped;
    if (share >= 1) return HUGE_VAL;
    return share < 1e-8 ? undamped : -elementary::log1p(-share) / rate_;
  }
  void drift(double time, double acceleration) {
    const double z = rate_ * time;
    position_ += velocity_ * time + acceleration * time * time * second_mean(z);
    velocity_ += acceleration * time * first_mean(z);
  }

  FreeHandle handle_;
  double rate_;  ///< 1/s
  double position_ = 0, velocity_ = 0;
};

}  // namespace

std::vector<double> free_motion(const FreeHandle& handle, std::span<const double> times,
                                std::span<const double> commands, std::span<const double> early) {
  std::vector<double> out;
  out.reserve(times.size());
  FreeMotion motion(handle);
  double command = 0, now = times.empty() ? 0 : times.front();
  std::size_t next = 0;
  for (const double time : times) {
    for (; next < times.size(); ++next) {
      const double given = times[next] - (early.empty() ? 0 : early[next]) + handle.delay;
      if (!(given < time)) break;
      motion.advance(given - now, command);
      now = std::max(now, given);
      command = commands[next];
    }
    motion.advance(time - now, command);
    now = time;
    out.push_back(motion.position());
  }
  return out;
}

}  // namespace sonde
