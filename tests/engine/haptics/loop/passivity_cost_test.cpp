// SPDX-License-Identifier: GPL-3.0-or-later
// What the passivity controller costs where the loop is passive, and what it is worth where it is
// not: the whole loop with it and without, on every profile. References: the spring that is
// commanded, k times the depth in a flat contact; K (T/2 + t_d) = b (Colgate and Schenkel, 1994).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/settings/device_profile.hpp"
#include "tests/engine/haptics/loop/hand_loop_bench.hpp"

namespace sonde::test {
namespace {

const char* const profiles[] = {"touch",    "touch-x",          "omega.7",         "sigma.7",
                                "lambda.7", "premium-1.5-6dof", "premium-3.0-6dof"};

DeviceProfile shipped(const std::string& id) {
  return read_device_profile(std::string(SONDE_RESOURCES "/devices/") + id + ".json");
}

/// Without friction, which would hide what the loop gives.
SimulatedDeviceParameters in_light_hand(const DeviceProfile& profile) {
  SimulatedDeviceParameters p = simulated(profile);
  const double per = profile.inertia.value / profile.mass.value;
  p.translation.friction = p.rotation.friction = 0;
  p.translation.hand_stiffness = 200;
  p.translation.hand_damping = 1;
  p.rotation.hand_stiffness = 200 * per;
  p.rotation.hand_damping = per;
  return p;
}

/// What the loop knows of a simulated device; of a connected one, whose driver does not tell its
/// damping and delay, only what it bears.
enum class Known { all, bears };
DeviceTraits traits_of(const DeviceProfile& p, Known known) {
  DeviceTraits out{.max_damping = 4, .max_rotational_damping = 0.004};
  if (known == Known::bears) return out;
  out.damping = p.damping.value;
  out.delay = p.delay.value;
  out.max_damping = p.max_damping.value;
  out.max_rotational_damping = p.max_rotational_damping.value;
  out.mass = p.mass.value;
  out.inertia = p.inertia.value;
  return out;
}

struct Outcome {
  double error = 0;    ///< rms of the force rendered against k · depth, over the rms of that
  double kinetic = 0;  ///< J, of the handle in the last second, which nothing moves
  double taken = 0;    ///< J, taken out by the controller
};

/// The hand presses, goes in and out by half of that at 2 Hz, then holds still for two seconds.
Outcome pressed(const DeviceProfile& profile, double k, Known known, bool control) {
  HandLoopSettings settings = at_once();
  settings.passivity.control = control;
  Coupling coupling;
  coupling.k = k;
  HandLoopBench bench(settings, coupling);
  SimulatedDevice device(in_light_hand(profile), dt, at_depth(-0.001));
  const double force = std::min(1.0, 0.25 * profile.max_force.value);
  const double deep = force / k + force / 200;
  Outcome out;
  double wrong = 0, right = 0;
  constexpr int ticks = 5000, still = 3000;
  for (int i = 0; i < ticks; ++i) {
    const double t = i * dt;
    const double share = std::min(1.0, t / 0.3);
    const double sway = i < still && t > 0.3 ? 0.5 * std::sin(2 * two_pi * (t - 0.3)) : 0;
    const HandSample sample{.X_FM = device.measured(), .device = traits_of(profile, known)};
    const HandTick& tick = bench.tick(sample);
    const double depth = tick.separation.depth;
    wrong += (tick.wrench.force - k * (tick.separation.separated.p - sample.X_FM.p)).squaredNorm();
    right += k * k * depth * depth;
    device.step(tick.wrench, at_depth(deep * (share + sway)));
    if (i >= ticks - 1000)
      out.kinetic += 5e-4 * profile.mass.value * device.state().velocity.squaredNorm();
  }
  out.error = std::sqrt(wrong / right);
  out.taken = bench.loop.last().hand.energy.dissipated;
  return out;
}

double passive(const DeviceProfile& p) { return p.damping.value / (dt / 2 + p.delay.value); }

class PassivityCost : public testing::TestWithParam<const char*> {};

/// A row of the manual's table: `what`, without and with.
void print_row(const char* id, double k, const char* known, const Outcome& off, const Outcome& on) {
  std::printf("| %s | %.0f | %s | %.2f, %.2f | %.3g, %.3g |\n", id, k, known, 100 * off.error,
              100 * on.error, 1e6 * off.kinetic, 1e6 * on.kinetic);
}

TEST_P(PassivityCost, is_nothing_where_the_loop_is_passive_and_known) {
  const DeviceProfile p = shipped(GetParam());
  const double k = 0.5 * passive(p);
  const Outcome off = pressed(p, k, Known::all, false), on = pressed(p, k, Known::all, true);
  EXPECT_EQ(on.taken, 0);
  EXPECT_EQ(on.error, off.error);
  EXPECT_EQ(on.kinetic, off.kinetic);
}

// A hand tells 7 % of a force apart (Jones, 1989).
TEST_P(PassivityCost, is_not_felt_up_to_the_passive_stiffness_whatever_is_known) {
  const DeviceProfile p = shipped(GetParam());
  for (const double share : {0.5, 1.0})
    for (const Known known : {Known::all, Known::bears}) {
      const double k = share * passive(p);
      const Outcome off = pressed(p, k, known, false), on = pressed(p, k, known, true);
      print_row(GetParam(), k, known == Known::all ? "all" : "bears", off, on);
      EXPECT_LE(on.error, off.error + 0.01);
    }
}

TEST_P(PassivityCost, buys_rest_where_the_loop_is_not) {
  const DeviceProfile p = shipped(GetParam());
  for (const Known known : {Known::all, Known::bears}) {
    const double k = 6 * passive(p);
    const Outcome off = pressed(p, k, known, false), on = pressed(p, k, known, true);
    print_row(GetParam(), k, known == Known::all ? "all" : "bears", off, on);
    const double least = known == Known::all ? 100 : 1.3;
    EXPECT_GT(off.kinetic, least * on.kinetic);
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, PassivityCost, testing::ValuesIn(profiles));

// The loop as it is by default: what nothing moves is not braked, a force device is.
TEST(PassivityByDefault, is_on_for_what_a_force_moves) {
  EXPECT_TRUE(HandLoopSettings{}.passivity.control);
  const DeviceProfile p = shipped("sigma.7");
  const auto taken = [&](const std::optional<DeviceTraits>& device) {
    Coupling coupling;
    coupling.k = 6 * passive(p);
    HandLoopBench bench(at_once(), coupling);
    SimulatedDevice handle(in_light_hand(p), dt, at_depth(-0.001));
    for (int i = 0; i < 1000; ++i)
      handle.step(bench.tick({.X_FM = handle.measured(), .device = device}).wrench,
                  at_depth(0.005));
    return bench.loop.last().hand.energy.dissipated;
  };
  DeviceTraits arm = traits_of(p, Known::bears);
  EXPECT_GT(taken(arm), 0);
  arm.force = false;
  EXPECT_EQ(taken(arm), 0) << "a puck";
  EXPECT_EQ(taken({}), 0) << "a mouse, or a path";
}

}  // namespace
}  // namespace sonde::test
