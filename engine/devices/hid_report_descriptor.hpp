// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sonde {

/// A usage of the HID Usage Tables: the meaning of a number in a report.
struct HidUsage {
  std::uint16_t page = 0;
  std::uint16_t id = 0;
  bool operator==(const HidUsage&) const = default;
};

/// One number in a report.
struct HidField {
  HidUsage usage{};            ///< for an array: the usage of its logical minimum
  std::uint8_t report_id = 0;  ///< 0 if the device does not number its reports
  /// Position of its lowest bit, counted from the report's first byte (its id, if any).
  std::uint32_t bit = 0;
  std::uint32_t bits = 0;        ///< 1 to 32
  std::int64_t logical_min = 0;  ///< range of its values, as the device states it
  std::int64_t logical_max = 0;
  bool array = false;  ///< the number selects a usage, instead of being the value of one
};

enum class HidReportKind { input, output, feature };

/// One report, with the length given by its fields.
struct HidReport {
  HidReportKind kind = HidReportKind::input;
  std::uint8_t id = 0;
  std::uint32_t bits = 0;  ///< including the id
  std::size_t bytes() const { return (bits + 7) / 8; }
};

/// The contents of a device's reports according to its descriptor (Device Class Definition for HID
/// 1.11, section 6.2.2).
struct HidReportDescriptor {
  HidUsage application;  ///< of the first top-level collection
  std::vector<HidReport> reports;
  std::vector<HidField> inputs, outputs, features;  ///< without padding and fields above 32 bits
  bool whole = true;  ///< false if a part of the bytes is invalid; the valid part before it is kept

  /// Null if there is none.
  const HidReport* report(HidReportKind kind, std::uint8_t id) const;
  bool numbered() const;  ///< each report begins with its id
};

/// Accepts any bytes: throws only if memory runs out, and uses little of it. It ignores everything
/// after an invalid item (truncated, a report beyond 16 kB, collections that do not nest).
HidReportDescriptor parse_hid_report_descriptor(std::span<const std::uint8_t> bytes);

/// The field's value; none if the report has another id or is too short. No allocation.
std::optional<std::int64_t> value_of(const HidField& field, std::span<const std::uint8_t> report);

}  // namespace sonde
