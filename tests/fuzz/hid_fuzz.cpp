// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what a device says: its report descriptor, and reports by it and by the protocol.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>

#include "engine/base/error.hpp"
#include "engine/devices/force_device.hpp"
#include "engine/devices/force_protocol.hpp"
#include "engine/devices/hid_report_descriptor.hpp"
#include "engine/devices/space_mouse.hpp"
#include "engine/devices/stick_controller.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

/// A driver by the descriptor, and the report twice: every number of a sample stays in its range.
template <class Driver>
void hear(const sonde::HidReportDescriptor& descriptor, std::span<const std::uint8_t> report) {
  Driver driver(descriptor);
  sonde::DeviceSample sample;
  for (int i = 0; i < 2; ++i) driver.accept(report, {}, sample);
  sonde::fuzz::require((sample.deflection.array().abs() <= 1).all(), "a deflection in its range");
}

/// A host and a device that works, with reports of any bytes between those of the device: what the
/// host takes over can be true, and what it answers stays within the limits.
void hear(const sonde::force_protocol::Limits& limits, std::span<const std::uint8_t> bytes) {
  using namespace sonde;
  using force_protocol::PoseReport;
  ForceDevice host(limits);
  DeviceSample sample;
  PoseReport working;
  DeviceClock::time_point now{};
  const auto step = [&] {
    now += std::chrono::milliseconds(1);
    ++working.sequence;
    working.time_us += 1000;
    host.accept(encode(working), now, sample);
  };
  for (int i = 0; i < ForceDevice::enough_in_a_row; ++i) step();
  fuzz::require(sample.state == DeviceState::ready, "a device that works is ready");
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), PoseReport::bytes))) {
    host.accept(bytes, now, sample);
    fuzz::require(sample.X_BH.p.allFinite() && std::abs(sample.X_BH.q.norm() - 1) < 1e-6,
                  "a pose that is taken over is one");
    DeviceWrench wrench{.force = Vec3::Constant(1e300), .torque = Vec3::Constant(-1e300)};
    if (const auto heard = force_protocol::decode_wrench(bytes)) wrench = heard->wrench;
    const auto answer = force_protocol::decode_wrench(host.wrench_report(wrench, true));
    // Rounded to the floats of the report, of which the smallest are this far apart.
    constexpr double apart = std::numeric_limits<float>::denorm_min();
    fuzz::require(answer && answer->wrench.force.norm() <= limits.max_force * (1 + 1e-5) + apart &&
                      answer->wrench.torque.norm() <= limits.max_torque * (1 + 1e-5) + apart,
                  "a wrench stays within the limits");
    step();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sonde;
  using namespace sonde::force_protocol;
  if (size == 0) return 0;
  const std::size_t cut = std::min<std::size_t>(data[0], size - 1);
  const std::span descriptor(data + 1, cut), report(data + 1 + cut, size - 1 - cut);
  try {
    const HidReportDescriptor parsed = parse_hid_report_descriptor(descriptor);
    for (const auto* fields : {&parsed.inputs, &parsed.outputs, &parsed.features})
      for (const HidField& field : *fields) value_of(field, report);
    hear<SpaceMouse>(parsed, report);
    if (!stick_layout(parsed).empty()) hear<StickController>(parsed, report);
    fault_of(parsed);
  } catch (const InputError&) {
  }
  if (const auto pose = decode_pose(report)) {
    const auto bytes = encode(*pose);
    fuzz::require(std::ranges::equal(encode(*decode_pose(bytes)), bytes), "a pose survives");
  }
  decode_wrench(report);
  Limits limits{.max_force = 8, .max_torque = 0.25, .reach = Vec3::Constant(0.2)};
  std::span<const std::uint8_t> rest = report;
  if (const auto sent = decode_limits(report)) {
    rest = rest.subspan(Limits::bytes);
    if (fault_of(*sent).empty()) limits = *sent;
  }
  hear(limits, rest);
  return 0;
}
