// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

Curves curves_of_ticks(const std::vector<Snapshot>& ticks, std::uint64_t most = 0) {
  Curves curves(most);
  for (const Snapshot& tick : ticks) curves.add(tick, tick.time, nullptr);
  return curves;
}

TEST(Curves, hold_what_the_ticks_say) {
  const std::vector<Snapshot> ticks = made_up_ticks(300);
  BackgroundResult search = made_up_search(1);
  search.nearest = FoundSeparation{0.25, {}};
  search.lower_bound = 0.125;
  Curves curves;
  for (const Snapshot& tick : ticks)
    curves.add(tick, tick.time, tick.time < 0.1 ? nullptr : &search);
  const Snapshot& tick = ticks[207];
  EXPECT_NEAR(curves.at(Curve::held, tick.time), tick.separation.depth, 1e-9);
  EXPECT_NEAR(curves.at(Curve::force, tick.time + 5e-4), tick.wrench.force.norm(), 1e-6);
  EXPECT_NEAR(curves.at(Curve::force_z, tick.time), tick.wrench.force.z(), 1e-6);
  EXPECT_NEAR(curves.at(Curve::age, tick.time), tick.hand.rows.age, 1e-9);
  EXPECT_TRUE(std::isnan(curves.at(Curve::nearest, 0.05)));
  EXPECT_EQ(curves.at(Curve::nearest, 0.15), 0.25);
  EXPECT_EQ(curves.at(Curve::bound, 0.15), 0.125);
  EXPECT_TRUE(std::isnan(curves.at(Curve::straight, 0.15)));
  EXPECT_TRUE(std::isnan(curves.at(Curve::held, -1)));
}

/// What the loop follows to from the pose that was searched is a way out of it: the curve never
/// lies above what the same tick holds.
TEST(Curves, a_way_that_was_followed_counts_where_the_search_found_none_as_near) {
  Snapshot tick = made_up_ticks(1)[0];
  tick.separation.status = Status::penetrating;
  tick.separation.depth = 0.507e-3;
  BackgroundResult search = made_up_search(1);
  search.device = tick.separation.device;
  search.nearest = FoundSeparation{0.53e-3, {}};
  Curves curves;
  curves.add(tick, 0, &search);
  EXPECT_NEAR(curves.at(Curve::nearest, 0), 0.507e-3, 1e-10);
  EXPECT_EQ(with_followed(search, tick.separation).nearest->separated.p,
            tick.separation.separated.p);
  search.nearest->depth = 0.4e-3;  // the search knows better
  curves.add(tick, 1, &search);
  EXPECT_NEAR(curves.at(Curve::nearest, 1), 0.4e-3, 1e-10);
  search.nearest->depth = 0.53e-3;
  search.device.p.x() += 1e-3;  // of another pose
  curves.add(tick, 2, &search);
  EXPECT_NEAR(curves.at(Curve::nearest, 2), 0.53e-3, 1e-10);
}

TEST(Curves, the_oldest_go_where_there_are_more_than_are_kept) {
  const Curves curves = curves_of_ticks(made_up_ticks(1000), 300);
  EXPECT_EQ(curves.size(), 300u);
  EXPECT_NEAR(curves.first_time(), 0.7, 1e-9);
}

TEST(Curves, an_outline_has_the_extremes_of_every_column) {
  const std::vector<Snapshot> ticks = made_up_ticks(5000);
  const Curves curves = curves_of_ticks(ticks);
  constexpr double from = 0.5, to = 4.5;
  constexpr std::size_t columns = 100;
  // The reference: every point, put into its column.
  std::map<long, std::pair<double, double>> extremes, drawn;
  const auto add = [&](auto& into, double time, double value) {
    if (time < from || time >= to) return;
    const long column = std::lround(std::floor((time - from) / ((to - from) / columns)));
    const auto [at, isNew] = into.try_emplace(column, value, value);
    at->second = {std::min(at->second.first, value), std::max(at->second.second, value)};
  };
  for (const Snapshot& tick : ticks)
    add(extremes, tick.time, double(float(tick.wrench.force.norm())));
  const std::vector<CurvePoint> outline = curves.outline(Curve::force, from, to, columns);
  for (const CurvePoint& point : outline) add(drawn, point.time, point.value);
  EXPECT_LE(outline.size(), 2 * columns + 4);
  EXPECT_EQ(drawn, extremes);
  for (std::size_t i = 1; i < outline.size(); ++i) EXPECT_LT(outline[i - 1].time, outline[i].time);
}

