// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gap_reach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// Triangles of one area, each at one gap.
GapField of_gaps(const std::vector<double>& gaps) {
  GapField field;
  for (const double gap : gaps) {
    const auto first = static_cast<std::uint32_t>(field.gaps.size());
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)})
      field.patch.vertices.push_back(x), field.gaps.push_back(gap);
    field.patch.triangles.push_back({first, first + 1, first + 2});
  }
  return field;
}

/// Without the view of the fixture.
class GapReach : public ViewportAloneTest {
 protected:
  void SetUp() override {}
  /// Of a probe of 40 mm that hangs so far above a block.
  static double reach_above(double gap) {
    return fitted_reach(*cube(0.04), *cube(0.1), {Quat::Identity(), Vec3(0, 0, 0.07 + gap)});
  }
};

TEST_F(GapReach, is_a_few_times_the_clearance_of_a_fit) {
  EXPECT_DOUBLE_EQ(reach_above(1e-4), 5e-4);
  EXPECT_DOUBLE_EQ(reach_above(3e-5), 1e-4);
  EXPECT_DOUBLE_EQ(reach_above(6e-4), 2e-3);
}

// Reference: 12 % of the probe's radius of 34.6 mm is 4.2 mm.
TEST_F(GapReach, suits_the_probe_where_it_touches) { EXPECT_DOUBLE_EQ(reach_above(0), 2e-3); }

TEST_F(GapReach, goes_further_where_nothing_is_so_near) {
  EXPECT_DOUBLE_EQ(reach_above(9e-3), 0.02) << "45 mm, rounded down";
  EXPECT_DOUBLE_EQ(reach_above(3), 2e-3) << "far away, nothing is to be coloured";
}

TEST_F(GapReach, is_all_that_is_near_where_the_gaps_are_spread) {
  std::vector<double> spread;  // as of a ball that touches a plane
  for (int i = 0; i < 1000; ++i) spread.push_back(1e-5 * (i + 0.5));
  EXPECT_EQ(fitted_reach(of_gaps(spread), {}, 0.01, 1e-7), 0.01);
  EXPECT_EQ(fitted_reach({}, of_gaps(spread), 0.01, 1e-7), 0.01);
  EXPECT_EQ(fitted_reach({}, {}, 0.01, 1e-7), 0.01);
}

TEST_F(GapReach, a_rod_partly_in_a_bore_has_the_scale_of_the_bore) {
  std::vector<double> gaps(200, 2e-5);
  for (int i = 0; i < 800; ++i) gaps.push_back(1e-5 * (i + 5));  // of what sticks out
  EXPECT_DOUBLE_EQ(fitted_reach(of_gaps(gaps), {}, 0.01, 1e-7), 1e-4);
  // It touches the bore at one side, and is twice as far from it at the other.
  for (std::size_t i = 0; i < 200; ++i) gaps[i] = 2e-5 * (1 + std::cos(0.0157 * (double(i) + 0.5)));
  EXPECT_DOUBLE_EQ(fitted_reach(of_gaps(gaps), {}, 0.01, 1e-7), 1e-4);
}

}  // namespace
}  // namespace sonde::ui::test
