// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_variation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/penetration/search/static_search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(SearchVariation, a_number_of_each_kind_is_set_by_its_name) {
  SearchTuning tuning;
  vary(tuning, "blind=1.5");
  vary(tuning, "most_sketches=64");
  vary(tuning, "most_ends=4");
  EXPECT_EQ(tuning.blind, 1.5);
  EXPECT_EQ(tuning.most_sketches, 64);
  EXPECT_EQ(tuning.most_ends, 4u);
  EXPECT_EQ(tuning.first_ends, search_tuning.first_ends) << "the others stay";
}

TEST(SearchVariation, every_name_can_be_set) {
  for (const std::string& name : names_of_search_tuning()) {
    SearchTuning tuning;
    EXPECT_NO_THROW(vary(tuning, name + "=1")) << name;
  }
}

/// More starts than a round has room for (there was none) and fewer than it expects.
TEST(SearchVariation, every_whole_number_may_be_small_or_large) {
  const Pair pair{test::body(test::sphere(0.03, 12, 16)),
                  test::body(test::torus(0.06, 0.03, 16, 12))};
  const Pose deep{Quat(0.9, 0.3, 0.2, 0.1).normalized(), Vec3(0.05, 0.01, 0.005)};
  int whole = 0;
  for (const std::string& name : names_of_search_tuning()) {
    SearchTuning tuning;
    try {
      vary(tuning, name + "=1.5");
      continue;  // it need not be whole
    } catch (const std::invalid_argument&) {
      ++whole;
    }
    for (const char* value : {"1", "40"}) {
      vary(tuning, name + '=' + value);
      const Separation found = separate_static(pair, deep, {}, tuning);
      EXPECT_EQ(found.status, Status::penetrating) << name << '=' << value << ": " << found.reason;
    }
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
  for (const char* wrong : {"", "blind", "blind=", "blind=x", "blind=-1", "blind=inf", "blind=nan",
                            "most_sketches=1.5", "most_ends=-1", "nothing=1", "=1", "blind=1 "})
    EXPECT_THROW(vary(tuning, wrong), std::invalid_argument) << wrong;
  EXPECT_EQ(tuning.blind, search_tuning.blind);
}

}  // namespace
}  // namespace sonde
