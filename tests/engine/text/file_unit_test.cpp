// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/file_unit.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

// Reference: the international inch and foot of 1959, and the prefixes of the SI.
TEST(FileUnit, sizes) {
  EXPECT_EQ(unit_in_metres("m"), 1);
  EXPECT_EQ(unit_in_metres("cm"), 0.01);
  EXPECT_EQ(unit_in_metres("mm"), 0.001);
  EXPECT_EQ(unit_in_metres("um"), 1e-6);
  EXPECT_EQ(unit_in_metres("in"), 0.0254);
  EXPECT_EQ(unit_in_metres("ft"), 0.3048);
  EXPECT_FALSE(unit_in_metres("M"));
  EXPECT_FALSE(unit_in_metres(""));
}

TEST(FileUnit, names_are_those_of_the_sizes) {
  EXPECT_EQ(file_unit_names().size(), file_units().size());
  for (const std::string& name : file_unit_names())
    EXPECT_EQ(unit_name(*unit_in_metres(name)), name);
  EXPECT_FALSE(unit_name(0.5));
}

}  // namespace
}  // namespace sonde
