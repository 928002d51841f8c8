// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/simulated_hand.hpp"

#include <cmath>

namespace sonde {
namespace {

/// A mouse tells its place some hundred times a second: without this the hand would jerk at each.
constexpr double hand_lag = 0.025;  // s

}  // namespace

SimulatedHand::SimulatedHand(const SimulatedDeviceParameters& parameters, double period,
                             double scaling, const Vec3& com, const Pose& X_FM)
    : scaling_(scaling),
      traits_{.damping = parameters.translation.damping,
              .delay = parameters.delay,
              .max_damping = parameters.translation.most_virtual_damping,
              .max_rotational_damping = parameters.rotation.most_virtual_damping},
      com_(com),
      share_(1 - std::exp(-period / hand_lag)),
      device_(parameters, period, to_device(X_FM)),
      hand_(X_FM),
      targets_(X_FM) {}

/// The handle's origin is the centre of mass.
Pose SimulatedHand::to_device(const Pose& X_FM) const noexcept {
  return {X_FM.q, X_FM * com_ / scaling_};
}
Pose SimulatedHand::to_probe(const Pose& X_WD) const noexcept {
  return {X_WD.q, X_WD.p * scaling_ - X_WD.q * com_};
}

void SimulatedHand::follow_target() noexcept {
  targets_.update();
  const Pose& target = targets_.front();
  const Vec3 com = hand_ * com_;
  const Vec3 next = com + share_ * (target * com_ - com);
  hand_.q = hand_.q.slerp(share_, target.q).normalized();
  hand_.p = next - hand_.q * com_;
}

HandSample SimulatedHand::sample() noexcept {
  if (scalings_.update() && scalings_.front() != scaling_) {
    const Pose here = to_probe(device_.state().X_WD);
    scaling_ = scalings_.front();
    device_.reset(to_device(here), to_device(hand_));
  }
  follow_target();
  if (places_.update()) {
    hand_ = places_.front();
    device_.reset(to_device(hand_));
  } else if (begun_) {
    device_.step(command_, to_device(hand_));
  }
  begun_ = true;
  // The power is the same at both ends: b v² with velocities `scaling` times greater at the probe.
  DeviceTraits at_probe = traits_;
  at_probe.turn_ratio = 0;
  at_probe.ratio = 0;  // it goes wherever the mouse points, as fast as that
  at_probe.damping /= scaling_ * scaling_;
  at_probe.max_damping /= scaling_ * scaling_;
  return {.X_FM = to_probe(device_.measured()), .device = at_probe};
}

Hand SimulatedHand::hand() {
  return {.sample = [this](double /*dt*/) { return sample(); },
          .render =
              [this](const Wrench& wrench) {
                command_ = {.force = scaling_ * wrench.force, .torque = wrench.torque};
              }};
}

}  // namespace sonde
