// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_hand.hpp"

#include <utility>

namespace sonde {

DeviceHand::DeviceHand(std::shared_ptr<InputDevice> device, const DeviceSettings& settings,
                       const Vec3& com, const Pose& X_FM)
    : device_(std::move(device)), motion_(settings, com, X_FM) {}

HandSample DeviceHand::sample(double dt) noexcept {
  if (settings_.update()) motion_.set_settings(settings_.front());
  if (profiles_.update()) motion_.set_profile(profiles_.front());
  if (views_.update()) motion_.set_view(views_.front());
  if (places_.update()) motion_.place(places_.front());
  const DeviceSample newest = device_->latest();
  sampled_ = newest.state == DeviceState::ready ? newest.time : DeviceClock::time_point{};
  HandSample moved = motion_.move(newest, dt);
  clutch_open_.store(motion_.clutch_open(), std::memory_order_relaxed);
  return moved;
}

void DeviceHand::render(const Wrench& wrench) noexcept {
  DeviceWrench on_handle = motion_.on_handle(wrench);
  on_handle.sampled = sampled_;
  device_->set_wrench(on_handle);
}

Hand DeviceHand::hand() {
  return {.sample = [this](double dt) { return sample(dt); },
          .render = [this](const Wrench& w) { render(w); }};
}

}  // namespace sonde
