// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/force_device.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

using force_protocol::Limits;
using force_protocol::PoseReport;

DeviceCapabilities capabilities_of(const Limits& limits) {
  return {.position = true,
          .force = true,
          .buttons = std::min<unsigned>(limits.buttons, 16),
          .max_force = limits.max_force,
          .max_torque = limits.max_torque,
          .max_stiffness = limits.max_stiffness,
          .rate_hz = static_cast<double>(limits.rate_hz),
          .reach = limits.reach};
}

/// Five missed periods, but at least the delay that a busy machine may cause by itself.
DeviceClock::duration stale_after(const Limits& limits) {
  using namespace std::chrono_literals;
  const std::chrono::duration<double> periods(5.0 / limits.rate_hz);
  return std::max<DeviceClock::duration>(
      20ms, std::chrono::duration_cast<DeviceClock::duration>(periods));
}

std::string millimetres(double metres) {
  return std::to_string(std::lround(std::min(1000 * metres, 1e9))) + " mm";
}

}  // namespace

ForceDevice::ForceDevice(const Limits& limits)
    : limits_(limits),
      capabilities_(capabilities_of(limits)),
      stale_after_(sonde::stale_after(limits)) {}

std::string ForceDevice::implausible(PoseReport& report) const {
  if (!report.X_BH.p.allFinite() || !report.X_BH.q.coeffs().allFinite())
    return "its pose holds a number that is not finite";
  constexpr double tolerance = 0.01;
  const double length = report.X_BH.q.norm();
  if (std::abs(length - 1) > tolerance) return "its quaternion is not of unit length";
  report.X_BH.q.coeffs() /= length;
  const Vec3 most = 1.25 * limits_.reach + Vec3::Constant(0.01);
  if ((report.X_BH.p.cwiseAbs().array() > most.array()).any())
    return "its handle is " + millimetres(report.X_BH.p.norm()) +
           " from the base's origin, outside its working volume";
  return "";
}

std::string ForceDevice::does_not_follow(const PoseReport& report) const {
  const auto ahead = static_cast<std::uint16_t>(report.sequence - last_->sequence);
  constexpr std::uint16_t half = 0x8000;
  if (ahead >= half) return "its sequence numbers go back";
  // A wrong clock must not excuse a jump: time steps are limited to this.
  constexpr double longest = 0.05;
  const double dt = std::min(1e-6 * static_cast<double>(report.time_us - last_->time_us), longest);
  // Reports arrive unevenly; for a small device the tolerance is smaller too.
  const double uneven = std::min(0.02, 0.1 * limits_.reach.maxCoeff());
  const double moved = (report.X_BH.p - last_->X_BH.p).norm();
  if (moved > uneven + 5 * dt) return "its handle jumped " + millimetres(moved);
  const double turned = angle_between(report.X_BH.q, last_->X_BH.q);
  if (turned > 0.2 + 60 * dt) return "its handle jumped in rotation";
  return "";
}

Heard ForceDevice::accept(std::span<const std::uint8_t> bytes, DeviceClock::time_point now,
                          DeviceSample& sample) {
  const std::optional<PoseReport> report = force_protocol::decode_pose(bytes);
  if (!report) return refuse("it sent a report that is no pose report", sample);
  return accept(*report, now, sample);
}

Heard ForceDevice::accept(PoseReport report, DeviceClock::time_point now, DeviceSample& sample) {
  // Persistent repetition counts as silence.
  if (last_ && report.sequence == last_->sequence) return Heard::nothing;
  if (report.fault) return refuse("it reports a fault of its own", sample);
  if (!report.valid) return refuse("it does not know its pose yet", sample);
  if (const std::string reason = implausible(report); !reason.empty())
    return refuse(reason, sample);
  if (last_ && now - last_heard_ > stale_after_) {
    last_.reset();
    in_a_row_ = 0;
    sample.state = DeviceState::silent;
  }
  const std::string jump = last_ ? does_not_follow(report) : "";
  if (last_ && jump.empty())
    lost_ += static_cast<std::uint16_t>(report.sequence - last_->sequence - 1);
  last_ = report;
  last_heard_ = now;
  if (!jump.empty()) return refuse(jump, sample);

  in_a_row_ = std::min(in_a_row_ + 1, enough_in_a_row);
  if (in_a_row_ < enough_in_a_row) return Heard::nothing;
  sample.state = DeviceState::ready;
  sample.position = true;
  sample.time = now;
  sample.stale_after = stale_after_;
  sample.buttons = report.buttons;
  sample.X_BH = report.X_BH;
  ++sample.count;
  return Heard::sample;
}

Heard ForceDevice::refuse(const std::string& complaint, DeviceSample& sample) {
  complaint_ = complaint;
  in_a_row_ = 0;
  sample.state = DeviceState::faulty;
  sample.buttons = 0;
  return Heard::refused;
}

std::array<std::uint8_t, force_protocol::WrenchReport::bytes> ForceDevice::wrench_report(
    const DeviceWrench& wrench, bool on) {
  force_protocol::WrenchReport report;
  report.sequence = next_wrench_++;
  report.answers = last_ ? last_->sequence : std::uint16_t{0};
  report.on = on;
  if (on) report.wrench = limited(wrench, capabilities_);
  return force_protocol::encode(report);
}

}  // namespace sonde
