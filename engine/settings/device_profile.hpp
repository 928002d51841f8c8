// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde {

/// What a measured figure may also be: `sonde identify` says how sure.
struct ProfileInterval {
  double low = 0, high = 0;
};
/// A number of a profile, and its origin.
struct ProfileValue {
  double value = 0;
  std::string origin;    ///< its source, or why this figure was assumed
  bool assumed = false;  ///< the origin is a reason, not a source
  std::optional<ProfileInterval> interval = {};
};

/// The limits of a haptic device and how it moves: ID.json in a folder of profiles.
struct DeviceProfile {
  std::string id;    ///< the file's name without ".json"
  std::string name;  ///< name for the user
  // What its driver allows.
  ProfileValue max_force;                 ///< N, peak or continuous
  ProfileValue max_torque;                ///< N·m; 0: no motors for torque
  ProfileValue max_stiffness;             ///< N/m
  ProfileValue max_rotational_stiffness;  ///< N·m/rad
  ProfileValue max_damping;               ///< N·s/m, virtual
  ProfileValue max_rotational_damping;    ///< N·m·s/rad, virtual
  // What the hand moves: apparent, at the handle.
  ProfileValue mass;                   ///< kg
  ProfileValue inertia;                ///< kg·m²
  ProfileValue damping;                ///< N·s/m
  ProfileValue rotational_damping;     ///< N·m·s/rad
  ProfileValue friction;               ///< N
  ProfileValue rotational_friction;    ///< N·m
  ProfileValue resolution;             ///< m, of the encoders
  ProfileValue rotational_resolution;  ///< rad
  ProfileValue delay;                  ///< s, from sample to motors
};

/// One value of a profile. The reader, the JSON Schema and the manual have the same.
struct ProfileKey {
  const char* key;
  const char* unit;
  double minimum;  ///< allowed values, both ends included
  double maximum;
  const char* doc;
  ProfileValue DeviceProfile::*value;
};
/// In the order of the file. A profile has every one of them.
std::span<const ProfileKey> profile_keys();

/// Reads a profile. Throws InputError naming the file, the line and the reason: JSON that does not
/// parse, a missing key, an unknown one (with the nearest known), a value out of range, with
/// neither a source nor the reason why it is assumed, or with both; an interval with one end, or
/// one that the value is not in.
DeviceProfile read_device_profile(const std::filesystem::path& file);

/// The text of a profile that reads back as this one, but for its id. Throws InputError where a
/// value is out of its range.
std::string device_profile_text(const DeviceProfile& profile);

/// The ids of the profiles in these folders, sorted, each once. A folder that is not there has
/// none.
std::vector<std::string> device_profile_ids(std::span<const std::filesystem::path> folders);

/// No profile has that id. A program takes this for wrong usage, as any word that it does not know;
/// a file or a path that cannot be used is bad input.
class UnknownProfile : public InputError {
 public:
  using InputError::InputError;
};

/// The profile that a user names: the path of a file (it ends in ".json"), or an id, which is
/// searched in the folders in their order (the user's own before those that came with the program).
/// Throws UnknownProfile naming the nearest known id, InputError where it is another path; else as
/// read_device_profile.
DeviceProfile find_device_profile(std::string_view id_or_file,
                                  std::span<const std::filesystem::path> folders);

/// The keys whose values are assumed, in the order of profile_keys. Every result computed from one
/// of these states it.
std::vector<std::string> assumed_keys(const DeviceProfile& profile);

/// The device to simulate, with the hand of SimulatedDeviceParameters.
SimulatedDeviceParameters simulated(const DeviceProfile& profile);

}  // namespace sonde
