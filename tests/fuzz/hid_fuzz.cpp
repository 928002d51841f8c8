// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what a device says: its report descriptor, and reports by it and by the protocol.
#include <algorithm>
#include <span>

#include "engine/base/error.hpp"
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
  if (const auto limits = decode_limits(report)) fault_of(*limits);
  return 0;
}
