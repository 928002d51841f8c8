// SPDX-License-Identifier: GPL-3.0-or-later
// Hardly an assertion here is about time: a loaded machine may stop any thread for as long as it
// likes.
#include "engine/haptics/loop/servo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <thread>

#include "tests/engine/haptics/loop/at_depth.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::at_depth;

using namespace std::chrono_literals;

struct BoxAndBlock {
  std::shared_ptr<const Body> probe = test::body(test::box({0.02, 0.03, 0.05}));
  std::shared_ptr<const Body> fixed = test::body(test::box({0.3, 0.3, 0.1}));
};

/// The force whole from the first tick on: its ramp and its slew are tested elsewhere.
ServoSettings at_once() {
  ServoSettings settings;
  settings.safety.ramp_time = settings.safety.force_slew = settings.safety.torque_slew = 0;
  settings.safety.stalled_after = 1e9;  // on a loaded machine any thread may be stopped
  return settings;
}

Coupling stiffness(double k) {
  Coupling c;
  c.k = k;
  return c;
}

/// Waits until the newest snapshot is as wanted; for a minute, which only a hung servo takes.
bool wait_for(Servo& servo, const std::function<bool(const Snapshot&)>& wanted) {
  for (const auto end = std::chrono::steady_clock::now() + 60s;
       std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(1ms))
    if (const Snapshot* s = servo.latest(); s && wanted(*s)) return true;
  return false;
}
bool wait_for_ticks(Servo& servo, std::uint64_t more) {
  const Snapshot* now = servo.latest();
  const std::uint64_t goal = (now ? now->tick : 0) + more;
  return wait_for(servo, [&](const Snapshot& s) { return s.tick >= goal; });
}
bool is_at(const Snapshot& s, const Pose& X) { return s.separation.device.p == X.p; }

class ServoTest : public testing::Test {
 protected:
  BoxAndBlock bodies;
  Servo servo{{bodies.probe, bodies.fixed}, Method::pdg, stiffness(500), at_once()};
};

TEST_F(ServoTest, has_no_snapshot_before_the_first_tick) {
  EXPECT_EQ(servo.latest(), nullptr);
  EXPECT_FALSE(servo.running());
  servo.set_paused(true);
  servo.start(at_depth(0.001));
  EXPECT_TRUE(servo.running());
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(servo.latest(), nullptr);
}

TEST_F(ServoTest, ticks_and_measures_its_rate) {
  servo.start(at_depth(0.001));
  ASSERT_TRUE(wait_for_ticks(servo, 300));
  const Snapshot s = *servo.latest();
  EXPECT_GT(s.rate_hz, 0);
  EXPECT_LT(s.rate_hz, 2000);
  EXPECT_GT(s.time, 0);
  EXPECT_GT(s.tick_us, 0);
  EXPECT_LE(s.late, s.tick);
  // Never ahead of the clock by more than the one tick that is made up for.
  EXPECT_LE(static_cast<double>(s.tick), s.time * 1000 + 3);
  ASSERT_TRUE(wait_for_ticks(servo, 10));
  EXPECT_GT(servo.latest()->tick, s.tick);
  EXPECT_GT(servo.latest()->time, s.time);
}

TEST_F(ServoTest, starts_separated_where_the_probe_overlaps) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for_ticks(servo, 3));
  const Snapshot s = *servo.latest();
  EXPECT_EQ(s.separation.status, Status::penetrating);
  EXPECT_NEAR(s.separation.depth, 0.002, 1e-5);
  EXPECT_NEAR(s.wrench.force.z(), 1, 1e-2);
}

TEST_F(ServoTest, the_newest_device_pose_wins) {
  servo.start(at_depth(-0.01));
  for (int i = 1; i <= 1000; ++i) servo.set_device_pose(at_depth(0.001, 1e-5 * i));
  ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) { return is_at(s, at_depth(0.001, 1e-2)); }));
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(is_at(*servo.latest(), at_depth(0.001, 1e-2)));
    std::this_thread::sleep_for(1ms);
  }
}

