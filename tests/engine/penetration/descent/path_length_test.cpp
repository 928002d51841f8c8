// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/path_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde {
namespace {

TEST(PathLength, has_no_limit_until_a_sweep_is_given_up) {
  PathLength path;
  EXPECT_TRUE(std::isinf(path.longest()));
  path.went();
  EXPECT_TRUE(std::isinf(path.longest()));
}

TEST(PathLength, a_path_that_was_given_up_makes_the_next_one_shorter) {
  PathLength path;
  path.gave_up(8, true);
  EXPECT_GT(path.longest(), 0);
  EXPECT_LT(path.longest(), 8);
  path.forget();
  EXPECT_TRUE(std::isinf(path.longest()));
}

// Else every third path would be as long again, and its sweep in vain.
TEST(PathLength, the_length_at_which_a_sweep_was_given_up_is_reached_only_after_many_paths) {
  PathLength path;
  path.gave_up(8, true);
  int paths = 0;
  for (; path.longest() < 8; ++paths) path.went();
  EXPECT_GT(paths, 5);
  EXPECT_LT(paths, 100);
}

TEST(PathLength, one_that_had_only_the_rest_of_a_tick_is_soon_as_long_again) {
  PathLength path;
  path.gave_up(8, false);
  int paths = 0;
  for (; path.longest() < 8; ++paths) path.went();
  EXPECT_LE(paths, 2);
}

}  // namespace
}  // namespace sonde
