// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/passivity.hpp"

#include <algorithm>
#include <cmath>

#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde {
namespace {

bool pushes(const Wrench& wrench) { return !wrench.force.isZero(0) || !wrench.torque.isZero(0); }

std::size_t whole_ticks(double delay, double period, std::size_t most) {
  const double ticks = std::ceil(delay / period - 1e-9);
  return ticks > 0 ? static_cast<std::size_t>(std::min(ticks, double(most))) : 0;
}

}  // namespace

Passivity::Passivity(const MassProperties& mass, const PassivitySettings& settings, double period)
    : mass_(mass), settings_(settings), period_(period) {
  set_device({});
}

const Wrench& Passivity::acting() const noexcept {
  return wrenches_[(newest_ + wrenches_.size() - ticks_late_) % wrenches_.size()];
}

void Passivity::set_device(const std::optional<DeviceTraits>& device) noexcept {
  device_ =
      device.value_or(DeviceTraits{.damping = settings_.device_damping, .delay = settings_.delay});
  ticks_late_ = whole_ticks(device_.delay, period_, most_ticks_late);
}

/// N·s/m: largest α; the damping of turns is α Î.
double Passivity::most_damping() const noexcept {
  const double most = device_.max_damping > 0 ? device_.max_damping : settings_.max_damping;
  const double largest = mass_.inertia.maxCoeff();
  if (!(device_.max_rotational_damping > 0) || !(largest > 0)) return most;
  return std::min(most, device_.max_rotational_damping / largest);
}

void Passivity::restart(const Pose& X_FM) noexcept {
  X_FM_ = X_FM;
  step_ = turn_ = Vec3::Zero();
  dt_ = 0;
  wrenches_.fill(Wrench{});
  energy_ = HandEnergy{};
}

void Passivity::observe(const Pose& X_FM, double dt, bool leapt) noexcept {
  const SeparationMotion motion = separation_motion(mass_, leapt ? X_FM : X_FM_, X_FM);
  X_FM_ = X_FM;
  energy_.damping = 0;
  step_ = motion.t;
  turn_ = motion.theta;
  dt_ = dt > 0 ? dt : 0;
  const Wrench& wrench = acting();
  const double work = wrench.force.dot(step_) + wrench.torque.dot(turn_);
  energy_.given += work;
  const bool pushed = pushes(wrench);
  const double lost = pushed && dt_ > 0 ? device_.damping * step_.squaredNorm() / dt_ : 0;
  energy_.excess += work - lost;
}

Wrench Passivity::control(const Wrench& wanted) noexcept {
  const bool contact = pushes(wanted);
  if (!settings_.control || !contact || !(energy_.excess > 0) || !(dt_ > 0)) return wanted;
  const Mat3 R = X_FM_.q.toRotationMatrix() * mass_.R_MP;
  const Vec3 spin = R * mass_.inertia.cwiseProduct(R.transpose() * turn_) / dt_;  // Î ω
  const Vec3 velocity = step_ / dt_;
  const double square = velocity.dot(step_) + spin.dot(turn_);  // (|v|² + ωᵀÎω) dt
  if (!(square > 0)) return wanted;
  energy_.damping = std::min(energy_.excess / square, most_damping());
  energy_.dissipated += energy_.damping * square;
  Wrench out = wanted;
  out.force -= energy_.damping * velocity;
  out.torque -= energy_.damping * spin;
  return out;
}

void Passivity::rendered(const Wrench& wrench) noexcept {
  // Out of contact the wall stores no energy: what it has taken from the hand is dissipated.
  if (!pushes(wrench) && !pushes(acting())) energy_.excess = std::max(energy_.excess, 0.0);
  newest_ = (newest_ + 1) % wrenches_.size();
  wrenches_[newest_] = wrench;
}

}  // namespace sonde
