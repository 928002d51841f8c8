// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the loop in step at the same device poses; and a wrench held since the rows were
// made, which is what old rows have to better.
#include "tests/loop/row_age.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct Bodies {
  const char* name;
  std::shared_ptr<const Body> probe, fixed;
  double bottom;
};

std::vector<Bodies> pairs() {
  std::mt19937_64 random(11);
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  return {
      {"box on block", test::body(test::box({0.02, 0.03, 0.05})), block, 0.065},
      {"torus on torus", test::body(test::torus(0.04, 0.015, 32, 20)),
       test::body(test::torus(0.06, 0.02, 32, 20)), 0.025},
      {"soup on block", test::body(test::random_soup(random, 10, 0.05)), block, 0.065},
  };
}

/// A second: down, about in contact, and up.
std::vector<TimedPose> path(const Bodies& pair) {
  std::vector<TimedPose> out;
  for (int i = 0; i <= 1000; ++i) {
    const double turn = 2 * std::numbers::pi * i / 1000.0;
    const double height = pair.bottom + 0.06 * (0.5 + 0.5 * std::cos(turn));
    const Quat q(Eigen::AngleAxisd(0.7 * std::sin(turn), Vec3(1, 2, 3).normalized()));
    out.push_back({i * 1e-3, {q, Vec3(0.01 * std::sin(3 * turn), 0, height)}});
  }
  return out;
}

TEST(RowAge, young_rows_are_in_step_and_old_ones_better_a_held_wrench) {
  for (const Bodies& pair : pairs()) {
    RowAgeOptions options;
    options.ages = {0, 1, 5};
    const auto found = measure_row_age({pair.probe, pair.fixed}, path(pair), options);
    ASSERT_EQ(found.size(), 3u);
    for (const RowAge& r : found) {
      SCOPED_TRACE(testing::Message() << pair.name << ", age " << r.age);
      EXPECT_GT(r.ticks, 100);
      EXPECT_GT(r.largest_force, 1);
      EXPECT_LE(r.force_error.median, r.force_error.p99);
      EXPECT_LE(r.force_error.p99, r.force_error.largest);
      // Of the fastest point of the probe: what a wrench held so long would be wrong by.
      const double held = options.k * r.probe_speed * r.age / options.rate_hz;
      EXPECT_LE(r.force_error.median, 0.1 * held + 5e-4 * r.largest_force);
    }
    EXPECT_LE(found[0].force_error.largest, 1e-3 * found[0].largest_force) << pair.name;
    EXPECT_EQ(found[0].held_back, 0) << pair.name;
  }
}

TEST(RowAge, twice_the_speed_at_twice_the_rate_is_the_same) {
  const Bodies pair = pairs()[1];
  RowAgeOptions slow, fast;
  slow.ages = fast.ages = {2};
  fast.rate_hz = 2 * slow.rate_hz;
  fast.speed = 2;
  const RowAge a = measure_row_age({pair.probe, pair.fixed}, path(pair), slow)[0];
  const RowAge b = measure_row_age({pair.probe, pair.fixed}, path(pair), fast)[0];
  EXPECT_EQ(a.ticks, b.ticks);
  EXPECT_NEAR(a.force_error.p99, b.force_error.p99, 1e-6 * a.largest_force);
  EXPECT_NEAR(2 * a.probe_speed, b.probe_speed, 1e-6 * b.probe_speed);
}

}  // namespace
}  // namespace sonde
