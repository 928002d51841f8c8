// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/passivity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde {
namespace {

/// s: a motion is assumed to continue for at most this long without a report. If the hand reverses
/// within that time, the damping that should brake it pushes it on.
constexpr double longest_guess = 0.01;

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
  if (!device_.known) device_.damping = 0;  // an assumed damping need not exist
  ticks_late_ = whole_ticks(device_.delay, period_, most_ticks_late);
}

/// N·s/m: largest α; the damping of turns is α Î.
double Passivity::most_damping() const noexcept {
  // The limit of the settings applies at the hand.
  const double ratio = device_.ratio > 0 ? device_.ratio : 1;
  const double most =
      device_.max_damping > 0 ? device_.max_damping : settings_.max_damping / (ratio * ratio);
  const double largest = mass_.inertia.maxCoeff();
  if (!(device_.max_rotational_damping > 0) || !(largest > 0)) return most;
  return std::min(most, device_.max_rotational_damping / largest);
}

void Passivity::restart(const Pose& X_FM) noexcept {
  X_FM_ = X_FM;
  forget_motion();
  dt_ = 0;
  wrenches_.fill(Wrench{});
  energy_ = HandEnergy{};
}

void Passivity::forget_motion() noexcept {
  step_ = turn_ = Vec3::Zero();
  since_ = acts_for_ = fresh_for_ = 0;
  held_ = Held{};
  controlled_ = false;
}

void Passivity::observe(const Pose& X_FM, double dt, bool leapt, double since) noexcept {
  const SeparationMotion motion = separation_motion(mass_, leapt ? X_FM : X_FM_, X_FM);
  X_FM_ = X_FM;
  energy_.damping = 0;
  controlled_ = false;
  dt_ = dt > 0 ? dt : 0;
  hold(acting());
  const bool still = motion.t.isZero(0) && motion.theta.isZero(0);
  if (still && !leapt && !(since > 0)) return wait();
  report(motion.t, motion.theta, since);
}

void Passivity::hold(const Wrench& wrench) noexcept {
  held_.impulse += dt_ * wrench.force;
  held_.twist += dt_ * wrench.torque;
  held_.time += dt_;
  ++held_.ticks;
}

Wrench Passivity::mean_held() const noexcept {
  if (held_.ticks < 2 || !(held_.time > 0)) return acting();
  return {held_.impulse / held_.time, held_.twist / held_.time};
}

/// Until the next report is due, the hand is assumed to move on as it did up to the last one.
void Passivity::wait() noexcept {
  if (fresh_for_ > dt_ / 2)
    fresh_for_ -= dt_;
  else
    step_ = turn_ = Vec3::Zero();
}

void Passivity::report(const Vec3& step, const Vec3& turn, double since) noexcept {
  // Without its time, the motion counts as that of this tick.
  const Wrench wrench = since > 0 ? mean_held() : acting();
  held_ = Held{};
  since_ = since > dt_ ? since : dt_;
  acts_for_ = std::min(since_, std::max(dt_, longest_guess));
  fresh_for_ = acts_for_ - dt_;
  step_ = step;
  turn_ = turn;
  const double work = wrench.force.dot(step_) + wrench.torque.dot(turn_);
  if (!std::isfinite(work) || !std::isfinite(step_.squaredNorm())) return forget_motion();
  energy_.given += work;
  const bool known = pushes(wrench) && since_ > 0;
  // The least that the damping takes out in this time, which is that of a uniform motion.
  const double lost = known ? device_.damping * step_.squaredNorm() / since_ : 0;
  energy_.excess += work - lost;
}

Wrench Passivity::control(const Wrench& wanted) noexcept {
  wanted_ = wanted;
  controlled_ = true;
  const bool contact = pushes(wanted);
  if (!settings_.control || !contact || !(energy_.excess > 0) || !(since_ > 0)) return wanted;
  const Mat3 R = X_FM_.q.toRotationMatrix() * mass_.R_MP;
  const Vec3 spin = R * mass_.inertia.cwiseProduct(R.transpose() * turn_) / since_;  // Î ω
  const Vec3 velocity = step_ / since_;
  // (|v|² + ωᵀÎω) times the time for which it acts
  const double square = (velocity.dot(step_) + spin.dot(turn_)) * (acts_for_ / since_);
  if (!(square > 0) || !std::isfinite(square)) return wanted;
  energy_.damping = std::min(energy_.excess / square, most_damping());
  Wrench out = wanted;
  out.force -= energy_.damping * velocity;
  out.torque -= energy_.damping * spin;
  return out;
}

void Passivity::rendered(const Wrench& wrench) noexcept {
  if (std::exchange(controlled_, false) && since_ > 0) {
    const Vec3 force = wanted_.force - wrench.force, torque = wanted_.torque - wrench.torque;
    energy_.dissipated += (force.dot(step_) + torque.dot(turn_)) * (dt_ / since_);
  }
  // Out of contact the wall stores no energy: what it has taken from the hand is dissipated.
  if (!pushes(wrench) && !pushes(acting())) energy_.excess = std::max(energy_.excess, 0.0);
  newest_ = (newest_ + 1) % wrenches_.size();
  wrenches_[newest_] = wrench;
}

void Passivity::rested() noexcept {
  forget_motion();
  rendered(Wrench{});
}

}  // namespace sonde
