// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/error.hpp"

namespace sonde::bench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

LibraryResult timed(const char* library, double us) { return {library, {{us}}, 1, 0, 0, {}}; }

// 30 / 10 of one pair; the figure of Sonde against itself is none.
TEST(Baseline, ratios_are_those_of_other_libraries) {
  const std::vector<Result> results{{"touch",
                                     "p",
                                     "far",
                                     10,
                                     10,
                                     false,
                                     "",
                                     {timed(ours, 10), timed("FCL", 30), timed("Sonde cold", 50)}}};
  const std::vector<Figure> figures{{"touch", "touch", {"far"}, "FCL", 0, 0},
                                    {"touch", "touch", {"far"}, "Sonde cold", 0, 0},
                                    {"touch", "touch", {"deep"}, "FCL", 0, 0},
                                    {"touch", "touch", {"far"}, "", 0, 0}};
  EXPECT_EQ(ratios_of(results, figures), (Ratios{{"touch / FCL", 3}}));
}

TEST(Baseline, what_is_slower_or_missing_is_named) {
  const Ratios before{{"a / FCL", 10}, {"b / FCL", 10}, {"c / FCL", 10}};
  EXPECT_THAT(slower_than(before, {{"a / FCL", 10 * share_kept}, {"b / FCL", 9}, {"c / FCL", 99}}),
              IsEmpty());
  EXPECT_THAT(slower_than(before, {{"a / FCL", 5.9}, {"b / FCL", 12}}),
              ElementsAre(HasSubstr("a / FCL: 5.9"), HasSubstr("c / FCL: not measured")));
}

TEST(Baseline, a_wider_set_has_at_least_the_speed_of_the_next_narrower_one) {
  const std::string text =
      with_baseline("avx2", {{"a / FCL", 4}}, with_baseline("baseline", {{"a / FCL", 2}}, ""));
  EXPECT_EQ(baseline_for("baseline", text).at("a / FCL"), 2);
  EXPECT_EQ(baseline_for("avx2", text).at("a / FCL"), 4);
  EXPECT_EQ(baseline_for("avx512", text).at("a / FCL"), 4);
  EXPECT_THROW(baseline_for("baseline", with_baseline("avx2", {{"a / FCL", 4}}, "")), InputError);
  EXPECT_THROW(baseline_for("avx2", "[1"), InputError);
  EXPECT_THROW(baseline_for("avx2", R"({"avx2": {"a": "b"}})"), InputError);
}

}  // namespace
}  // namespace sonde::bench
