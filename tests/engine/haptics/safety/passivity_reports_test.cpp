// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of a device that reports less often than the servo runs. References: sums by hand, and
// the work of each tick's wrench along the motion that only the test knows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/haptics/safety/passivity.hpp"

namespace sonde {
namespace {

constexpr double between_ticks = 1e-3;  // s
constexpr int intervals[] = {1, 2, 5, 10};

MassProperties reporting_probe() {
  MassProperties m;
  m.inertia = Vec3(4e-4, 5e-4, 6e-4);
  m.radius = 0.03;
  return m;
}

Wrench upward(double force) { return {.force = Vec3(0, 0, force)}; }

/// Passes on every `every`th pose of a probe at height z.
class Reports {
 public:
  Reports(Passivity& passivity, int every) : passivity_(passivity), every_(every) {}
  void observe(double z) {
    const bool reports = ++i_ % every_ == 0;
    if (reports) last_ = z;
    passivity_.observe({Quat::Identity(), Vec3(0, 0, last_)}, between_ticks, false,
                       reports ? every_ * between_ticks : 0);
  }

 private:
  Passivity& passivity_;
  int every_, i_ = 0;
  double last_ = 0;
};

// At 0.1 m/s for 40 ms, against a damping of 0.5 N·s/m: a loss of 0.5 · 0.1² · 0.04 J. The force of
// tick i is 1 + i/100 N and acts `late` ticks later; those that act are i = 0 … n − 1 with
// n = 40 − late, a sum of n + n (n − 1)/200 N, along 0.1 mm each.
TEST(PassivityReports, the_work_is_that_of_every_wrench_since_the_last_report) {
  for (const int every : intervals)
    for (const int late : {0, 2, 7}) {
      Passivity passivity(reporting_probe(), {.device_damping = 0.5, .delay = late * between_ticks},
                          between_ticks);
      passivity.restart({});
      Reports reports(passivity, every);
      for (int i = 0; i < 40; ++i) {
        passivity.rendered(upward(1 + 0.01 * i));
        reports.observe(1e-4 * (i + 1));
      }
      const double n = 40 - late;
      const double work = 1e-4 * (n + n * (n - 1) / 200);
      EXPECT_NEAR(passivity.energy().given, work, 1e-12) << every << ' ' << late;
      // A device without delay is pushed all the time.
      if (late > 0) continue;
      EXPECT_NEAR(passivity.energy().excess, work - 0.5 * 0.01 * 0.04, 1e-12) << every;
    }
}

TEST(PassivityReports, a_turn_is_work_of_every_torque_since_the_last_report) {
  for (const int every : intervals) {
    Passivity passivity(reporting_probe(), {}, between_ticks);
    passivity.restart({});
    for (int i = 0; i < every; ++i) {
      passivity.rendered({.torque = Vec3(0, 0.01 * (i + 1), 0)});
      const bool reports = i + 1 == every;
      const double angle = reports ? 0.001 * every : 0;
      passivity.observe({Quat(Eigen::AngleAxisd(angle, Vec3::UnitY())), Vec3::Zero()},
                        between_ticks, false, reports ? every * between_ticks : 0);
    }
    EXPECT_NEAR(passivity.energy().given, 0.001 * 0.01 * every * (every + 1) / 2, 1e-12) << every;
  }
}

struct Swayed {
  double taken = 0;  ///< J, by what was taken off the wrench, along the true motion
  double work = 0;   ///< J, of the wrench along the true motion
  double most = 0;   ///< N, taken off
  double excess = 0;
  HandEnergy energy;
};

/// A contact that has given 4 mJ pushes by half a newton, while the hand goes up and down once in
/// half a second, by up to 3 cm/s.
Swayed swayed(int every) {
  constexpr double way = 0.03 / (4 * std::numbers::pi);
  Passivity passivity(reporting_probe(), {.control = true, .max_damping = 4}, between_ticks);
  passivity.restart({Quat::Identity(), Vec3(0, 0, -0.001)});
  passivity.rendered(upward(4));
  passivity.observe({}, between_ticks);
  passivity.rendered(upward(0.5));
  Swayed out;
  out.excess = passivity.energy().excess;
  const double given = passivity.energy().given;
  Reports reports(passivity, every);
  Vec3 taken = Vec3::Zero();
  double before = 0;
  Wrench acts = upward(0.5);
  for (int i = 1; i <= 500; ++i) {
    const double z = way * std::sin(4 * std::numbers::pi * i * between_ticks);
    out.work += acts.force.z() * (z - before);
    out.taken += taken.z() * (z - before);
    before = z;
    reports.observe(z);
    acts = passivity.control(upward(0.5));
    passivity.rendered(acts);
    taken = upward(0.5).force - acts.force;
    out.most = std::max(out.most, taken.norm());
  }
  out.energy = passivity.energy();
  out.energy.given -= given;
  return out;
}

// The mean of 4 N·s/m times the square of the speed: 4 · 0.03²/2 · 0.5 J = 0.9 mJ.
TEST(PassivityReports, the_controller_takes_as_much_as_it_says_however_often_the_device_reports) {
  for (const int every : intervals) {
    const Swayed s = swayed(every);
    EXPECT_NEAR(s.excess, 4e-3, 1e-9);
    EXPECT_NEAR(s.taken, 0.9e-3, 0.05e-3) << every;
    EXPECT_NEAR(s.energy.dissipated, s.taken, 0.05 * s.taken) << every;
    EXPECT_NEAR(s.energy.given, s.work, 0.02 * s.taken) << every;
    EXPECT_NEAR(s.energy.excess, s.excess - s.taken, 0.02 * s.taken) << every;
    EXPECT_LE(s.most, 4 * 0.03 * (1 + 1e-3)) << every;
  }
}

/// The speed that was reported last brakes until the next report is due, 10 ms at most.
TEST(PassivityReports, a_device_that_falls_silent_is_braked_no_longer_than_its_motion_is_known) {
  for (const auto& [since, ticks] :
       {std::pair(0.001, 1), std::pair(0.005, 5), std::pair(0.5, 10)}) {
    Passivity passivity(reporting_probe(), {.control = true, .max_damping = 4}, between_ticks);
    passivity.restart({});
    passivity.rendered(upward(1));
    const Pose X{Quat::Identity(), Vec3(0, 0, 0.1 * since)};
    int braked = 0;
    for (int i = 0; i < 30; ++i) {
      passivity.observe(X, between_ticks, false, i == 0 ? since : 0);
      const Wrench got = passivity.control(upward(1));
      braked += got.force.z() < 1;
      passivity.rendered(got);
    }
    EXPECT_EQ(braked, ticks) << since;
  }
}

TEST(PassivityReports, what_pushed_before_a_pause_did_no_work_in_it) {
  Passivity passivity(reporting_probe(), {}, between_ticks);
  passivity.restart({});
  for (int i = 0; i < 3; ++i) {
    passivity.rendered(upward(1));
    passivity.observe({}, between_ticks);
  }
  passivity.rested();
  passivity.observe({Quat::Identity(), Vec3(0, 0, 0.05)}, between_ticks, false, 0.005);
  EXPECT_EQ(passivity.energy().given, 0);
}

TEST(PassivityReports, only_the_damping_that_was_rendered_is_said_to_be_taken_out) {
  for (const double share : {0.0, 0.25, 1.0}) {
    Passivity passivity(reporting_probe(), {.control = true, .max_damping = 4}, between_ticks);
    passivity.restart({});
    passivity.rendered(upward(2));
    passivity.observe({Quat::Identity(), Vec3(0, 0, 1e-4)}, between_ticks);
    const Wrench wished = passivity.control(upward(2));
    EXPECT_NEAR(wished.force.z(), 2 - 4 * 0.1, 1e-12);
    passivity.rendered(upward(2 + share * (wished.force.z() - 2)));
    EXPECT_NEAR(passivity.energy().dissipated, share * 4 * 0.1 * 1e-4, 1e-12) << share;
  }
}

TEST(PassivityReports, a_pose_beyond_what_can_be_computed_with_is_no_work) {
  for (const double far : {1e160, 1e307, -1e307}) {
    Passivity passivity(reporting_probe(), {.control = true, .max_damping = 4}, between_ticks);
    passivity.restart({});
    passivity.rendered(upward(1));
    passivity.observe({Quat::Identity(), Vec3(0, 0, 1e-4)}, between_ticks);
    passivity.rendered(passivity.control(upward(100)));
    const double excess = passivity.energy().excess;
    passivity.observe({Quat::Identity(), Vec3(0, 0, far)}, between_ticks);
    const Wrench got = passivity.control(upward(1));
    EXPECT_EQ(got.force, upward(1).force) << far;
    EXPECT_EQ(passivity.energy().excess, excess) << far;
  }
}

}  // namespace
}  // namespace sonde
