// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/quantity.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

TEST(Quantity, times_have_a_unit_or_are_seconds) {
  EXPECT_DOUBLE_EQ(time_in("1ms", "t"), 1e-3);
  EXPECT_DOUBLE_EQ(time_in("800us", "t"), 8e-4);
  EXPECT_DOUBLE_EQ(time_in("800µs", "t"), 8e-4);
  EXPECT_DOUBLE_EQ(time_in("0.02s", "t"), 0.02);
  EXPECT_DOUBLE_EQ(time_in("0.02", "t"), 0.02);
  EXPECT_DOUBLE_EQ(time_in("1e-3", "t"), 1e-3);
}

TEST(Quantity, shares_are_per_cent_or_parts_of_one) {
  EXPECT_DOUBLE_EQ(share_in("1%", "a"), 0.01);
  EXPECT_DOUBLE_EQ(share_in("0.5%", "a"), 0.005);
  EXPECT_DOUBLE_EQ(share_in("0.01", "a"), 0.01);
}

TEST(Quantity, what_is_no_good_is_refused_by_its_name) {
  for (const char* text :
       {"0", "0ms", "-1ms", "nan", "inf", "infs", "", "ms", "1 m s", "1min", "1e400", "1e-400s"})
    EXPECT_THROW(time_in(text, "--time"), InputError) << text;
  for (const char* text : {"0%", "0", "-1%", "nan", "nan%", "100%", "1000%", "1", "", "%", "1%%"})
    EXPECT_THROW(share_in(text, "--accuracy"), InputError) << text;
  try {
    share_in("1000%", "--accuracy");
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "--accuracy: \"1000%\" is not a share above 0 and below 100%, as in 1% or 0.01");
  }
}

}  // namespace
}  // namespace sonde
