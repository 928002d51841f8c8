// SPDX-License-Identifier: GPL-3.0-or-later
// References: the names of the profiles that ship, and those that the makers' libraries tell.
#include "engine/settings/profile_match.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/haptics/safety/borne_gains.hpp"

namespace sonde {
namespace {

std::vector<DeviceProfile> shipped() {
  const std::filesystem::path folder = SONDE_DEVICES;
  std::vector<DeviceProfile> out;
  for (const std::string& id : device_profile_ids(std::span(&folder, 1)))
    out.push_back(read_device_profile(folder / (id + ".json")));
  return out;
}

std::string id_for(std::string_view name, const std::vector<DeviceProfile>& profiles) {
  const DeviceProfile* profile = profile_of(name, profiles);
  return profile ? profile->id : "none";
}

TEST(ProfileMatch, a_device_is_of_the_model_that_its_name_says) {
  const std::vector<DeviceProfile> all = shipped();
  EXPECT_EQ(id_for("sigma.7", all), "sigma.7");
  EXPECT_EQ(id_for("Touch", all), "touch");
  EXPECT_EQ(id_for("Touch X", all), "touch-x");
  EXPECT_EQ(id_for("TOUCH_X S2", all), "touch-x");
  EXPECT_EQ(id_for("PHANTOM Premium 1.5 6DOF", all), "premium-1.5-6dof");
  EXPECT_EQ(id_for("Haply Inverse3", all), "none");
  EXPECT_EQ(id_for("omega.6", all), "none");
  EXPECT_EQ(id_for("", all), "none");
  EXPECT_TRUE(is_named_in(all[0], all[0].name));
  EXPECT_FALSE(is_named_in(all[0], "Falcon"));
}

// What is left of a name after a model's own words may be another model.
TEST(ProfileMatch, whole_words_name_a_model_and_other_words_another_one) {
  const std::vector<DeviceProfile> all = shipped();
  for (const char* other :
       {"Touch Extended", "Touchpad", "MultiTouch", "Touch XL", "Touch Haptic Glove", "Touch 2",
        "sigma.70", "sigma.7 wrist", "PHANTOM Premium 1.5 High Force 6DOF", "Premium 6DOF"})
    EXPECT_EQ(id_for(other, all), "none") << other;
  EXPECT_EQ(id_for("Geomagic Touch", all), "touch");
  EXPECT_EQ(id_for("3D Systems Touch-X (S2)", all), "touch-x");
  EXPECT_EQ(id_for("TouchX", all), "touch-x");
  EXPECT_EQ(id_for("Force Dimension sigma.7, left", all), "sigma.7");
  EXPECT_EQ(id_for("SIGMA 7 R", all), "sigma.7");
  EXPECT_EQ(id_for("omega.7 rev3", all), "omega.7");
  const std::vector<std::string> known{"touch", "touch-x"};
  EXPECT_FALSE(is_model_of("touch", "Touch Extended", known));
  EXPECT_TRUE(is_model_of("touch", "Geomagic Touch", known));
}

TEST(ProfileMatch, one_that_was_measured_comes_first) {
  std::vector<DeviceProfile> all = shipped();
  DeviceProfile own = *profile_of("sigma.7", all);
  own.id += "-measured";
  own.name += ", measured";
  all.push_back(own);
  EXPECT_EQ(id_for("sigma.7", all), "sigma.7-measured");
  EXPECT_EQ(id_for("Touch", all), "touch");
}

TEST(ProfileMatch, a_longer_name_is_another_model) {
  const std::vector<std::string> known{"touch", "touch-x", "sigma.7", "sigma.7-measured"};
  EXPECT_FALSE(is_model_of("touch", "Touch X", known));
  EXPECT_FALSE(is_model_of("touch-measured", "TOUCH_X S2", known));
  EXPECT_TRUE(is_model_of("touch-x", "Touch X", known));
  EXPECT_TRUE(is_model_of("touch", "Touch", known));
  EXPECT_TRUE(is_model_of("sigma.7", "Sigma.7 right-handed", known));
  EXPECT_TRUE(is_model_of("sigma.7-measured", "sigma.7", known));
  EXPECT_FALSE(is_model_of("sigma.7", "omega.7", known));
  EXPECT_FALSE(is_model_of("", "omega.7", known));
}

// Of a device without a profile: no device of ours is lighter, less damped or later.
TEST(ProfileMatch, what_is_assumed_without_a_profile_is_the_least_of_those_that_ship) {
  const DeviceTraits assumed = assumed_traits();
  DeviceTraits least = traits_of(simulated(shipped().front()));
  for (const DeviceProfile& profile : shipped()) {
    least.damping = std::min(least.damping, profile.damping.value);
    least.rotational_damping = std::min(least.rotational_damping, profile.rotational_damping.value);
    least.mass = std::min(least.mass, profile.mass.value);
    least.inertia = std::min(least.inertia, profile.inertia.value);
    least.delay = std::max(least.delay, profile.delay.value);
  }
  EXPECT_EQ(assumed.damping, least.damping);
  EXPECT_EQ(assumed.rotational_damping, least.rotational_damping);
  EXPECT_EQ(assumed.mass, least.mass);
  EXPECT_EQ(assumed.inertia, least.inertia);
  EXPECT_EQ(assumed.delay, least.delay);
}

}  // namespace
}  // namespace sonde
