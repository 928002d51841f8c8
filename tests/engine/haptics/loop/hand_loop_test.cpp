// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of the hand with no thread and no clock. The reference is the loop in step
// (haptic_loop.hpp); how old the rows are is the test's to say.
#include "engine/haptics/loop/hand_loop.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "engine/haptics/hand/simulated_hand.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"
#include "tests/engine/haptics/loop/hand_loop_bench.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde::test {
namespace {

using Bench = HandLoopBench;

TEST(HandLoop, with_rows_of_the_tick_before_the_wrench_is_that_of_the_loop_in_step) {
  for (const Coupling::Mode mode : {Coupling::Mode::object, Coupling::Mode::classic}) {
    Coupling coupling;
    coupling.mode = mode;
    coupling.b_t = 0.5;
    Bench bench(at_once(), coupling);
    HapticLoop in_step({bench.probe, bench.fixed}, Method::pdg, coupling);
    in_step.reset(at_depth(-0.001), {});
    int contact = 0;
    for (int i = 0; i < 400; ++i) {
      const Pose X = at_depth(0.004 * std::sin(0.02 * i));
      const HandTick& got = bench.tick({.X_FM = X});
      in_step.tick(X, dt, {});
      EXPECT_LT((got.wrench.force - in_step.wrench().force).norm(), 2e-3) << i;
      EXPECT_EQ(got.hand.rows.age_ticks, 1u);
      EXPECT_TRUE(got.hand.rows.in_step);
      contact += got.separation.status == Status::penetrating;
    }
    EXPECT_GT(contact, 100);
  }
}

TEST(HandLoop, says_how_old_its_rows_are) {
  Bench bench;
  bench.settle(0.001, 5);
  for (std::uint64_t age = 2; age < 10; ++age) {
    const HandTick& t = bench.tick({.X_FM = at_depth(0.002)}, false);
    if (age == 2) continue;
    EXPECT_EQ(t.hand.rows.age_ticks, age - 1);
    EXPECT_NEAR(t.hand.rows.age, double(age - 1) * dt, 1e-9);
    EXPECT_FALSE(t.hand.rows.in_step);
    EXPECT_NEAR(t.wrench.force.z(), 500 * 0.002, 1e-3);  // and still pushes as it should
  }
}

/// A probe pressed 2 mm deep, whose geometry has stopped `lag` above the contact without an answer.
/// The rows are trusted for a tenth of the probe's radius.
struct LaggingBench {
  HandLoopSettings settings = at_once();
  Coupling coupling;
  std::shared_ptr<const Body> probe = test::body(test::box({0.02, 0.03, 0.05}));
  ContactFeed feed{{probe, test::body(test::box({0.3, 0.3, 0.1}))}, Method::pdg};
  HandLoop loop;
  std::uint64_t i = 0;

