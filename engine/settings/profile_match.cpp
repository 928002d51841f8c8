// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/profile_match.hpp"

#include <algorithm>
#include <string>
#include <tuple>

namespace sonde {
namespace {

constexpr std::string_view measured = "measured";

std::string letters_of(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
    if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

/// The number of letters that name the model in a device's name; 0: it is not named.
std::size_t named_by(const DeviceProfile& profile, const std::string& device) {
  std::size_t longest = 0;
  for (const std::string_view text :
       {std::string_view(profile.id), std::string_view(profile.name)}) {
    std::string letters = letters_of(text);
    if (letters.ends_with(measured)) letters.resize(letters.size() - measured.size());
    if (!letters.empty() && device.find(letters) != std::string::npos)
      longest = std::max(longest, letters.size());
  }
  return longest;
}

}  // namespace

bool is_named_in(const DeviceProfile& profile, std::string_view device_name) {
  return named_by(profile, letters_of(device_name)) > 0;
}

bool is_model_of(std::string_view id, std::string_view device_name,
                 std::span<const std::string> known) {
  const std::string device = letters_of(device_name);
  const auto named = [&](std::string_view model) {
    DeviceProfile profile;
    profile.id = model;
    return named_by(profile, device);
  };
  const std::size_t own = named(id);
  return own > 0 &&
         std::ranges::none_of(known, [&](const std::string& other) { return named(other) > own; });
}

bool is_measured(const DeviceProfile& profile) {
  return letters_of(profile.id).ends_with(measured) || letters_of(profile.name).ends_with(measured);
}

const DeviceProfile* profile_of(std::string_view device_name,
                                std::span<const DeviceProfile> profiles) {
  const std::string device = letters_of(device_name);
  const DeviceProfile* best = nullptr;
  std::tuple<std::size_t, bool> most{0, false};
  for (const DeviceProfile& profile : profiles) {
    const std::tuple<std::size_t, bool> own{named_by(profile, device), is_measured(profile)};
    if (std::get<0>(own) > 0 && own > most) {
      best = &profile;
      most = own;
    }
  }
  return best;
}

}  // namespace sonde
