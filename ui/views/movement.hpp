// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

/// What a picture shows, as far as it can move.
struct Place {
  Vec3 eye, target, up;    ///< of the camera
  Pose device, separated;  ///< X_FM of the probe
  double swing = 1;        ///< of the ghost, on its way from one to the other
};

/// Does something move, from picture to picture? A trembling of less than half a pixel does not
/// count.
class Movement {
 public:
  using Clock = std::chrono::steady_clock;
  /// How long nothing has moved when it counts as at rest.
  static constexpr std::chrono::milliseconds rest{200};

  /// A picture shows this. `com` and `radius` are the probe's (m), `pixel` is in m.
  void see(const Place& place, const Vec3& com, double radius, double pixel);
  bool going_on() const { return moved_ && Clock::now() - *moved_ < rest; }
  /// What comes next is the first picture: it has not moved.
  void forget() { seen_.reset(), moved_.reset(); }

 private:
  std::optional<Place> seen_;  ///< as it was when something last moved
  std::optional<Clock::time_point> moved_;
};

}  // namespace sonde::ui
