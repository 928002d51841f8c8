// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/profile_match.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

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

bool is_letter(char c) { return !letters_of({&c, 1}).empty(); }

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> out;
  bool inside = false;
  for (const char c : text) {
    if (is_letter(c) && !inside) out.emplace_back();
    inside = is_letter(c);
    if (inside) out.back() += letters_of({&c, 1});
  }
  return out;
}

/// Whether a word beside a model's name makes no other model of it: its maker, the hand that it is
/// for, or its revision ("S2", "rev3").
bool says_nothing(std::string_view word) {
  constexpr std::string_view known[] = {"3d",     "systems",   "sensable", "geomagic", "phantom",
                                        "force",  "dimension", "haply",    "haptic",   "right",
                                        "left",   "r",         "l",        "handed",   "hand",
                                        "device", "usb"};
  if (std::ranges::find(known, word) != std::end(known)) return true;
  for (const std::string_view revision : {"s", "v", "mk", "rev"}) {
    if (!word.starts_with(revision) || word.size() == revision.size()) continue;
    if (word.substr(revision.size()).find_first_not_of("0123456789") == word.npos) return true;
  }
  return false;
}

using Words = std::span<const std::string>;

bool all_say_nothing(Words words) { return std::ranges::all_of(words, says_nothing); }

/// Whether whole words of the device's name are these letters, and the others say nothing.
bool names(const std::string& letters, Words device) {
  for (std::size_t first = 0; first < device.size(); ++first) {
    std::string run;
    for (std::size_t end = first; end < device.size() && run.size() < letters.size();) {
      run += device[end++];
      if (run == letters && all_say_nothing(device.first(first)) &&
          all_say_nothing(device.subspan(end)))
        return true;
    }
  }
  return false;
}

/// The number of letters that name the model in a device's name; 0: it is not named.
std::size_t named_by(const DeviceProfile& profile, Words device) {
  std::size_t longest = 0;
  for (const std::string_view text :
       {std::string_view(profile.id), std::string_view(profile.name)}) {
    std::string letters = letters_of(text);
    if (letters.ends_with(measured)) letters.resize(letters.size() - measured.size());
    if (!letters.empty() && names(letters, device)) longest = std::max(longest, letters.size());
  }
  return longest;
}

}  // namespace

bool is_named_in(const DeviceProfile& profile, std::string_view device_name) {
  return named_by(profile, words_of(device_name)) > 0;
}

bool is_model_of(std::string_view id, std::string_view device_name,
                 std::span<const std::string> known) {
  const std::vector<std::string> device = words_of(device_name);
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
  const std::vector<std::string> device = words_of(device_name);
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