TEST_F(ServoTest, the_device_pose_is_used_as_it_comes) {
  servo.start(at_depth(-0.01));
  const Pose pose{Quat(Eigen::AngleAxisd(0.123, Vec3::UnitZ())), Vec3(0.01, 0.02, 0.0745)};
  servo.set_device_pose(pose);
  ASSERT_TRUE(wait_for(servo, [&](const Snapshot& s) { return is_at(s, pose); }));
  EXPECT_LT((servo.latest()->separation.device.q.coeffs() - pose.q.coeffs()).norm(), 1e-15);
}

/// A time that is over before anything was looked at leaves every answer open.
TEST_F(ServoTest, the_time_of_the_geometry_changes_while_it_runs) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) { return s.separation.converged; }));
  servo.set_budget_us(1e-3);
  servo.set_device_pose(at_depth(0.004, 0.01));
  ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) {
    return is_at(s, at_depth(0.004, 0.01)) && !s.separation.converged && s.hand.rows.residual > 0;
  }));
  servo.set_budget_us(0);
  EXPECT_TRUE(wait_for(servo, [](const Snapshot& s) {
    return s.separation.converged && s.hand.rows.residual < 1e-3;
  }));
}

TEST_F(ServoTest, a_coupling_change_acts) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) { return s.wrench.force.z() > 0.9; }));
  EXPECT_LT(servo.latest()->wrench.force.z(), 1.1);
  servo.set_coupling(stiffness(1500));
  EXPECT_TRUE(wait_for(servo, [](const Snapshot& s) { return s.wrench.force.z() > 2.9; }));
  servo.stop();
  servo.start(at_depth(0.002));  // and stays across a restart
  ASSERT_TRUE(wait_for_ticks(servo, 1));
  EXPECT_GT(servo.latest()->wrench.force.z(), 2.9);
}

TEST_F(ServoTest, a_coupling_change_in_contact_does_not_knock) {
  Coupling limited = stiffness(1500), raised = limited;
  limited.max_force = 1;
  raised.max_force = 3;
  Coupling classic = stiffness(500);
  classic.mode = Coupling::Mode::classic;
  classic.k_t = 1500;
  const std::pair<Coupling, Coupling> changes[] = {
      {stiffness(500), stiffness(1500)}, {stiffness(500), classic}, {limited, raised}};
  for (const auto& [from, to] : changes) {
    servo.set_coupling(from);
    servo.start(at_depth(0.002));
    ASSERT_TRUE(wait_for(
        servo, [](const Snapshot& s) { return s.wrench.force.z() > 0.99 && s.hand.share >= 1; }));
    Snapshot before;
    while (servo.next_tick(before)) continue;
    servo.set_coupling(to);
    ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) { return s.wrench.force.z() > 2.99; }));
    // From 1 N to 3 N in a tenth of a second: no faster, however late a tick comes.
    double largest = 0;
    for (Snapshot tick; servo.next_tick(tick); before = tick) {
      const double step = tick.wrench.force.z() - before.wrench.force.z();
      EXPECT_LE(step, 1.01 * 20 * (tick.time - before.time) + 1e-6) << tick.tick;
      largest = std::max(largest, step);
    }
    EXPECT_GT(largest, 0) << "the change is among these ticks";
  }
}

TEST_F(ServoTest, a_paused_loop_keeps_its_last_snapshot_and_computes_nothing) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for_ticks(servo, 5));
  servo.set_paused(true);
  ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) { return s.paused; }));
  const Snapshot s = *servo.latest();
  EXPECT_EQ(s.separation.status, Status::penetrating);
  servo.set_device_pose(at_depth(0.004));
  std::this_thread::sleep_for(30ms);
  EXPECT_EQ(servo.latest()->tick, s.tick);
  EXPECT_TRUE(servo.running());
  servo.set_paused(false);
  ASSERT_TRUE(wait_for(servo, [](const Snapshot& now) { return !now.paused; }));
  EXPECT_TRUE(wait_for(servo, [](const Snapshot& now) { return is_at(now, at_depth(0.004)); }));
  EXPECT_GT(servo.latest()->tick, s.tick);
}

