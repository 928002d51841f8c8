// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: printed tables of Student's t.
#include "engine/study/identification/student_t.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sonde {
namespace {

TEST(StudentT, is_that_of_the_tables) {
  const std::array<std::array<double, 2>, 5> table{
      {{7, 3.499}, {10, 3.169}, {15, 2.947}, {30, 2.750}, {120, 2.617}}};
  for (const auto& [degrees, t] : table) EXPECT_NEAR(student_t_99(degrees), t, 0.005 * t);
}

}  // namespace
}  // namespace sonde
