// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/input_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <optional>

#include "engine/base/error.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/text/nearest.hpp"

namespace sonde::ui {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string ids_of(const HidInfo& info) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%04x:%04x", info.vendor, info.product);
  return text.data();
}

InputSource first_that_opens() {
  for (const DeviceListing& listing : list_devices())
    if (listing.opens) return source_of(listing.info);
  return MouseSource{};
}

/// Opens it once to see that it can be.
InputSource checked(const HidInfo& info) {
  connect(info);
  return source_of(info);
}

InputSource on_node(const std::string& path) {
  for (const ConnectedDevice& device : connected_devices())
    if (device.info.path == path) return checked(device.info);
  throw InputError::in(path, "no 6-DoF device is connected there");
}

/// The first that opens of those that are called so; none where there are none.
std::optional<InputSource> connected_as(const std::string& asked,
                                        const std::vector<ConnectedDevice>& connected) {
  std::string reasons;
  for (const ConnectedDevice& device : connected) {
    if (lower(name_of(device.info)) != lower(asked) && ids_of(device.info) != lower(asked))
      continue;
    try {
      return checked(device.info);
    } catch (const InputError& error) {
      reasons.append(reasons.empty() ? "" : "; ").append(error.what());
    }
  }
  if (!reasons.empty()) throw InputError(reasons);
  return {};
}

InputSource named(const std::string& asked, std::span<const std::filesystem::path> folders) {
  const std::vector<std::string> ids = device_profile_ids(folders);
  if (std::ranges::find(ids, asked) != ids.end())
    return SimulatedSource{find_device_profile(asked, folders)};
  const std::vector<ConnectedDevice> connected = connected_devices();
  if (const std::optional<InputSource> found = connected_as(asked, connected)) return *found;
  std::vector<std::string> known = ids;
  for (const ConnectedDevice& device : connected) known.push_back(name_of(device.info));
  known.insert(known.end(), {"auto", "mouse", "path"});
  const std::vector<std::string_view> words(known.begin(), known.end());
  throw UnknownDevice("no device profile and no connected device has the name \"" + asked +
                      "\"; the nearest known one is \"" + std::string(nearest(asked, words)) + '"');
}

}  // namespace

std::string name_of(const InputSource& source) {
  return std::visit(
      Overloaded{[](const MouseSource&) -> std::string { return "Mouse"; },
                 [](const PathSource& p) -> std::string {
                   return p.file.empty() ? "Recorded path"
                                         : p.file.filename().string() + " (recorded path)";
                 },
                 [](const SimulatedSource& s) { return s.profile.name + " (simulated)"; },
                 [](const ConnectedSource& c) { return c.name; }},
      source);
}

std::vector<std::string> labels_of(std::span<const InputSource> sources) {
  std::vector<std::string> labels;
  for (const InputSource& source : sources) labels.push_back(name_of(source));
  const std::vector<std::string> names = labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto* device = std::get_if<ConnectedSource>(&sources[i]);
    if (device && std::ranges::count(names, names[i]) > 1)
      labels[i] += " (" + device->choice.path + ")";
  }
  return labels;
}

std::string settings_name_of(const InputSource& source) {
  if (const auto* simulated = std::get_if<SimulatedSource>(&source))
    return device_settings_name(simulated->profile.id);
  const auto* connected = std::get_if<ConnectedSource>(&source);
  if (!connected) return "";
  const DeviceChoice& device = connected->choice;
  const bool by_port = device.serial.empty() && !device.port.empty();
  return device_settings_name(device.vendor, device.product,
                              by_port ? "port-" + device.port : device.serial);
}

std::string model_settings_name_of(const InputSource& source) {
  const auto* connected = std::get_if<ConnectedSource>(&source);
  if (!connected || !connected->choice.serial.empty() || connected->choice.port.empty()) return "";
  return device_settings_name(connected->choice.vendor, connected->choice.product, "");
}

DeviceSettings usual_settings(const InputSource& source) {
  const auto* connected = std::get_if<ConnectedSource>(&source);
  return connected ? sonde::usual_settings(connected->kind) : DeviceSettings{};
}

bool same(const InputSource& a, const InputSource& b) {
  if (a.index() != b.index() || settings_name_of(a) != settings_name_of(b)) return false;
  if (const auto* path = std::get_if<PathSource>(&a))
    return path->file == std::get<PathSource>(b).file;
  const auto* one = std::get_if<ConnectedSource>(&a);
  const auto* other = std::get_if<ConnectedSource>(&b);
  if (!one || !one->choice.serial.empty()) return true;
  const bool ports = !one->choice.port.empty() && !other->choice.port.empty();
  return ports ? one->choice.port == other->choice.port : one->choice.path == other->choice.path;
}

ConnectedSource source_of(const HidInfo& info) {
  return {.choice = {.vendor = info.vendor,
                     .product = info.product,
                     .serial = info.serial,
                     .path = info.path,
                     .port = info.port},
          .name = name_of(info),
          .kind = kind_of(info).value_or(DeviceKind::space_mouse)};
}

PathSource path_source(const std::filesystem::path& file) {
  PathSource source{.file = file,
                    .path = std::make_shared<const std::vector<TimedPose>>(read_trajectory(file))};
  if (source.path->empty()) throw InputError::in(file.string(), "it holds no pose");
  return source;
}

InputSource find_source(const std::string& asked,
                        std::span<const std::filesystem::path> profile_folders) {
  if (asked == "auto") return first_that_opens();
  if (asked == "mouse") return MouseSource{};
  if (asked == "path") return PathSource{};
  if (asked.ends_with(".json")) return SimulatedSource{find_device_profile(asked, profile_folders)};
  if (lower(asked).ends_with(".csv")) return path_source(asked);
  if (asked.find('/') != std::string::npos) return on_node(asked);
  return named(asked, profile_folders);
}

}  // namespace sonde::ui
