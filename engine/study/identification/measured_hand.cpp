// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/measured_hand.hpp"

#include <utility>

namespace sonde {

MeasuredHand::MeasuredHand(Device device, const PulsePlan& plan, const PulseBounds& bounds,
                           const Pose& X_FM)
    : device_(std::move(device)),
      sample_time_(plan.sample_time),
      pulses_(plan, bounds),
      X_FM_(X_FM),
      hand_{.sample = [this](double dt) { return sample(dt); },
            .render = [this](const Wrench& wrench) { render(wrench); }} {}

MeasuredHand::MeasuredHand(std::shared_ptr<InputDevice> device, const PulsePlan& plan,
                           const PulseBounds& bounds, const Pose& X_FM)
    : MeasuredHand(Device(std::move(device)), plan, bounds, X_FM) {}

MeasuredHand::MeasuredHand(const SimulatedDeviceParameters& device, const PulsePlan& plan,
                           const PulseBounds& bounds, const Pose& X_FM)
    : MeasuredHand(Device(ReleasedDevice(device, plan.sample_time)), plan, bounds, X_FM) {}

HandSample MeasuredHand::asked(const Pose& X_BH, bool trusted) noexcept {
  return {.X_FM = X_FM_, .trusted = trusted, .trial = &pulses_.next(t_, X_BH, trusted)};
}

HandSample MeasuredHand::sample(double dt) noexcept {
  const bool first = !std::exchange(begun_, true);
  if (auto* simulated = std::get_if<ReleasedDevice>(&device_)) {
    if (!first) simulated->step(command_);
    if (!first) t_ += sample_time_;
    return asked(simulated->measured(), true);
  }
  if (!first) t_ += dt;
  const DeviceSample newest = (*std::get_if<std::shared_ptr<InputDevice>>(&device_))->latest();
  if (first) session_ = newest.session;
  sampled_ = newest.time;
  const bool trusted =
      newest.state == DeviceState::ready && newest.position && newest.session == session_;
  return asked(newest.X_BH, trusted);
}

void MeasuredHand::render(const Wrench& wrench) noexcept {
  command_ = wrench;
  if (auto* connected = std::get_if<std::shared_ptr<InputDevice>>(&device_))
    (*connected)->set_wrench({wrench.force, wrench.torque, sampled_});
  pulses_.rendered(wrench);
}

}  // namespace sonde
