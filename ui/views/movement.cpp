// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/movement.hpp"

namespace sonde::ui {
namespace {

constexpr double least_pixels = 0.5;

/// Largest displacement of a point of the probe, at most.
double between(const Pose& a, const Pose& b, const Vec3& com, double radius) {
  return (a * com - b * com).norm() + radius * a.q.angularDistance(b.q);
}

bool same_camera(const Place& a, const Place& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up;
}

}  // namespace

void Movement::see(const Place& place, const Vec3& com, double radius, double pixel) {
  if (seen_ && same_camera(*seen_, place) && seen_->swing == place.swing) {
    const double least = least_pixels * pixel;
    if (!(between(seen_->device, place.device, com, radius) > least) &&
        !(between(seen_->separated, place.separated, com, radius) > least))
      return;
  }
  if (seen_) moved_ = Clock::now();
  seen_ = place;
}

}  // namespace sonde::ui
