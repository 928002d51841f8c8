// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/force_arm.hpp"

#include <charconv>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string_view>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

constexpr std::string_view dhd_path = "libdhd/", hd_path = "libHD/", haply_path = "haply/";

/// State that the libraries keep for the whole program; opening and listing exclude each other.
struct Arms {
  std::mutex mutex;
  std::map<std::string, std::shared_ptr<const DhdLibrary>> dhd;  // by file
  std::map<std::string, std::shared_ptr<const HdLibrary>> hd;
  int counted = 0;  // number of Force Dimension's arms at the last look
  std::vector<HidInfo> known;
  std::vector<HidInfo> haply;  // at the last look
};
Arms& arms() {
  static Arms all;
  return all;
}

/// Null if it is not installed. A loaded library stays loaded.
template <class Library>
std::shared_ptr<const Library> loaded(
    std::map<std::string, std::shared_ptr<const Library>>& known) {
  const std::filesystem::path file = find_vendor_library(Library::name());
  if (file.empty()) return nullptr;
  std::shared_ptr<const Library>& library = known[file.string()];
  if (!library) library = std::make_shared<const Library>(file);
  return library;
}

template <class Library>
std::shared_ptr<const Library> needed(
    const std::string& path, std::map<std::string, std::shared_ptr<const Library>>& known) {
  std::shared_ptr<const Library> library = loaded(known);
  if (!library)
    throw InputError::in(path,
                         std::string(Library::name().name) + " is " + why_missing(Library::name()));
  return library;
}

int index_of(const std::string& path) {
  int index = -1;
  const char* const begin = path.data() + dhd_path.size();
  const char* const end = path.data() + path.size();
  const auto [rest, error] = std::from_chars(begin, end, index);
  return error == std::errc() && rest == end ? index : -1;
}

force_protocol::Limits limits_of(const ArmIdentity& identity) {
  return {.max_force = identity.capabilities.max_force,
          .max_torque = identity.capabilities.max_torque,
          .reach = identity.farthest};
}

constexpr std::uint16_t force_dimension = 0x1451;  // their USB vendor id, as hwdata lists it

HidInfo info_of(const std::shared_ptr<const DhdLibrary>& library, int index) {
  HidInfo info{.path = std::string(dhd_path) + std::to_string(index),
               .vendor = force_dimension,
               .maker = DhdLibrary::name().maker,
               .name = "Force Dimension arm",
               .serial = "",
               .usages = {}};
  try {
    const DhdArm arm(library, index);
    info.name = arm.identity().name;
    info.serial = arm.identity().serial;
  } catch (const InputError&) {
    return info;  // opening it will report the reason
  }
  return info;
}

void look_for_dhd(Arms& all, std::vector<HidInfo>& found) {
  const std::shared_ptr<const DhdLibrary> library = loaded(all.dhd);
  if (!library) return;
  if (DhdArm::open() == 0) {
    const int count = library->count();
    if (count != all.counted) all.known.clear();
    for (int i = static_cast<int>(all.known.size()); i < count; ++i)
      all.known.push_back(info_of(library, i));
    all.counted = count;
  }
  found.insert(found.end(), all.known.begin(), all.known.end());
}

void look_for_hd(Arms& all, std::vector<HidInfo>& found) {
  if (!loaded(all.hd)) return;
  const char* const listed = std::getenv("SONDE_HD_DEVICES");
  std::string_view rest = listed && *listed ? listed : "Default Device";
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const std::string name(rest.substr(0, comma));
    rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
    if (name.empty()) continue;
    found.push_back({.path = std::string(hd_path) + name,
                     .maker = HdLibrary::name().maker,
                     .name = "OpenHaptics: " + name,
                     .serial = "libHD-" + name,
                     .usages = {}});
  }
}

void look_for_haply(Arms& all, std::vector<HidInfo>& found) {
  // The service is not disturbed while it serves the hand.
  if (HaplyArm::open() == 0) {
    all.haply.clear();
    for (const haply::Arm& arm : find_haply_service().arms)
      all.haply.push_back({.path = std::string(haply_path) + arm.id,
                           .maker = "Haply",
                           .name = "Haply " + arm.model.value_or("inverse3"),
                           .serial = "haply-" + arm.id,
                           .usages = {}});
  }
  found.insert(found.end(), all.haply.begin(), all.haply.end());
}

