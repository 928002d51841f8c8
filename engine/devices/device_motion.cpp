// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_motion.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace sonde {
namespace {

/// s: a late tick must not throw the probe.
constexpr double longest_step = 0.01;  // s

/// A puck that sends nothing has been released, which is no fault.
bool usable(const DeviceSample& sample) {
  return sample.state == DeviceState::ready ||
         (sample.state == DeviceState::silent && !sample.position);
}

bool is_held(std::uint32_t buttons, int button) {
  return button >= 1 && button <= 32 && ((buttons >> (button - 1)) & 1U) != 0;
}

/// The device's axes (x right, y away, z up) in those of the picture (x right, y up, z towards the
/// eye), and in those of a scene whose y points up: a quarter turn about x, backwards.
Quat lying_down() { return Quat(std::sqrt(0.5), -std::sqrt(0.5), 0, 0); }

Quat base_in_fixed(DeviceSettings::Frame frame, const Quat& q_FV) {
  if (frame == DeviceSettings::Frame::scene) return Quat::Identity();
  return frame == DeviceSettings::Frame::y_up ? lying_down() : Quat(q_FV * lying_down());
}

/// Where neither the device nor a profile says how much virtual damping it permits: the least of
/// the profiles.
constexpr double bearable_damping = 4;                 // N·s/m
constexpr double bearable_rotational_damping = 0.004;  // N·m·s/rad

DeviceTraits at_handle(const std::optional<DeviceTraits>& profile, const DeviceSample& sample) {
  DeviceTraits out = profile.value_or(DeviceTraits{});
  out.known = profile && profile->known;
  const auto said = [](double by_device, double by_profile) {
    return by_device > 0 ? by_device : by_profile;
  };
  const auto or_least = [](double known, double least) { return known > 0 ? known : least; };
  out.max_damping = or_least(said(sample.max_damping, out.max_damping), bearable_damping);
  out.max_rotational_damping = or_least(out.max_rotational_damping, bearable_rotational_damping);
  out.max_stiffness = said(sample.max_stiffness, out.max_stiffness);
  // Its motors are those that it says, even if they are none.
  out.max_force = sample.max_force;
  out.max_torque = sample.max_torque;
  if (!(sample.max_torque > 0)) out.rotational_damping = out.max_rotational_stiffness = 0;
  out.force = sample.max_force > 0;
  out.period = sample.rate_hz > 0 ? 1 / sample.rate_hz : 0;
  return out;
}

}  // namespace

DeviceMotion::DeviceMotion(const DeviceSettings& settings, const Vec3& com,
                           const Pose& X_FM) noexcept
    : settings_(settings), com_(com) {
  configure();
  remapped_ = false;
  place(X_FM);
}

void DeviceMotion::configure() noexcept {
  q_FB_ = base_in_fixed(settings_.frame, q_FV_);
  map_.configure(settings_.axes, settings_.scaling, q_FB_);
  following_ = false;
  remapped_ = true;
}

void DeviceMotion::set_settings(const DeviceSettings& settings) noexcept {
  const bool same_axes = settings.axes == settings_.axes && settings.frame == settings_.frame;
  if (same_axes) rescaled_ *= settings.scaling / settings_.scaling;
  // A new anchor changes the torque on a handle whose turns are inverted or scaled.
  const bool turned = remapped_ || !same_axes || !map_.turns_as_handle();
  settings_ = settings;
  configure();
  remapped_ = turned;
}

void DeviceMotion::set_view(const Quat& q_FV) noexcept {
  q_FV_ = q_FV;
  if (settings_.frame == DeviceSettings::Frame::view) configure();
}

void DeviceMotion::place(const Pose& X_FM) noexcept {
  X_FC_ = {X_FM.q, X_FM * com_};
  following_ = false;
}

Reach DeviceMotion::reach() const noexcept {
  return {settings_.scaling * settings_.reach, settings_.turn};
}

SixAxes DeviceMotion::in_fixed_frame(const SixAxes& in_base) const noexcept {
  SixAxes turned;
  turned << q_FB_ * in_base.head<3>(), q_FB_ * in_base.tail<3>();
  return turned;
}

/// A damping α of the probe is Aᵀ α A at the hand, with A the map of velocities.
DeviceTraits DeviceMotion::traits(const DeviceSample& sample) const noexcept {
  const WorkspaceMap::Ratios ratios = map_.largest_ratios();
  return traits_at_probe(at_handle(profile_, sample), ratios.translation, ratios.rotation);
}

void DeviceMotion::anchor(const DeviceSample& sample) noexcept {
  map_.anchor(sample.X_BH, X_FC_);
  rest_ = position_at_rest(X_FC_, in_fixed_frame(deflection_), reach());
}

void DeviceMotion::deflect(const SixAxes& deflection, double dt) noexcept {
  const SixAxes wanted = mapped(settings_.axes, deflection);
  deflection_ = smoothed(deflection_, wanted, dt, settings_.smoothing);
  // Ends the tail of the exponential, which would last forever.
  constexpr double nothing = 1e-4;
  if (wanted.isZero(0) && deflection_.cwiseAbs().maxCoeff() < nothing) deflection_.setZero();
}

HandSample DeviceMotion::move(const DeviceSample& sample, double dt) noexcept {
  clutch_open_ = is_held(sample.buttons, settings_.clutch_button);
  const bool trusted = usable(sample);
  const bool follow = trusted && !clutch_open_;
  if (!sample.position) deflect(sample.deflection, dt);
  const bool neighbours =
      following_ && dt > 0 && session_ == sample.session && position_ == sample.position;
  if (follow) {
    if (!neighbours) anchor(sample);
    const bool by_rate = settings_.control == DeviceSettings::Control::rate;
    const SixAxes deflection = in_fixed_frame(deflection_);
    if (sample.position)
      X_FC_ = map_.follow(sample.X_BH);
    else if (by_rate)
      X_FC_ = rate_controlled(X_FC_, deflection, reach(), std::min(dt, longest_step));
    else
      X_FC_ = position_controlled(rest_, deflection, reach());
  }
  const bool reported = neighbours && sample.count != count_;
  const double since = reported ? std::chrono::duration<double>(sample.time - time_).count() : 0;
  count_ = sample.count;
  time_ = sample.time;
  following_ = follow;
  session_ = sample.session;
  position_ = sample.position;
  const bool turned = std::exchange(remapped_, false) && sample.position;
  const double rescaled = std::exchange(rescaled_, 1);
  return {.X_FM = {X_FC_.q, X_FC_.p - X_FC_.q * com_},
          .held = !clutch_open_,
          .trusted = trusted,
          .changed = turned,
          .rescaled = sample.position ? rescaled : 1,
          .device = position_ ? std::optional(traits(sample)) : std::nullopt,
          .since = since};
}

DeviceWrench DeviceMotion::on_handle(const Wrench& wrench) const noexcept {
  return position_ && following_ ? map_.on_handle(wrench) : DeviceWrench{};
}

}  // namespace sonde
