// SPDX-License-Identifier: GPL-3.0-or-later
// The pulses pass the loop that renders contacts, with no thread and no clock. Reference: the
// profile that the device is simulated from.
#include "engine/study/identification/measured_hand.hpp"

#include <gtest/gtest.h>

#include "engine/study/identification/identification.hpp"
#include "tests/engine/haptics/loop/hand_loop_bench.hpp"
#include "tests/engine/study/identification/bundled_profiles.hpp"
#include "tests/engine/study/identification/expect_near.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde::test {
namespace {

/// 2 mm in the block: a contact that pushes with 1 N.
const Pose in_contact = at_depth(0.002);

DeviceProfile bundled_profile(const std::string& id) {
  return find_device_profile(id, {&bundled, 1});
}

struct Measurement {
  explicit Measurement(const DeviceProfile& device)
      : plan(plan_pulses(device, {}, dt)),
        hand(simulated(device), plan, bounds_of(plan, {}), in_contact) {}
  const HandTick& tick(Withheld why = Withheld::nothing) {
    HandSample sample = device.sample(dt);
    sample.changed = std::exchange(first, false);  // as the switch of hands has it
    const HandTick& out = bench.tick(sample, false, why);
    device.render(out.wrench);
    most_force = std::max(most_force, out.wrench.force.norm());
    most_torque = std::max(most_torque, out.wrench.torque.norm());
    return out;
  }
  PulseProgress progress() { return hand.pulses().progress(); }

  PulsePlan plan;
  MeasuredHand hand;
  const Hand& device = hand.hand();
  HandLoopBench bench{HandLoopSettings{}};  // with every limit of the loop
  bool first = true;
  double most_force = 0, most_torque = 0;
};

TEST(MeasuredHand, through_the_loop_every_profile_is_recovered_within_a_twentieth) {
  for (const std::string& id : device_profile_ids({&bundled, 1})) {
    SCOPED_TRACE(id);
    const DeviceProfile p = bundled_profile(id);
    Measurement m(p);
    while (m.progress().end == PulsesEnd::none) m.tick();
    ASSERT_EQ(m.progress().end, PulsesEnd::done) << words(m.progress().end);
    EXPECT_LE(m.most_force, 2 + 1e-12);
    EXPECT_LE(m.most_force, p.max_force.value / 2 + 1e-12);
    EXPECT_LE(m.most_torque, std::min(0.05, p.max_torque.value / 2) + 1e-12);
    const Identification found = identify(m.hand.pulses().response());
    EXPECT_TRUE(found.refused.empty());
    ASSERT_TRUE(found.translation);
    expect_near(found.translation->inertia, p.mass, "mass");
    expect_near(found.translation->damping, p.damping, "damping");
    expect_near(found.translation->friction, p.friction, "friction");
    expect_near(found.translation->resolution, p.resolution, "resolution");
    expect_near(found.delay, p.delay, "delay");
    ASSERT_EQ(found.rotation.has_value(), p.max_torque.value > 0);
    if (!found.rotation) continue;
    expect_near(found.rotation->inertia, p.inertia, "inertia");
    expect_near(found.rotation->damping, p.rotational_damping, "rotational damping");
    expect_near(found.rotation->friction, p.rotational_friction, "rotational friction");
  }
}

TEST(MeasuredHand, the_contact_is_not_rendered_and_the_probe_stays) {
  Measurement m(bundled_profile("sigma.7"));
  for (std::size_t i = 0; i < m.plan.rest; ++i) {
    const HandTick& out = m.tick();
    EXPECT_EQ(out.wrench.force.norm(), 0);
    EXPECT_EQ(out.separation.device.p, in_contact.p);
    EXPECT_EQ(out.hand.energy.given, 0);
  }
  m.tick();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(m.tick().wrench.force.tail<2>().norm(), 0);
  EXPECT_GT(m.most_force, 0) << "along x, where the contact is along z";
  EXPECT_EQ(m.bench.loop.last().hand.energy.given, 0) << "the energy is that of contacts";
}

TEST(MeasuredHand, a_force_that_is_switched_off_ends_it_in_that_tick) {
  Measurement m(bundled_profile("sigma.7"));
  while (m.tick().wrench.force.isZero(0)) continue;
  EXPECT_TRUE(m.tick(Withheld::stopped).wrench.force.isZero(0));
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(m.tick().wrench.force.isZero(0)) << "and stays so";
  EXPECT_EQ(m.progress().end, PulsesEnd::withheld);
  EXPECT_EQ(m.progress().withheld, Withheld::stopped);
}

TEST(MeasuredHand, a_handle_that_is_thrown_ends_it) {
  DeviceProfile light = bundled_profile("sigma.7");
  PulsePlan plan = plan_pulses(light, {}, dt);
  light.mass.value = 0.005;  // a sixtieth of what the plan was made for
  light.friction.value = light.damping.value = 0;
  PulseBounds bounds = bounds_of(plan, {});
  bounds.travel = 10;
  MeasuredHand hand(simulated(light), plan, bounds, in_contact);
  const Hand& device = hand.hand();
  HandLoopBench bench{HandLoopSettings{}};
  while (hand.pulses().progress().end == PulsesEnd::none)
    device.render(bench.tick(device.sample(dt), false).wrench);
  EXPECT_EQ(hand.pulses().progress().end, PulsesEnd::withheld);
  EXPECT_EQ(hand.pulses().progress().withheld, Withheld::diverged);
}

TEST(MeasuredHand, a_device_that_is_not_there_gets_nothing) {
  const DeviceProfile p = bundled_profile("sigma.7");
  const PulsePlan plan = plan_pulses(p, {}, dt);
  MeasuredHand hand(std::make_shared<InputDevice>(DeviceChoice{.path = "/dev/no_such"}), plan,
                    bounds_of(plan, {}), in_contact);
  const Hand& device = hand.hand();
  HandLoopBench bench{HandLoopSettings{}};
  EXPECT_EQ(bench.tick(device.sample(dt), false).hand.withheld, Withheld::untrusted);
  device.render({});
  EXPECT_EQ(hand.pulses().progress().end, PulsesEnd::lost);
}

TEST(MeasuredHand, it_neither_allocates_nor_frees) {
  Measurement m(bundled_profile("sigma.7"));
  m.tick();
  AllocationCounter counter;
  for (int i = 0; i < 500; ++i) m.tick();
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
}

}  // namespace
}  // namespace sonde::test
