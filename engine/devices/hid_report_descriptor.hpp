// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sonde {

/// A usage of the HID Usage Tables: what a number of a report means.
struct HidUsage {
  std::uint16_t page = 0;
  std::uint16_t id = 0;
  bool operator==(const HidUsage&) const = default;
};

/// One number in a report.
struct HidField {
  HidUsage usage{};            ///< of an array: the usage of its logical minimum
  std::uint8_t report_id = 0;  ///< 0 where the device does not number its reports
  std::uint32_t bit = 0;       ///< of its lowest bit, from the report's first byte (its id, if any)
  std::uint32_t bits = 0;      ///< 1 to 32
  std::int64_t logical_min = 0;  ///< what the device says its values lie between
  std::int64_t logical_max = 0;
  bool array = false;  ///< the number chooses a usage, instead of being the value of one
};

enum class HidReportKind { input, output, feature };

/// One report, as long as its fields make it.
struct HidReport {
  HidReportKind kind = HidReportKind::input;
  std::uint8_t id = 0;
  std::uint32_t bits = 0;  ///< the id included
  std::size_t bytes() const { return (bits + 7) / 8; }
};

/// The contents of a device's reports by its own description (Device Class Definition for HID 1.11,
/// section 6.2.2).
struct HidReportDescriptor {
  HidUsage application;  ///< of the first top-level collection
  std::vector<HidReport> reports;
  std::vector<HidField> inputs, outputs, features;  ///< without padding and fields above 32 bits
  bool whole = true;  ///< false where the bytes stopped making sense: what came before is kept

  /// Null where there is none.
  const HidReport* report(HidReportKind kind, std::uint8_t id) const;
  bool numbered() const;  ///< each report begins with its id
};

/// Reads any bytes: never throws except for memory, and takes little of that. It leaves out what
/// lies after an impossible item (cut off, a report beyond 16 kB, collections that do not nest).
HidReportDescriptor parse_hid_report_descriptor(std::span<const std::uint8_t> bytes);

/// The field's value; none where the report is of another id or too short. No allocation.
std::optional<std::int64_t> value_of(const HidField& field, std::span<const std::uint8_t> report);

}  // namespace sonde
