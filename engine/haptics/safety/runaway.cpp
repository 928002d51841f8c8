// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/runaway.hpp"

#include <cmath>

namespace sonde {
namespace {

constexpr double averaged_over = 0.02;  // s
/// A handle that was thrown out of the contact is on its way still.
constexpr double just_after = 0.05;  // s

}  // namespace

void Runaway::restart() noexcept {
  lose_track();
  seen_ = false;
}

void Runaway::lose_track() noexcept {
  velocity_ = Vec3::Zero();
  unpushed_ = just_after;
}

void Runaway::observe(const Vec3& way, double dt, bool pushed) noexcept {
  if (!(dt > 0) || !way.allFinite()) return;
  velocity_ += (1 - std::exp(-dt / averaged_over)) * (way / dt - velocity_);
  unpushed_ = pushed ? 0 : unpushed_ + dt;
  if (fastest_ > 0 && unpushed_ < just_after && velocity_.norm() > fastest_) seen_ = true;
}

void Runaway::release() noexcept {
  if (velocity_.norm() < 0.5 * fastest_) seen_ = false;
}

}  // namespace sonde
