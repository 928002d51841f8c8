// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/runaway.hpp"

#include <cmath>

#include "engine/base/elementary.hpp"

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
  spin_ = Vec3::Zero();
  unpushed_ = just_after;
}

bool Runaway::too_fast() const noexcept {
  return (fastest_ > 0 && velocity_.norm() > fastest_) ||
         (fastest_turn_ > 0 && spin_.norm() > fastest_turn_);
}

void Runaway::observe(const Vec3& way, const Vec3& turn, double dt, bool pushed) noexcept {
  if (!(dt > 0) || !way.allFinite() || !turn.allFinite()) return;
  const double share = 1 - elementary::exp(-dt / averaged_over);
  velocity_ += share * (way / dt - velocity_);
  spin_ += share * (turn / dt - spin_);
  unpushed_ = pushed ? 0 : unpushed_ + dt;
  if (unpushed_ < just_after && too_fast()) seen_ = true;
}

void Runaway::release() noexcept {
  const bool slow = fastest_ <= 0 || velocity_.norm() < 0.5 * fastest_;
  const bool turns_slowly = fastest_turn_ <= 0 || spin_.norm() < 0.5 * fastest_turn_;
  if (slow && turns_slowly) seen_ = false;
}

}  // namespace sonde
