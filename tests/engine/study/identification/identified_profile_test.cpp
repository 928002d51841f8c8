// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/identified_profile.hpp"

#include <gtest/gtest.h>

#include "tests/engine/study/identification/bundled_profiles.hpp"
#include "tests/engine/study/identification/made_up_identification.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::assumed_profile;
using test::made_up_identification;

TEST(IdentifiedProfile, has_what_was_measured_with_its_interval_and_how) {
  const DeviceProfile out =
      identified_profile(assumed_profile(), made_up_identification(), "16 pulses");
  EXPECT_EQ(out.mass.value, 0.25);
  EXPECT_FALSE(out.mass.assumed);
  EXPECT_EQ(out.mass.origin, "16 pulses");
  ASSERT_TRUE(out.mass.interval);
  EXPECT_EQ(out.mass.interval->low, 0.24);
  EXPECT_EQ(out.mass.interval->high, 0.26);
  EXPECT_EQ(out.damping.value, 1.5);
  EXPECT_EQ(out.friction.value, 0.1);
  EXPECT_EQ(out.resolution.value, 1e-5);
  EXPECT_EQ(out.delay.value, 0.002);
}

TEST(IdentifiedProfile, keeps_what_was_not_measured) {
  const DeviceProfile was = assumed_profile(),
                      out = identified_profile(was, made_up_identification(), "16 pulses");
  for (const ProfileKey& key : profile_keys()) {
    const ProfileValue &before = was.*key.value, &after = out.*key.value;
    if (after.origin == "16 pulses") continue;
    EXPECT_EQ(after.value, before.value) << key.key;
    EXPECT_EQ(after.assumed, before.assumed) << key.key;
    EXPECT_FALSE(after.interval) << key.key;
  }
  EXPECT_EQ(out.inertia.origin, was.inertia.origin) << "no rotation was measured";
}

TEST(IdentifiedProfile, reads_back_from_its_file) {
  Identification found = made_up_identification();
  found.translation->inertia = {0.1 + 0.2, 0.123456789, 0.987654321};
  const DeviceProfile out = identified_profile(assumed_profile(), found, "pulses");
  EXPECT_EQ(out.mass.value, 0.3) << "six digits are more than any interval leaves";
  EXPECT_EQ(out.mass.interval->low, 0.123457);
  test::TempFolder folder;
  const DeviceProfile back =
      read_device_profile(folder.write("mine.json", device_profile_text(out)));
  EXPECT_EQ(back.id, "mine");
  for (const ProfileKey& key : profile_keys()) {
    EXPECT_EQ((back.*key.value).value, (out.*key.value).value) << key.key;
    EXPECT_EQ((back.*key.value).interval.has_value(), (out.*key.value).interval.has_value());
  }
}

}  // namespace
}  // namespace sonde
