// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/settings/device_profile.hpp"

namespace sonde {

/// Whether a device of this name is of this model, as far as names tell: whole words of it are the
/// letters and digits of the profile's id, or of the profile's own name, in large or small letters,
/// and the other words say nothing of the model: a maker ("Geomagic Touch"), a hand
/// ("sigma.7 right-handed"), a revision ("Touch X S2"). A "Touch Extended" is no Touch. A profile
/// measured on a device ("sigma.7-measured") is of the model that was measured.
bool is_named_in(const DeviceProfile& profile, std::string_view device_name);

/// Whether the name of a device says the model of this id, and none of `known` says another one
/// with more letters: "Touch X" is no "touch".
bool is_model_of(std::string_view id, std::string_view device_name,
                 std::span<const std::string> known);

/// Whether it was measured on a device, as its id or name says.
bool is_measured(const DeviceProfile& profile);

/// The profile of the model that a connected device's name says: of several, the one of the longest
/// name ("Touch X", not "Touch"); of these, a measured one, and then the first. Null if there is
/// none.
const DeviceProfile* profile_of(std::string_view device_name,
                                std::span<const DeviceProfile> profiles);

}  // namespace sonde
