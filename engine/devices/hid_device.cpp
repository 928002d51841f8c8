// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hid_device.hpp"

#if SONDE_HID
#include <hidapi/hidapi.h>
#endif

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/base/ordering.hpp"
#include "engine/platform/hid_node.hpp"

namespace sonde {

bool HidInfo::has(HidUsage usage) const { return std::ranges::find(usages, usage) != usages.end(); }

bool speaks_hid() noexcept { return SONDE_HID != 0; }

std::string without_hid(bool speaks) {
  return speaks ? "" : "HID devices are not looked for: Sonde was built without hidapi\n";
}

std::string open_failure(int error) {
  std::string reason = std::generic_category().message(error);
  if (error == EACCES || error == EPERM)
    return "no permission to open it: put " + std::string(udev_rule_file) +
           ", which comes with Sonde, into /etc/udev/rules.d, run 'udevadm control --reload' and "
           "plug the device in again";
  if (error == EBUSY) return "another program holds it: " + reason;
  if (error == ENOENT || error == ENODEV || error == ENXIO) return "it is not there any more";
  return reason;
}

#if SONDE_HID

namespace {

/// Protects hidapi's global state, which listing and opening write.
std::mutex& hidapi_mutex() {
  static std::mutex mutex;
  return mutex;
}

void append_utf8(std::string& text, char32_t c) {
  const auto byte = [&](char32_t bits) { text.push_back(static_cast<char>(bits)); };
  if (c < 0x80) return byte(c);
  if (c < 0x800) {
    byte(0xC0 | (c >> 6));
  } else if (c < 0x10000) {
    byte(0xE0 | (c >> 12));
    byte(0x80 | ((c >> 6) & 0x3F));
  } else {
    byte(0xF0 | ((c >> 18) & 0x07));
    byte(0x80 | ((c >> 12) & 0x3F));
    byte(0x80 | ((c >> 6) & 0x3F));
  }
  byte(0x80 | (c & 0x3F));
}

/// Leaves out control characters, since a device's name is printed on a terminal.
std::string utf8(const wchar_t* wide) {
  std::string text;
  for (; wide && *wide != 0; ++wide)
    if (const auto c = static_cast<char32_t>(*wide); c >= 0x20 && (c < 0x7F || c > 0x9F))
      append_utf8(text, c);
  return text;
}

HidInfo info_of(const hid_device_info& found) {
  return {.path = found.path,
          .vendor = found.vendor_id,
          .product = found.product_id,
          .maker = utf8(found.manufacturer_string),
          .name = utf8(found.product_string),
          .serial = utf8(found.serial_number),
          .interface = found.interface_number,
          .usages = {},
          .port = hid_port(found.path)};
}

/// What hidapi is going to do, done first: it says no errno, and hidapi 0.13.1 writes into freed
/// memory where the descriptor's size cannot be asked.
void check_opens(const std::string& path) {
  const auto [opening, asking] = check_hid_node(path);
  if (opening != 0) throw InputError::in(path, open_failure(opening));
  if (asking != 0)
    throw InputError::in(path, "it is no HID device, or is being unplugged: " +
                                   std::generic_category().message(asking));
}

std::vector<std::uint8_t> descriptor_bytes(const std::string& path) {
  std::vector<std::uint8_t> bytes = hid_report_descriptor(path);
  if (bytes.empty()) throw InputError::in(path, "its report descriptor cannot be read");
  return bytes;
}

}  // namespace

std::vector<HidInfo> list_hid() {
  const std::lock_guard lock(hidapi_mutex());
  std::vector<HidInfo> all;
  const std::unique_ptr<hid_device_info, void (*)(hid_device_info*)> first(
      hid_enumerate(0, 0), [](hid_device_info* list) { hid_free_enumeration(list); });
  for (const hid_device_info* found = first.get(); found; found = found->next) {
    if (!found->path) continue;
    // An interface with several top-level collections is listed once for each.
    auto known =
        std::ranges::find_if(all, [&](const HidInfo& info) { return info.path == found->path; });
    if (known == all.end()) known = all.insert(known, info_of(*found));
    known->usages.push_back({found->usage_page, found->usage});
  }
  ordering::sort(all, [](const HidInfo& a, const HidInfo& b) {
    return std::pair(a.path.size(), a.path) < std::pair(b.path.size(), b.path);
  });
  return all;
}

HidDevice::HidDevice(const std::string& path) {
  check_opens(path);
  descriptor_ = parse_hid_report_descriptor(descriptor_bytes(path));
  const std::lock_guard lock(hidapi_mutex());
  device_.reset(hid_open_path(path.c_str()));
  if (!device_) throw InputError::in(path, "hidapi cannot open it: " + utf8(hid_error(nullptr)));
}

void HidDevice::Close::operator()(hid_device_* device) const noexcept { hid_close(device); }

std::optional<std::span<const std::uint8_t>> HidDevice::read(
    std::span<std::uint8_t> buffer, std::chrono::milliseconds timeout) noexcept {
  const int bytes = hid_read_timeout(device_.get(), buffer.data(), buffer.size(),
                                     static_cast<int>(timeout.count()));
  if (bytes < 0) return {};
  return buffer.first(static_cast<std::size_t>(bytes));
}

bool HidDevice::write(std::span<const std::uint8_t> report) noexcept {
  return hid_write(device_.get(), report.data(), report.size()) >= 0;
}

std::optional<std::span<const std::uint8_t>> HidDevice::feature(
    std::span<std::uint8_t> buffer) noexcept {
  const int bytes = hid_get_feature_report(device_.get(), buffer.data(), buffer.size());
  if (bytes < 0 || static_cast<std::size_t>(bytes) > buffer.size()) return {};
  return buffer.first(static_cast<std::size_t>(bytes));
}

#else

std::vector<HidInfo> list_hid() { return {}; }

HidDevice::HidDevice(const std::string& path) {
  throw InputError::in(path, "this Sonde was built without hidapi, which speaks to such devices");
}

void HidDevice::Close::operator()(hid_device_*) const noexcept {}

std::optional<std::span<const std::uint8_t>> HidDevice::read(std::span<std::uint8_t>,
                                                             std::chrono::milliseconds) noexcept {
  return {};
}

bool HidDevice::write(std::span<const std::uint8_t>) noexcept { return false; }

std::optional<std::span<const std::uint8_t>> HidDevice::feature(std::span<std::uint8_t>) noexcept {
  return {};
}

#endif

}  // namespace sonde