VendorLibraryListing listing_of_haply() {
  HaplyService service = find_haply_service();
  if (!service.answers)
    service.reason += "; it comes with Haply Hub (haply.co), and SONDE_HAPLY_PORT names its port";
  return {.name = "Inverse Service",
          .maker = "Haply",
          .path = service.address,
          .usable = service.answers,
          .reason = service.reason};
}

template <class Library>
VendorLibraryListing listing_of(std::map<std::string, std::shared_ptr<const Library>>& known) {
  const VendorLibraryName& name = Library::name();
  VendorLibraryListing listing{.name = name.name, .maker = name.maker};
  try {
    listing.path = find_vendor_library(name).string();
    if (const auto library = loaded(known)) {
      listing.version = library->version();
      listing.usable = true;
    } else {
      listing.reason = why_missing(name);
    }
  } catch (const InputError& error) {
    listing.reason = error.what();
  }
  return listing;
}

}  // namespace

ForceArm::Port ForceArm::opened(const std::string& path) {
  Arms& all = arms();
  const std::lock_guard lock(all.mutex);
  if (path.starts_with(haply_path))
    return std::make_unique<HaplyArm>(path.substr(haply_path.size()));
  if (path.starts_with(hd_path))
    return std::make_unique<HdArm>(needed(path, all.hd), path.substr(hd_path.size()));
  return std::make_unique<DhdArm>(needed(path, all.dhd), index_of(path));
}

ForceArm::ForceArm(const std::string& path)
    : port_(opened(path)),
      identity_(std::visit([](const auto& arm) { return arm->identity(); }, port_)),
      check_(limits_of(identity_)) {}

std::optional<Heard> ForceArm::hear(DeviceSample& sample) {
  const ArmReading reading = std::visit([](auto& arm) { return arm->read(); }, port_);
  latency_.answered(reading.answers, reading.answered);
  const auto now = reading.time == DeviceClock::time_point{} ? DeviceClock::now() : reading.time;
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(now - begin_);
  switch (reading.kind) {
    case ArmReading::Kind::nothing:
      return Heard::nothing;
    case ArmReading::Kind::gone:
      complaint_ = reading.words;
      return {};
    case ArmReading::Kind::fault:
      complaint_ = reading.words;
      return check_.refuse(reading.words, sample);
    case ArmReading::Kind::pose:
      break;
  }
  const Heard heard = check_.accept({.sequence = ++sequence_,
                                     .time_us = static_cast<std::uint32_t>(since.count()),
                                     .buttons = static_cast<std::uint16_t>(reading.buttons),
                                     .X_BH = reading.X_BH},
                                    now, sample);
  if (heard == Heard::refused) complaint_ = check_.complaint();
  return heard;
}

void ForceArm::pace() const {
  // The others wait in read().
  if (const auto* arm = std::get_if<std::unique_ptr<HaplyArm>>(&port_)) (*arm)->pace();
}

bool ForceArm::write(const DeviceWrench& wrench, bool on) {
  const bool taken = std::visit([&](auto& arm) { return arm->write(wrench, on); }, port_);
  // The others only queue it, and report when it is output.
  if (taken && on && std::holds_alternative<std::unique_ptr<DhdArm>>(port_))
    latency_.answered(wrench.sampled, DeviceClock::now());
  return taken;
}

bool is_arm_path(const std::string& path) {
  return path.starts_with(dhd_path) || path.starts_with(hd_path) || path.starts_with(haply_path);
}

std::vector<HidInfo> list_arms() {
  Arms& all = arms();
  const std::lock_guard lock(all.mutex);
  std::vector<HidInfo> found;
  // list_vendor_libraries() names a library that cannot be used.
  for (const auto look : {look_for_dhd, look_for_hd, look_for_haply}) try {
      look(all, found);
    } catch (const InputError&) {
      continue;
    }
  return found;
}

std::vector<VendorLibraryListing> list_vendor_libraries() {
  Arms& all = arms();
  const std::lock_guard lock(all.mutex);
  return {listing_of(all.dhd), listing_of(all.hd), listing_of_haply()};
}

}  // namespace sonde