TEST_F(ServoTest, a_pause_is_among_the_ticks_and_is_no_stall) {
  ServoSettings settings = at_once();
  settings.safety.stalled_after = 1;  // s: a pause is longer, a busy machine's stop is not
  Servo watched({bodies.probe, bodies.fixed}, Method::pdg, stiffness(500), settings);
  watched.start(at_depth(0.002));
  ASSERT_TRUE(wait_for_ticks(watched, 5));
  watched.set_paused(true);
  ASSERT_TRUE(wait_for(watched, [](const Snapshot& s) { return s.paused; }));
  std::this_thread::sleep_for(1200ms);
  const std::uint64_t last = watched.latest()->tick;
  watched.set_paused(false);
  ASSERT_TRUE(wait_for(watched, [&](const Snapshot& s) {
    return s.tick > last && s.hand.withheld == Withheld::nothing;
  }));
  int pauses = 0;
  for (Snapshot s; watched.next_tick(s);) {
    pauses += s.paused;
    if (s.paused) {
      EXPECT_EQ(s.tick, last);
    }
    EXPECT_TRUE(s.hand.withheld == Withheld::nothing || s.hand.withheld == Withheld::paused)
        << words(s.hand.withheld);
  }
  EXPECT_EQ(pauses, 1);
}

TEST_F(ServoTest, another_rate_acts_at_once_and_stays) {
  servo.start(at_depth(-0.01));
  ASSERT_TRUE(wait_for_ticks(servo, 5));
  const auto largest =
      [&] {  // ticks in a second: never ahead of the clock, but for one made up for
        Snapshot first, last;
        while (servo.next_tick(last)) continue;
        const std::uint64_t from = servo.latest()->tick;
        EXPECT_TRUE(wait_for(servo, [&](const Snapshot& s) { return s.tick > from + 50; }));
        servo.next_tick(first);
        for (last = first; servo.next_tick(last);) continue;
        return static_cast<double>(last.tick - first.tick - 2) / (last.time - first.time);
      };
  servo.set_rate(100);
  EXPECT_LT(largest(), 150);
  servo.stop();
  servo.start(at_depth(-0.01));
  ASSERT_TRUE(wait_for_ticks(servo, 5));
  EXPECT_LT(largest(), 150);
}

TEST_F(ServoTest, every_tick_is_handed_out_once_and_in_order) {
  Snapshot s;
  EXPECT_FALSE(servo.next_tick(s));
  servo.start(at_depth(0.002));
  for (std::uint64_t expected = 1; expected <= 200;) {
    if (!servo.next_tick(s)) {
      std::this_thread::sleep_for(1ms);
      continue;
    }
    ASSERT_EQ(s.tick, expected + servo.ticks_dropped());  // none, unless this thread slept for 4 s
    ++expected;
  }
  servo.stop();
  std::uint64_t last = s.tick;
  while (servo.next_tick(s)) last = s.tick;
  EXPECT_EQ(last, servo.latest()->tick);
  servo.start(at_depth(0.002));  // begins anew
  while (!servo.next_tick(s)) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(s.tick, 1u);
}

TEST_F(ServoTest, stops_and_keeps_the_last_snapshot) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for_ticks(servo, 5));
  servo.stop();
  EXPECT_FALSE(servo.running());
  const std::uint64_t last = servo.latest()->tick;
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(servo.latest()->tick, last);
  servo.stop();  // twice does no harm
}

