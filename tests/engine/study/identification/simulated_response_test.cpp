// SPDX-License-Identifier: GPL-3.0-or-later
// References: the profiles that the devices are simulated from.
#include "engine/study/identification/simulated_response.hpp"

#include <gtest/gtest.h>

#include "engine/study/identification/identification.hpp"
#include "tests/engine/study/identification/bundled_profiles.hpp"
#include "tests/engine/study/identification/expect_near.hpp"

namespace sonde {
namespace {

using test::bundled;
using test::expect_near;

void expect_kind(const IdentifiedKind& found, const ProfileValue& inertia,
                 const ProfileValue& damping, const ProfileValue& friction,
                 const ProfileValue& resolution) {
  expect_near(found.inertia, inertia, "inertia");
  expect_near(found.damping, damping, "damping");
  expect_near(found.friction, friction, "friction");
  expect_near(found.resolution, resolution, "resolution");
}

TEST(SimulatedResponse, the_profiles_that_ship_are_recovered_within_a_twentieth) {
  for (const std::string& id : device_profile_ids({&bundled, 1})) {
    SCOPED_TRACE(id);
    const DeviceProfile p = find_device_profile(id, {&bundled, 1});
    const Identification found =
        identify(simulated_response(simulated(p), plan_pulses(p, {}, 1e-3)));
    EXPECT_TRUE(found.refused.empty());
    ASSERT_TRUE(found.translation);
    ASSERT_EQ(found.rotation.has_value(), p.max_torque.value > 0);
    expect_kind(*found.translation, p.mass, p.damping, p.friction, p.resolution);
    if (found.rotation)
      expect_kind(*found.rotation, p.inertia, p.rotational_damping, p.rotational_friction,
                  p.rotational_resolution);
    expect_near(found.delay, p.delay, "delay");
  }
}

TEST(SimulatedResponse, a_long_delay_is_kept) {
  DeviceProfile p = find_device_profile("sigma.7", {&bundled, 1});
  p.delay.value = 0.03;
  p.max_torque.value = 0;
  const Identification found = identify(simulated_response(simulated(p), plan_pulses(p, {}, 1e-3)));
  expect_near(found.delay, p.delay, "delay");
}

}  // namespace
}  // namespace sonde
