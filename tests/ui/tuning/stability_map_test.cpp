// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/stability_map.hpp"

#include <gtest/gtest.h>

#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::column;
using sonde::test::line;
using sonde::test::results;

/// Two situations of the object norm: good to 100 and to 40 N/m.
TuningResults object_results() { return sonde::test::stable_up_to({100, 40}); }

/// The same two over the dampings 0 and 2; the first alone has 1.
TuningResults classic_results() {
  TuningResults r = results();
  r.mode = Coupling::Mode::classic;
  r.lines = {line(0, GainAxis::translation, {column(0, 100), column(1, 90), column(2, 300)}),
             line(1, GainAxis::translation, {column(0, 40), column(2, 500)})};
  return r;
}

TEST(StabilityMap, the_one_k_has_a_row_for_each_situation_and_hand) {
  const StabilityMap map = stability_map(object_results(), GainAxis::object, "");
  EXPECT_FALSE(map.over_damping);
  ASSERT_EQ(map.rows.size(), 2u);
  EXPECT_EQ(map.rows[0].label, "flat, light");
  EXPECT_EQ(map.rows[1].label, "edge, light");
  EXPECT_EQ(map.low, 40);
  EXPECT_EQ(map.high, 200);
  // Runs of the second at 40 (holds) and 80 (does not): halfway in ratio, the verdict changes.
  const auto& stretches = map.rows[1].stretches;
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[0].map_class, MapClass::stable);
  EXPECT_NEAR(stretches[0].to, std::sqrt(40 * 80), 1e-9);
  EXPECT_EQ(stretches[1].map_class, MapClass::unstable);
  EXPECT_EQ(stretches[1].to, 200);
  EXPECT_EQ(stability_map(object_results(), GainAxis::object, "edge").rows.size(), 1u);
  EXPECT_TRUE(stability_map(object_results(), GainAxis::object, "jammed").rows.empty());
}

TEST(StabilityMap, over_dampings_it_shows_the_worst_situation_of_those_that_all_have) {
  const StabilityMap map = stability_map(classic_results(), GainAxis::translation, "");
  EXPECT_TRUE(map.over_damping);
  ASSERT_EQ(map.rows.size(), 2u) << "damping 1 is not known of every situation";
  EXPECT_EQ(map.rows[0].stable, 40);
  EXPECT_EQ(map.rows[1].stable, 300);
  EXPECT_EQ(map.rows[0].theory_stable, 20);
  EXPECT_EQ(map.rows[0].to, 1);
  EXPECT_EQ(map.rows[1].from, 1);
  EXPECT_EQ(stability_map(classic_results(), GainAxis::translation, "flat").rows.size(), 3u);
}

}  // namespace
}  // namespace sonde::ui::test
