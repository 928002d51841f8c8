// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/chart_rim.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/penetration/descent/descent_tuning.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

Chart any_chart(std::mt19937_64& random) {
  const auto pair = test::body_pairs(51).front();
  return Chart(pair.a->mass, test::random_pose(random, *pair.a, *pair.b, 0.8));
}

Vec6 at(const Chart& chart, const Vec3& v, const Vec3& t) {
  Vec6 y;
  y.head<3>() = v.cwiseQuotient(chart.v(Vec6::Ones()));
  y.tail<3>() = t;
  return y;
}

TEST(ChartRim, a_step_inside_stays_as_it_is_and_a_large_turn_is_shortened) {
  std::mt19937_64 random(3);
  const Chart chart = any_chart(random);
  const Vec6 y = at(chart, {0.1, 0.2, 0}, {0.01, 0, 0});
  const Vec6 small = at(chart, {0.01, 0, 0.02}, {0.3, 0, 0});
  EXPECT_EQ(within_chart(chart, y, small), small);
  const Vec6 large = at(chart, {0, 0, 0.6}, {0.3, 0, 0});
  const Vec6 bounded = within_chart(chart, y, large);
  EXPECT_NEAR(chart.v(bounded).norm(), descent_tuning.largest_turn, 1e-12);
  EXPECT_NEAR((bounded - 0.5 * large).norm(), 0, 1e-12);
}

// Reference: where a line meets a ball.
TEST(ChartRim, a_step_out_of_the_chart_ends_at_the_rim) {
  std::mt19937_64 random(4);
  const Chart chart = any_chart(random);
  const Vec6 y = at(chart, {0.9, 0, 0}, Vec3::Zero());
  const Vec6 step = at(chart, {0.2, 0, 0}, {0.04, 0, 0});
  const Vec6 inside = within_chart(chart, y, step);
  EXPECT_NEAR((inside - (Chart::largest_v - 0.9) / 0.2 * step).norm(), 0, 1e-12);
  EXPECT_FALSE(at_rim(chart, y));
  EXPECT_TRUE(at_rim(chart, y + inside));
}

TEST(ChartRim, a_step_from_the_rim_slides_along_it) {
  std::mt19937_64 random(5);
  const Chart chart = any_chart(random);
  const Vec6 y = at(chart, {Chart::largest_v, 0, 0}, Vec3::Zero());
  const Vec6 step = at(chart, {0.1, 0.1, 0}, {0.04, 0, 0});
  const Vec6 along = within_chart(chart, y, step);
  EXPECT_NEAR(chart.v(y + along).norm(), Chart::largest_v, 1e-12);
  EXPECT_GT(chart.v(y + along).y(), 0.05);
  EXPECT_EQ(along.tail<3>(), step.tail<3>());
}

}  // namespace
}  // namespace sonde