TEST_F(ServoTest, a_restart_sets_the_loop_back_to_a_pose) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for_ticks(servo, 50));
  servo.set_device_pose(at_depth(0.004));
  servo.start(at_depth(0.001, 0.01));  // while running
  ASSERT_TRUE(wait_for_ticks(servo, 1));
  const Snapshot s = *servo.latest();
  EXPECT_TRUE(is_at(s, at_depth(0.001, 0.01)));  // neither the old pose nor its last wish
  EXPECT_NEAR(s.separation.depth, 0.001, 1e-5);
}

TEST_F(ServoTest, a_pose_that_is_no_pose_gives_no_force_and_the_next_good_one_works) {
  servo.start(at_depth(0.002));
  ASSERT_TRUE(wait_for_ticks(servo, 5));
  Pose bad = at_depth(0.002);
  bad.p.x() = std::numeric_limits<double>::quiet_NaN();
  servo.set_device_pose(bad);
  ASSERT_TRUE(
      wait_for(servo, [](const Snapshot& s) { return s.hand.withheld == Withheld::not_finite; }));
  EXPECT_EQ(servo.latest()->wrench.force, Vec3::Zero());
  servo.set_device_pose(at_depth(0.003));
  ASSERT_TRUE(
      wait_for(servo, [](const Snapshot& s) { return s.hand.withheld == Withheld::nothing; }));
  EXPECT_NEAR(servo.latest()->separation.depth, 0.003, 1e-5);
  EXPECT_GT(servo.latest()->wrench.force.z(), 1);
}

TEST(Servo, a_slow_loop_stops_without_waiting_for_its_tick) {
  const BoxAndBlock bodies;
  ServoSettings settings;
  settings.rate_hz = 1;
  Servo servo({bodies.probe, bodies.fixed}, Method::pdg, {}, settings);
  servo.start(at_depth(0.001));
  ASSERT_TRUE(wait_for_ticks(servo, 1));
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) {
    servo.stop();
    servo.start(at_depth(0.001));
    ASSERT_TRUE(wait_for(servo, [](const Snapshot& s) { return s.tick >= 1; }));
  }
  // Near 20 s if each stop waited for its tick, under half a second as it is.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

TEST(Servo, a_rate_that_is_none_does_not_spin_or_hang) {
  const BoxAndBlock bodies;
  for (const double rate : {0.0, -5.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    ServoSettings settings;
    settings.rate_hz = rate;
    Servo servo({bodies.probe, bodies.fixed}, Method::pdg, {}, settings);
    servo.start(at_depth(-0.01));
    EXPECT_TRUE(wait_for_ticks(servo, 1)) << rate;
  }
}

// Under ThreadSanitizer this is the test that counts.
TEST_F(ServoTest, takes_poses_couplings_and_pauses_from_a_busy_window) {
  servo.start(at_depth(-0.01));
  int in_contact = 0;
  for (int i = 0; i < 3000; ++i) {
    servo.set_device_pose(at_depth(0.002 * (i % 10) / 10.0));
    if (i % 3 == 0) servo.set_coupling(stiffness(100 + i % 7));
    if (i % 100 == 0) servo.set_paused(i % 200 == 0);
    if (const Snapshot* s = servo.latest()) {
      ASSERT_NE(s->separation.status, Status::failed);
      // Force and separation are of one tick: along it, and no stiffer than what was ever set.
      const double t = s->separation.translation;
      if (t > 1e-5 && !s->paused) {
        ++in_contact;
        const double k = s->hand.asked.force.norm() / t;
        ASSERT_GT(k, 100 - 1e-6);
        ASSERT_LT(k, 500 + 1e-6);
        ASSERT_LE(s->wrench.force.norm(), 500.01 * t);
        ASSERT_LT(s->wrench.force.head<2>().norm(), 1e-3 * t);
      }
    }
    if (i % 50 == 7) std::this_thread::sleep_for(2ms);
  }
  EXPECT_GT(in_contact, 100);
  servo.set_paused(false);
  EXPECT_TRUE(wait_for_ticks(servo, 3));
}

}  // namespace
}  // namespace sonde
