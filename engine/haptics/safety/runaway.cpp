// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/runaway.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

constexpr double averaged_over = 0.02;  // s
/// s: a handle thrown out of the contact still moves.
constexpr double just_after = 0.05;  // s
// Mass and inertia of the handle of the lightest device with a bundled profile.
constexpr double light_mass = 0.05;     // kg
constexpr double light_inertia = 5e-5;  // kg·m²

/// At least half of `most`, which a fast hand reaches by itself.
double reached(double push, double inertia, double light, double most) {
  if (!(push > 0) || !(most > 0)) return most;
  return std::clamp(push * averaged_over / (inertia > 0 ? inertia : light), most / 2, most);
}

}  // namespace

/// Compared with the hand, the force at the probe is 1/ratio, the mass 1/ratio² and the speed
/// `ratio` times as large.
ThrownSpeed thrown_speed(const DeviceTraits& device, const ThrownSpeed& most) noexcept {
  const auto of_hand = [](double force, double ratio) { return ratio > 0 ? force * ratio : 0; };
  return {
      reached(of_hand(device.max_force, device.ratio), device.mass * device.ratio * device.ratio,
              light_mass, most.way),
      reached(of_hand(device.max_torque, device.turn_ratio),
              device.inertia * device.turn_ratio * device.turn_ratio, light_inertia, most.turn)};
}

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
  return (fastest_.way > 0 && velocity_.norm() > fastest_.way) ||
         (fastest_.turn > 0 && spin_.norm() > fastest_.turn);
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
  const bool slow = fastest_.way <= 0 || velocity_.norm() < 0.5 * fastest_.way;
  const bool turns_slowly = fastest_.turn <= 0 || spin_.norm() < 0.5 * fastest_.turn;
  if (slow && turns_slowly) seen_ = false;
}

}  // namespace sonde