  explicit LaggingBench(const Coupling& c = {}) : coupling(c), loop(make()) {
    feed.reset(at_depth(-0.001), {});
    loop.restart(at_depth(-0.001));
  }
  HandLoop make() {
    settings.safety.force_error = 0.3;
    coupling.k = 500;
    return {probe->mass, Method::pdg, coupling, settings};
  }
  double trusted() const { return 0.1 * probe->mass.radius; }
  HandTick tick(bool converged, double lag, double residual = 0.5) {
    const Pose X = at_depth(0.002);
    const double now = double(++i) * dt;
    feed.refresh(X, i, now, {});
    LocalContacts rows = feed.contacts();
    rows.separation.converged = converged;
    rows.separation.residual = residual;
    rows.separation.separated.p.z() += lag;
    rows.reach = 0;
    return loop.tick({.X_FM = X}, rows, {.tick = i, .now = now, .dt = dt}, Withheld::nothing);
  }
};

// 500 N/m on the way that the rows do not reach is what the force is off by.
TEST(HandLoop, a_probe_that_lags_gives_its_force_up_beyond_what_it_may_be_off_by) {
  LaggingBench bench;
  // 0.2 N are let by.
  for (int k = 0; k < 100; ++k)
    EXPECT_EQ(bench.tick(false, bench.trusted() + 0.4e-3).hand.withheld, Withheld::nothing) << k;
  EXPECT_NEAR(bench.loop.behind(), 0.2 / 0.3, 0.02);
  EXPECT_NEAR(bench.loop.last().wrench.force.norm(), 1.2, 0.02);
  EXPECT_EQ(bench.tick(true, 0).hand.withheld, Withheld::nothing);
  double before = bench.loop.last().wrench.force.norm();
  for (int k = 0; k < 60; ++k) {
    const HandTick now = bench.tick(false, bench.trusted() + 0.8e-3);
    EXPECT_EQ(now.hand.withheld, Withheld::unsettled);
    EXPECT_LE(now.wrench.force.norm(), before + (k == 0 ? 0.41 : 0));
    before = now.wrench.force.norm();
  }
  EXPECT_EQ(before, 0);
  EXPECT_NEAR(bench.tick(true, 0).wrench.force.norm(), 1, 0.01) << "no ramp was asked for";
}

// Radii of gyration of the box, by hand: sqrt((3² + 5²)/12) = 1.683 cm, 1.555 and, of the least,
// sqrt((2² + 3²)/12) = 1.041. A lag of 0.4 mm may be a turn by 0.4/10.41 rad, whose torque
// over 1.683 cm is 2.28 N at 1 N·m/rad, and 0.2 N at 0.0876.
TEST(HandLoop, in_the_classic_mode_a_lag_counts_as_a_way_and_as_a_turn) {
  Coupling classic;
  classic.mode = Coupling::Mode::classic;
  classic.k_t = 500;
  for (const auto& [k_t, k_r, error] :
       {std::tuple{500.0, 0.0, 0.2}, std::tuple{500.0, 1.0, 2.28}, std::tuple{100.0, 0.0876, 0.2},
        std::tuple{1000.0, 0.0876, 0.4}}) {
    classic.k_t = k_t, classic.k_r = k_r;
    LaggingBench bench(classic);
    const HandTick now = bench.tick(false, bench.trusted() + 0.4e-3);
    EXPECT_EQ(now.hand.withheld, error > 0.3 ? Withheld::unsettled : Withheld::nothing) << k_t;
  }
}

TEST(HandLoop, rows_that_are_trusted_up_to_their_optimum_give_its_force) {
  LaggingBench bench;
  for (const double share : {0.0, 0.3, 0.6, 0.95})
    for (int k = 0; k < 20; ++k) {
      const HandTick now = bench.tick(false, share * bench.trusted(), 0.9);
      EXPECT_EQ(now.hand.withheld, Withheld::nothing) << share;
      EXPECT_NEAR(now.wrench.force.norm(), 1, 0.01) << share;
    }
}

TEST(HandLoop, the_force_ramps_in_from_zero_at_the_start) {
  HandLoopSettings settings = at_once();
  settings.safety.ramp_time = 0.1;
  Bench bench(settings);
  double last = -1;
  for (int i = 0; i < 150; ++i) {
    const double f = bench.tick(0.002).wrench.force.z();
    if (i == 0) {
      EXPECT_LT(f, 0.02);
    }
    EXPECT_GE(f, last);
    last = f;
  }
  EXPECT_NEAR(last, 1, 1e-3);
}

/// What makes the force zero, each with its reason.
struct ForceFault {
  const char* name;
  Withheld reason;
  const HandTick& (*tick)(Bench&);
};
const ForceFault faults[] = {
    {"Esc", Withheld::stopped,
     [](Bench& b) -> const HandTick& {
       return b.tick({.X_FM = at_depth(0.002)}, true, Withheld::stopped);
     }},
    {"device loss", Withheld::untrusted,
     [](Bench& b) -> const HandTick& {
       return b.tick({.X_FM = at_depth(0.002), .trusted = false});
     }},
    {"clutch", Withheld::let_go,
     [](Bench& b) -> const HandTick& { return b.tick({.X_FM = at_depth(0.002), .held = false}); }},
    {"another hand", Withheld::changed,
     [](Bench& b) -> const HandTick& {
       return b.tick({.X_FM = at_depth(0.002), .changed = true});
     }},
    {"not a number", Withheld::not_finite,
     [](Bench& b) -> const HandTick& {
       Pose X = at_depth(0.002);
       X.p.x() = std::numeric_limits<double>::quiet_NaN();
       return b.tick({.X_FM = X});
     }},
    {"failed separation", Withheld::failed,
     [](Bench& b) -> const HandTick& {
       // A pose that the geometry refuses: too far away to compute with.
       b.feed.refresh({Quat::Identity(), Vec3(1e12, 0, 0)}, 0, 1e9, {});
       return b.tick({.X_FM = at_depth(0.002)});
     }},
    {"stalled geometry", Withheld::stalled,
     [](Bench& b) -> const HandTick& {
       for (int i = 0; i < 25; ++i) b.tick({.X_FM = at_depth(0.002)}, false);
       return b.tick({.X_FM = at_depth(0.002)}, false);
     }},
    {"shutdown", Withheld::shut_down,
     [](Bench& b) -> const HandTick& { return b.loop.rest(Withheld::shut_down); }},
    {"pause", Withheld::paused,
     [](Bench& b) -> const HandTick& { return b.loop.rest(Withheld::paused); }},
};

TEST(HandLoop, whatever_goes_wrong_gives_no_force_says_why_and_ramps_in_again) {
  for (const ForceFault& fault : faults) {
    SCOPED_TRACE(fault.name);
    HandLoopSettings settings = at_once();
    settings.safety.ramp_time = 0.1;
    Bench bench(settings);
    bench.settle(0.002);
    ASSERT_NEAR(bench.loop.last().wrench.force.z(), 1, 1e-3);
    const HandTick& t = fault.tick(bench);
    EXPECT_EQ(t.wrench.force, Vec3::Zero());
    EXPECT_EQ(t.wrench.torque, Vec3::Zero());
    EXPECT_EQ(t.hand.withheld, fault.reason);
    bench.tick(0.002);  // the geometry's first answer after it
    const HandTick& again = bench.tick(0.002);
    EXPECT_EQ(again.hand.withheld, Withheld::nothing);
    EXPECT_LT(again.wrench.force.z(), 0.05);
    bench.settle(0.002);
    EXPECT_NEAR(bench.loop.last().wrench.force.z(), 1, 1e-3);
  }
}

TEST(HandLoop, the_geometry_may_be_twenty_milliseconds_late_and_no_more) {
  Bench bench;
  bench.settle(0.002, 10);
  for (int late = 1; late <= 19; ++late)
    EXPECT_EQ(bench.tick({.X_FM = at_depth(0.002)}, false).hand.withheld, Withheld::nothing);
  for (int late = 0; late < 3; ++late) bench.tick({.X_FM = at_depth(0.002)}, false);
  EXPECT_EQ(bench.loop.last().hand.withheld, Withheld::stalled);
}

TEST(HandLoop, rows_that_aged_in_a_pause_are_no_fault_of_the_geometry) {
  Bench bench;
  bench.settle(0.002, 10);
  for (int i = 0; i < 30; ++i) bench.rest(Withheld::paused);
  for (int waiting = 0; waiting < 3; ++waiting) {
    const HandTick& t = bench.tick({.X_FM = at_depth(0.002)}, false);
    EXPECT_EQ(t.hand.withheld, Withheld::paused);
    EXPECT_EQ(t.wrench.force, Vec3::Zero());
  }
  bench.tick(0.002);
  EXPECT_EQ(bench.tick(0.002).hand.withheld, Withheld::nothing);
}

TEST(HandLoop, a_geometry_that_does_not_answer_after_a_pause_has_stalled) {
  Bench bench;
  bench.settle(0.002, 10);
  for (int i = 0; i < 30; ++i) bench.rest(Withheld::paused);
  for (int i = 0; i < 22; ++i) bench.tick({.X_FM = at_depth(0.002)}, false);
  EXPECT_EQ(bench.loop.last().hand.withheld, Withheld::stalled);
}

struct PressOutcome {
  int diverged = 0;   ///< ticks
  double swings = 0;  ///< m, the way of the probe in the last second
};

/// A simulated device of 0.1 kg, whose hand presses it into the block by 3 N.
PressOutcome press(const Coupling& coupling) {
  Bench bench(at_once(), coupling);
  SimulatedDeviceParameters device;
  device.translation = {.inertia = 0.1, .damping = 0.5, .limit = 1e4, .hand_stiffness = 300};
  SimulatedHand simulated(device, dt, 1, bench.probe->mass.com, at_depth(-0.001));
  const Hand hand = simulated.hand();
  simulated.set_target(at_depth(0.01));
  PressOutcome out;
  Vec3 before = at_depth(-0.001).p;
  for (int i = 0; i < 3000; ++i) {
    HandSample sample = hand.sample(dt);
    sample.device->ratio = 1;  // as if it were a real one
    const HandTick& t = bench.tick(sample);
    hand.render(t.wrench);
    out.diverged += t.hand.withheld == Withheld::diverged;
    if (i >= 2000) out.swings += (sample.X_FM.p - before).norm();
    before = sample.X_FM.p;
  }
  return out;
}

// 5000 and 1e5 N/m are both beyond the stable for 0.1 kg at 1 kHz (see simulated_hand_test.cpp).
TEST(HandLoop, a_gain_too_high_buzzes_within_the_limits_of_a_device_and_diverges_without) {
  Coupling coupling;
  coupling.k = 5000;
  coupling.max_force = 8;
  const PressOutcome buzz = press(coupling);
  EXPECT_EQ(buzz.diverged, 0);
  EXPECT_GT(buzz.swings, 0.02);
  coupling.k = 1e5;
  coupling.max_force = 1e4;
  EXPECT_GT(press(coupling).diverged, 0);
}

TEST(HandLoop, another_rate_is_another_delay_of_the_device_in_ticks) {
  Bench bench;
  const DeviceTraits device{.delay = 0.004};
  bench.loop.set_rate(500);
  const auto hold = [&](double depth, int ticks) {
    for (int i = 0; i < ticks; ++i) bench.tick({.X_FM = at_depth(depth), .device = device});
  };
  hold(-0.001, 1);  // gains of a loop that begins in a contact are held below the stable ones
  hold(0.002, 1);
  const double before = bench.loop.last().hand.energy.given;
  hold(0.002, 2);
  // The first wrench acts two ticks of 2 ms after it was asked for, not four.
  bench.tick({.X_FM = at_depth(0.001), .device = device});
  EXPECT_NEAR(bench.loop.last().hand.energy.given - before, 0.001 * 500 * 0.002, 1e-5);
}

TEST(HandLoop, an_untrusted_pose_is_not_followed) {
  Bench bench;
  bench.settle(0.002, 10);
  bench.tick({.X_FM = at_depth(1), .trusted = false});
  EXPECT_EQ(bench.loop.device().p, at_depth(0.002).p);
  EXPECT_NEAR(bench.loop.last().separation.depth, 0.002, 1e-5);
}

TEST(HandLoop, a_jump_of_the_geometry_is_reported_and_not_damped) {
  Coupling coupling;
  coupling.mode = Coupling::Mode::classic;
  coupling.b_t = 100;
  Bench bench(at_once(), coupling);
  bench.settle(0.002, 10);
  EXPECT_FALSE(bench.loop.last().separation.jumped);
  LocalContacts jumped = bench.feed.contacts();
  ++jumped.jumps, ++jumped.falls;
  const HandLoop::Clock clock{.tick = 20, .now = 0.02, .dt = dt};
  const HandTick& t = bench.loop.tick({.X_FM = at_depth(0.003)}, jumped, clock, Withheld::nothing);
  EXPECT_TRUE(t.separation.jumped);
  EXPECT_FALSE(t.separation.lagged);
  EXPECT_NEAR(t.wrench.force.z(), 500 * 0.003, 1e-3);
}

// Reference: the same tick without a jump, and k d of the spring alone against the wall.
TEST(HandLoop, a_probe_that_only_catches_up_is_reported_and_damped) {
  Coupling coupling;
  coupling.mode = Coupling::Mode::damped;
  coupling.b_t = 1;
  const auto felt = [&](unsigned jumps, unsigned falls) {
    Bench bench(at_once(), coupling);
    bench.settle(0.002, 10);
    LocalContacts contacts = bench.feed.contacts();
    contacts.jumps += jumps, contacts.falls += falls;
    const HandLoop::Clock clock{.tick = 20, .now = 0.02, .dt = dt};
    const HandTick& t =
        bench.loop.tick({.X_FM = at_depth(0.003)}, contacts, clock, Withheld::nothing);
    EXPECT_EQ(t.separation.jumped, jumps > 0);
    EXPECT_EQ(t.separation.lagged, jumps > 0 && falls == 0);
    return t.wrench.force.z();
  };
  const double spring = 500 * 0.003, damped = felt(0, 0);
  EXPECT_GT(damped, spring + 0.9 * 0.001 / dt);
  EXPECT_EQ(felt(3, 0), damped);
  EXPECT_NEAR(felt(3, 1), spring, 1e-3);
}

TEST(HandLoop, the_work_on_the_hand_is_that_of_the_wrench_along_its_motion) {
  Bench bench;
  bench.settle(0.001, 5);
  double work = 0, force = bench.loop.last().wrench.force.z(), z = at_depth(0.001).p.z();
  const double before = bench.loop.last().hand.energy.given;
  for (int i = 1; i <= 40; ++i) {
    const Pose X = at_depth(0.001 + 1e-4 * i);
    const HandTick& t = bench.tick({.X_FM = X});
    work += force * (X.p.z() - z);
    force = t.wrench.force.z();
    z = X.p.z();
  }
  EXPECT_LT(work, -1e-3);
  EXPECT_NEAR(bench.loop.last().hand.energy.given - before, work, 1e-9);
}

TEST(HandLoop, a_tick_neither_allocates_nor_frees) {
  HandLoopSettings settings;
  settings.passivity.control = true;
  Bench bench(settings);
  bench.tick(0.001);
  int in_contact = 0;
  test::AllocationCounter counter;
  for (std::uint64_t i = 2; i < 300; ++i) {
    const HandLoop::Clock clock{.tick = i, .now = double(i) * dt, .dt = dt};
    bench.feed.refresh(bench.loop.device(), clock.tick, clock.now, {});
    const Pose X = at_depth(0.003 * std::sin(0.05 * double(i)));
    const HandTick& t = bench.loop.tick({.X_FM = X}, bench.feed.contacts(), clock,
                                        i % 50 == 0 ? Withheld::stopped : Withheld::nothing);
    in_contact += t.separation.status == Status::penetrating;
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_EQ(counter.frees(), 0u);
  EXPECT_GT(in_contact, 30);
}

}  // namespace
}  // namespace sonde::test
