// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hid_report_descriptor.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr std::uint32_t most_report_bits = 16384 * 8;  // the kernel's own limit
constexpr std::size_t most_fields = 4096;
constexpr std::size_t most_nested = 64;
constexpr std::size_t most_usages = 4096;

/// Tags with their types, without the size bits.
enum Item : std::uint8_t {
  usage_page = 0x04,
  logical_minimum = 0x14,
  logical_maximum = 0x24,
  report_size = 0x74,
  report_id = 0x84,
  report_count = 0x94,
  push = 0xA4,
  pop = 0xB4,
  usage = 0x08,
  usage_minimum = 0x18,
  usage_maximum = 0x28,
  input = 0x80,
  output = 0x90,
  collection = 0xA0,
  feature = 0xB0,
  end_collection = 0xC0,
};

/// An item's data, in both interpretations.
struct Data {
  std::uint32_t plain = 0;
  std::int32_t with_sign = 0;
  std::size_t size = 0;
};

Data data_of(std::span<const std::uint8_t> bytes) {
  Data data{.size = bytes.size()};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    data.plain |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  const auto unused = static_cast<unsigned>(32 - 8 * bytes.size());
  data.with_sign = bytes.empty() ? 0 : static_cast<std::int32_t>(data.plain << unused) >> unused;
  return data;
}

struct Globals {
  std::uint16_t page = 0;
  Data minimum, maximum;
  std::uint32_t size = 0, count = 0;
  std::uint8_t id = 0;
};

struct Locals {
  std::vector<HidUsage> usages;
  std::optional<HidUsage> first, last;
};

