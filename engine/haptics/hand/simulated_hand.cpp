// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/simulated_hand.hpp"

#include <cmath>

#include "engine/base/elementary.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// A mouse reports its position some hundred times a second; without this lag each report would
/// jerk.
constexpr double hand_lag = 0.025;  // s

double share_of(double period) { return 1 - elementary::exp(-period / hand_lag); }

}  // namespace

SimulatedHand::SimulatedHand(const SimulatedDeviceParameters& parameters, double period,
                             double scaling, const Vec3& com, const Pose& X_FM)
    : parameters_(parameters),
      scaling_(scaling),
      traits_(traits_of(parameters)),
      com_(com),
      pace_{SimulatedDevice(parameters, period, to_device(X_FM)), share_of(period),
            parameters.translation.inertia, parameters.rotation.inertia},
      hand_(X_FM),
      targets_(X_FM) {}

/// The handle's origin corresponds to the probe's centre of mass.
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
  const Vec3 next = com + pace_.share * (target * com_ - com);
  hand_.q = rotation_between(hand_.q, target.q, pace_.share).normalized();
  hand_.p = next - hand_.q * com_;
}

SimulatedHand::Pace SimulatedHand::pace_of(const SimulatedDeviceParameters& parameters,
                                           double period) {
  return {SimulatedDevice(parameters, period), share_of(period), parameters.translation.inertia,
          parameters.rotation.inertia};
}

void SimulatedHand::set_period(double period) { paces_.write(pace_of(parameters_, period)); }

void SimulatedHand::set_parameters(const SimulatedDeviceParameters& parameters, double period) {
  SimulatedDeviceParameters wanted = parameters_;
  const auto take = [](HandleMotion& to, const HandleMotion& from) {
    to.inertia = from.inertia;
    to.hand_stiffness = from.hand_stiffness;
    to.hand_damping = from.hand_damping;
  };
  take(wanted.translation, parameters.translation);
  take(wanted.rotation, parameters.rotation);
  paces_.write(pace_of(wanted, period));
  parameters_ = wanted;
}

double SimulatedHand::take_scaling(double scaling) noexcept {
  const double times = scaling / scaling_;
  if (times == 1) return 1;
  const Pose here = to_probe(pace_.device.state().X_WD);
  const Vec3 com = here * com_;
  hand_.p += (times - 1) * (hand_ * com_ - com);  // its push stays
  scaling_ = scaling;
  pace_.device.reset(to_device(here), to_device(hand_));
  return times;
}

HandSample SimulatedHand::sample() noexcept {
  if (paces_.update() && paces_.front()) {
    Pace next = *paces_.front();
    next.device.go_on_from(pace_.device);
    pace_ = next;
  }
  const double rescaled = scalings_.update() ? take_scaling(scalings_.front()) : 1;
  follow_target();
  if (places_.update()) {
    hand_ = places_.front();
    pace_.device.reset(to_device(hand_));
  } else if (begun_) {
    pace_.device.step(command_, to_device(hand_));
  }
  begun_ = true;
  DeviceTraits at_probe = traits_;
  at_probe.mass = pace_.mass;
  at_probe.inertia = pace_.inertia;
  at_probe = traits_at_probe(at_probe, scaling_, 1);
  at_probe.turn_ratio = 0;
  at_probe.ratio = 0;  // it follows the mouse, however fast that moves
  return {.X_FM = to_probe(pace_.device.measured()), .rescaled = rescaled, .device = at_probe};
}

Hand SimulatedHand::hand() {
  return {.sample = [this](double /*dt*/) { return sample(); },
          .render =
              [this](const Wrench& wrench) {
                command_ = {.force = scaling_ * wrench.force, .torque = wrench.torque};
              }};
}

}  // namespace sonde