TEST(Curves, an_outline_of_few_points_has_them_all_and_one_beyond_each_end) {
  const std::vector<Snapshot> ticks = made_up_ticks(1000);
  const std::vector<CurvePoint> outline =
      curves_of_ticks(ticks).outline(Curve::tick_us, 0.1005, 0.1105, 1000);
  ASSERT_EQ(outline.size(), 12u);
  EXPECT_EQ(outline.front().time, ticks[100].time);
  EXPECT_EQ(outline.back().time, ticks[111].time);
}

/// Half a second of ticks, then two seconds of which nothing is known, then half a second again.
TickLog with_a_gap(bool along_path) {
  TickLog log(made_up_radius, 1000);
  log.along_path = along_path;
  for (Snapshot tick : made_up_ticks(1000)) {
    if (tick.time >= 0.5) tick.time += 2;
    log.add(tick);
  }
  return log;
}

TEST(Curves, are_broken_where_nothing_is_known_of_the_time_between) {
  const auto outline = curves_of(with_a_gap(false)).outline(Curve::force, 0, 3, 100);
  const auto is_break = [](const CurvePoint& point) { return std::isnan(point.value); };
  ASSERT_EQ(std::ranges::count_if(outline, is_break), 1);
  EXPECT_NEAR(std::ranges::find_if(outline, is_break)->time, 1.5, 0.01);
  const auto wide = curves_of(with_a_gap(false)).outline(Curve::force, 0, 900, 100);
  EXPECT_EQ(std::ranges::count_if(wide, is_break), 0) << "it is not seen there";
}

TEST(Curves, are_lines_along_a_path_however_far_apart_its_poses_are) {
  const auto outline = curves_of(with_a_gap(true)).outline(Curve::force, 0, 3, 100);
  for (const CurvePoint& point : outline) EXPECT_FALSE(std::isnan(point.value)) << point.time;
}

/// A search is known for the first and the last fifth of a second only.
TEST(Curves, are_broken_where_a_value_is_missing) {
  BackgroundResult search = made_up_search(1);
  search.nearest = FoundSeparation{0.25, {}};
  BackgroundResult none;
  none.device = search.device;
  for (const double longest : {0.1, std::numeric_limits<double>::infinity()}) {
    Curves curves(0, longest);
    for (const Snapshot& tick : made_up_ticks(1000))
      curves.add(tick, tick.time, tick.time < 0.2 || tick.time > 0.8 ? &search : &none);
    const auto outline = curves.outline(Curve::nearest, 0, 1, 100);
    const auto is_break = [](const CurvePoint& point) { return std::isnan(point.value); };
    ASSERT_EQ(std::ranges::count_if(outline, is_break), 1);
    EXPECT_NEAR(std::ranges::find_if(outline, is_break)->time, 0.5, 0.01);
    EXPECT_EQ(std::ranges::count_if(curves.outline(Curve::force, 0, 1, 100), is_break), 0);
    EXPECT_EQ(std::ranges::count_if(curves.outline(Curve::nearest, 0, 90, 100), is_break), 0)
        << "it is not seen there";
  }
}

TEST(Curves, of_a_log_are_those_of_its_ticks) {
  const std::vector<Snapshot> ticks = made_up_ticks(1200);
  TickLog log(made_up_radius, 1000);
  for (const Snapshot& tick : ticks) log.add(tick);
  const Curves curves = curves_of(log);
  EXPECT_EQ(curves.size(), ticks.size());
  EXPECT_NEAR(curves.at(Curve::torque, ticks[700].time), ticks[700].wrench.torque.norm(), 1e-6);
}

}  // namespace
}  // namespace sonde::test
