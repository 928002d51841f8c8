// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/option_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

std::string option_refusal(const std::function<void(StaticOptions&)>& change) {
  StaticOptions options;
  change(options);
  try {
    check(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// Reference: the ranges that static_options.hpp states.
TEST(OptionCheck, options_at_the_ends_of_their_ranges_are_accepted) {
  EXPECT_EQ(option_refusal([](auto&) {}), "accepted");
  EXPECT_EQ(option_refusal([](auto& o) { o.method = Method::pdt; }), "accepted");
  EXPECT_EQ(option_refusal([](auto& o) { o.starts = o.agreement = 1; }), "accepted");
  EXPECT_EQ(option_refusal([](auto& o) { o.share_for_bound = 1; }), "accepted");
  EXPECT_EQ(option_refusal([](auto& o) { o.sure = 1e-9; }), "accepted");
  EXPECT_EQ(option_refusal([](auto& o) { o.budget = {7, 8.5, 9}; }), "accepted");
}

TEST(OptionCheck, an_option_beyond_its_range_is_named) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto named = [](const char* name) {
    return testing::AllOf(testing::StartsWith("the options"), testing::HasSubstr(name));
  };
  EXPECT_THAT(option_refusal([](auto& o) { o.method = Method(2); }), named("method"));
  EXPECT_THAT(option_refusal([](auto& o) { o.budget.steps = -1; }), named("budget.steps"));
  EXPECT_THAT(option_refusal([](auto& o) { o.budget.work = -1; }), named("budget.work"));
  for (const double bad : {-1.0, nan})
    EXPECT_THAT(option_refusal([&](auto& o) { o.budget.microseconds = bad; }),
                named("budget.microseconds"));
  EXPECT_THAT(option_refusal([](auto& o) { o.starts = 0; }), named("starts"));
  EXPECT_THAT(option_refusal([](auto& o) { o.agreement = 0; }), named("agreement"));
  for (const double bad : {0.0, 1.0, -0.5, nan})
    EXPECT_THAT(option_refusal([&](auto& o) { o.sure = bad; }), named("sure must"));
  for (const double bad : {-1e-9, 1.001, nan})
    EXPECT_THAT(option_refusal([&](auto& o) { o.share_for_bound = bad; }),
                named("share_for_bound"));
}

}  // namespace
}  // namespace sonde
