// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/identified_profile.hpp"

#include <algorithm>

#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

/// More digits than any interval leaves.
double rounded(double x) { return parse_number(number_text(x, 6)).value(); }

}  // namespace

const ProfileKey& key_of(ProfileValue DeviceProfile::*value) {
  return *std::ranges::find(profile_keys(), value, &ProfileKey::value);
}

std::vector<IdentifiedValue> identified_values(const Identification& identification) {
  using Profile = DeviceProfile;
  std::vector<IdentifiedValue> out;
  if (const auto& kind = identification.translation) {
    out.push_back({&Profile::mass, kind->inertia});
    out.push_back({&Profile::damping, kind->damping});
    out.push_back({&Profile::friction, kind->friction});
    out.push_back({&Profile::resolution, kind->resolution});
  }
  if (const auto& kind = identification.rotation) {
    out.push_back({&Profile::inertia, kind->inertia});
    out.push_back({&Profile::rotational_damping, kind->damping});
    out.push_back({&Profile::rotational_friction, kind->friction});
    out.push_back({&Profile::rotational_resolution, kind->resolution});
  }
  out.push_back({&Profile::delay, identification.delay});
  return out;
}

DeviceProfile identified_profile(DeviceProfile profile, const Identification& identification,
                                 const std::string& source) {
  for (const auto& [value, estimate] : identified_values(identification)) {
    const ProfileKey& key = key_of(value);
    const auto end = [&](double x) { return rounded(std::clamp(x, key.minimum, key.maximum)); };
    profile.*value = {rounded(estimate.value), source, false,
                      ProfileInterval{end(estimate.low), end(estimate.high)}};
  }
  return profile;
}

DeviceProfile with_limits_of(DeviceProfile profile, const DeviceCapabilities& can) {
  const std::string source = "the connected device's own word";
  profile.max_force = {can.max_force, source};
  profile.max_torque = {can.max_torque, source};
  if (can.max_stiffness > 0) profile.max_stiffness = {can.max_stiffness, source};
  if (can.max_damping > 0) profile.max_damping = {can.max_damping, source};
  return profile;
}

}  // namespace sonde