class Parser {
 public:
  HidReportDescriptor parse(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const std::size_t taken = item(bytes);
      if (taken == 0) {
        found_.whole = false;
        break;
      }
      bytes = bytes.subspan(taken);
    }
    if (nested_ != 0) found_.whole = false;
    return std::move(found_);
  }

 private:
  /// Handles the first item. Returns its number of bytes; 0 if it is invalid.
  std::size_t item(std::span<const std::uint8_t> bytes) {
    constexpr std::uint8_t long_item = 0xFE;
    if (bytes[0] == long_item) {  // none is defined: skipped
      const std::size_t size = bytes.size() > 1 ? 3 + std::size_t{bytes[1]} : bytes.size() + 1;
      return size <= bytes.size() ? size : 0;
    }
    constexpr std::size_t sizes[] = {0, 1, 2, 4};
    const std::size_t size = sizes[bytes[0] & 3];
    if (bytes.size() < 1 + size) return 0;
    return take(bytes[0] & 0xFC, data_of(bytes.subspan(1, size))) ? 1 + size : 0;
  }

  bool take(unsigned tag, const Data& data) {
    switch (tag) {
      case usage_page:
        globals_.page = static_cast<std::uint16_t>(data.plain);
        return true;
      case logical_minimum:
        globals_.minimum = data;
        return true;
      case logical_maximum:
        globals_.maximum = data;
        return true;
      case report_size:
        globals_.size = data.plain;
        return true;
      case report_count:
        globals_.count = data.plain;
        return true;
      case report_id:
        globals_.id = static_cast<std::uint8_t>(data.plain);
        return data.plain <= 255;
      case push:
        stack_.push_back(globals_);
        return stack_.size() <= most_nested;
      case pop:
        return restore();
      case usage:
        locals_.usages.push_back(usage_of(data));
        return enough_room();
      case usage_minimum:
        locals_.first = usage_of(data);
        return true;
      case usage_maximum:
        locals_.last = usage_of(data);
        return true;
      case input:
        return fields(HidReportKind::input, data.plain);
      case output:
        return fields(HidReportKind::output, data.plain);
      case feature:
        return fields(HidReportKind::feature, data.plain);
      case collection:
        return open_collection();
      case end_collection:
        locals_ = {};
        return nested_-- > 0;
      default:
        return true;  // units, strings, physical ranges
    }
  }

  bool enough_room() const { return locals_.usages.size() <= most_usages; }

  bool restore() {
    if (stack_.empty()) return false;
    globals_ = stack_.back();
    stack_.pop_back();
    return true;
  }

  HidUsage usage_of(const Data& data) const {
    const auto id = static_cast<std::uint16_t>(data.plain);
    return data.size == 4 ? HidUsage{static_cast<std::uint16_t>(data.plain >> 16), id}
                          : HidUsage{globals_.page, id};
  }

  bool open_collection() {
    if (nested_++ == 0 && found_.application == HidUsage{} && !locals_.usages.empty())
      found_.application = locals_.usages.front();
    locals_ = {};
    return nested_ <= static_cast<int>(most_nested);
  }

  HidReport& report(HidReportKind kind) {
    for (HidReport& known : found_.reports)
      if (known.kind == kind && known.id == globals_.id) return known;
    found_.reports.push_back({kind, globals_.id, globals_.id != 0 ? 8U : 0U});
    return found_.reports.back();
  }

  /// The usage of the i-th control: the last one of a list applies to all that follow.
  HidUsage usage_at(std::uint32_t i) const {
    if (!locals_.usages.empty())
      return locals_.usages[std::min<std::size_t>(i, locals_.usages.size() - 1)];
    if (!locals_.first) return {};
    const std::uint16_t most = locals_.last ? locals_.last->id : locals_.first->id;
    const std::uint32_t id = std::min<std::uint32_t>(locals_.first->id + i, most);
    return {locals_.first->page, static_cast<std::uint16_t>(id)};
  }

  std::vector<HidField>& fields_of(HidReportKind kind) {
    if (kind == HidReportKind::input) return found_.inputs;
    return kind == HidReportKind::output ? found_.outputs : found_.features;
  }

  bool fields(HidReportKind kind, std::uint32_t flags) {
    constexpr std::uint32_t constant = 1, variable = 2;
    const std::uint64_t bits = std::uint64_t{globals_.size} * globals_.count;
    HidReport& in = report(kind);
    if (in.bits + bits > most_report_bits) return false;
    std::vector<HidField>& list = fields_of(kind);
    const bool meant = (flags & constant) == 0 && globals_.size >= 1 && globals_.size <= 32;
    if (meant && list.size() + globals_.count > most_fields) return false;
    for (std::uint32_t i = 0; meant && i < globals_.count; ++i)
      list.push_back(field((flags & variable) == 0, i, in.bits + i * globals_.size));
    in.bits += static_cast<std::uint32_t>(bits);
    locals_ = {};
    return true;
  }

  HidField field(bool array, std::uint32_t i, std::uint32_t bit) const {
    const std::int64_t low = globals_.minimum.with_sign;
    // If nothing is negative, a maximum of FF means 255: some devices omit the sign byte.
    const std::int64_t high =
        low < 0 ? std::int64_t{globals_.maximum.with_sign} : std::int64_t{globals_.maximum.plain};
    return {.usage = usage_at(array ? 0 : i),
            .report_id = globals_.id,
            .bit = bit,
            .bits = globals_.size,
            .logical_min = low,
            .logical_max = high,
            .array = array};
  }

  HidReportDescriptor found_;
  Globals globals_;
  Locals locals_;
  std::vector<Globals> stack_;
  int nested_ = 0;
};

}  // namespace

const HidReport* HidReportDescriptor::report(HidReportKind kind, std::uint8_t id) const {
  const auto found = std::ranges::find_if(
      reports, [&](const HidReport& known) { return known.kind == kind && known.id == id; });
  return found == reports.end() ? nullptr : &*found;
}

bool HidReportDescriptor::numbered() const {
  return std::ranges::any_of(reports, [](const HidReport& known) { return known.id != 0; });
}

HidReportDescriptor parse_hid_report_descriptor(std::span<const std::uint8_t> bytes) {
  return Parser().parse(bytes);
}

std::optional<std::int64_t> value_of(const HidField& field, std::span<const std::uint8_t> report) {
  if (field.bits < 1 || field.bits > 32) return {};
  if ((std::uint64_t{field.bit} + field.bits + 7) / 8 > report.size()) return {};
  if (field.report_id != 0 && report[0] != field.report_id) return {};
  std::uint64_t value = 0;
  const std::size_t first = field.bit / 8, last = (field.bit + field.bits - 1) / 8;
  for (std::size_t byte = first; byte <= last; ++byte)
    value |= std::uint64_t{report[byte]} << (8 * (byte - first));
  value = (value >> (field.bit % 8)) & ((std::uint64_t{1} << field.bits) - 1);
  const bool negative = field.logical_min < 0 && (value >> (field.bits - 1)) != 0;
  return static_cast<std::int64_t>(value) -
         (negative ? std::int64_t{1} << field.bits : std::int64_t{0});
}

}  // namespace sonde
