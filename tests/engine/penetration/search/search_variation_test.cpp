// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_variation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/penetration/search/static_search.hpp"
#include "tests/support/conforming_scene.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(SearchVariation, a_number_of_each_kind_is_set_by_its_name) {
  SearchTuning tuning;
  vary(tuning, "rough_error=1.5");
  vary(tuning, "most_sketches=64");
  vary(tuning, "few_ends=4");
  EXPECT_EQ(tuning.rough_error, 1.5);
  EXPECT_EQ(tuning.most_sketches, 64);
  EXPECT_EQ(tuning.few_ends, 4u);
  EXPECT_EQ(tuning.first_ends, search_tuning.first_ends) << "the others stay";
}

TEST(SearchVariation, every_name_can_be_set) {
  for (const std::string& name : names_of_search_tuning()) {
    SearchTuning tuning;
    EXPECT_NO_THROW(vary(tuning, name + "=2")) << name;
  }
}

TEST(SearchVariation, what_would_never_end_or_divide_by_zero_is_refused) {
  SearchTuning tuning;
  for (const char* wrong :
       {"ball_growth=1", "ball_growth=1.0000001", "ball_growth=0.5", "smallest_ball=0",
        "smallest_ball=1e-300", "few_ends=0", "first_ends=0"})
    EXPECT_THROW(vary(tuning, wrong), std::invalid_argument) << wrong;
  EXPECT_EQ(tuning.ball_growth, search_tuning.ball_growth) << "what is refused changes nothing";
}

TEST(SearchVariation, every_number_may_be_as_small_as_it_can_be_set) {
  const test::ConformingScene scene = test::cylinder_in_hole();
  const Pair pair(test::body(scene.probe({})), test::body(scene.fixed({})));
  for (const std::string& name : names_of_search_tuning()) {
    SearchTuning tuning;
    for (const char* least : {"=0", "=1e-6", "=1", "=1.01"}) try {
        vary(tuning, name + least);
        break;
      } catch (const std::invalid_argument&) {
        continue;
      }
    const Separation found = separate_static(pair, scene.path[60], {}, tuning);
    EXPECT_EQ(found.status, Status::penetrating) << name << ": " << found.reason;
  }
}

/// More starts than a round has room for.
TEST(SearchVariation, every_whole_number_may_be_large) {
  // A rod pressed into its hole: sketches do not show the hole, so overlaps are pushed apart too.
  const test::ConformingScene scene = test::cylinder_in_hole();
  const Pair pair(test::body(scene.probe({})), test::body(scene.fixed({})));
  const Pose deep = scene.path[60];
  int whole = 0;
  for (const std::string& name : names_of_search_tuning()) {
    SearchTuning tuning;
    try {
      vary(tuning, name + "=1.5");
      continue;  // it need not be whole
    } catch (const std::invalid_argument&) {
      ++whole;
    }
    vary(tuning, name + "=40");
    const Separation found = separate_static(pair, deep, {}, tuning);
    EXPECT_EQ(found.status, Status::penetrating) << name << "=40: " << found.reason;
  }
  EXPECT_GT(whole, 10);
}

TEST(SearchVariation, a_complaint_about_a_name_lists_every_name) {
  SearchTuning tuning;
  try {
    vary(tuning, "nothing=1");
    FAIL() << "there is no such number";
  } catch (const std::invalid_argument& error) {
    const std::string said = error.what();
    for (const std::string& name : names_of_search_tuning())
      EXPECT_NE(said.find(name), std::string::npos) << name;
  }
}

TEST(SearchVariation, what_is_no_number_of_the_search_is_refused) {
  SearchTuning tuning;
  for (const char* wrong : {"", "reach", "reach=", "reach=x", "reach=-1", "reach=inf", "reach=nan",
                            "most_sketches=1.5", "few_ends=-1", "nothing=1", "=1", "reach=1 "})
    EXPECT_THROW(vary(tuning, wrong), std::invalid_argument) << wrong;
  EXPECT_EQ(tuning.reach, search_tuning.reach);
}

}  // namespace
}  // namespace sonde
