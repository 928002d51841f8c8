// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/nearest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace sonde {
namespace {

TEST(Nearest, edit_distance_counts_letters) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("probe", "probe"), 0u);
  EXPECT_EQ(edit_distance("prob", "probe"), 1u);
  EXPECT_EQ(edit_distance("prode", "probe"), 1u);
  EXPECT_EQ(edit_distance("porbe", "probe"), 1u) << "two neighbours swapped";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Nearest, finds_the_nearest) {
  constexpr std::array<std::string_view, 3> known{"probe", "fixed", "unit"};
  EXPECT_EQ(nearest("prob", known), "probe");
  EXPECT_EQ(nearest("unti", known), "unit");
  EXPECT_EQ(nearest("fixt", known), "fixed");
  constexpr std::array<std::string_view, 3> gains{"k", "k_t", "k_r"};
  EXPECT_EQ(nearest("kt", gains), "k_t") << "as near as k";
  constexpr std::array<std::string_view, 6> units{"m", "cm", "mm", "um", "in", "ft"};
  EXPECT_EQ(nearest("MM", units), "mm") << "capitals are no other word";
  EXPECT_EQ(nearest("Um", units), "um");
  EXPECT_EQ(nearest("FT", units), "ft");
  EXPECT_EQ(nearest("Inch", units), "in");
  EXPECT_EQ(nearest("PROB", known), "probe");
  EXPECT_EQ(nearest("prob", {}), "");
  EXPECT_FALSE(nearest(std::string(1000000, 'x'), known).empty());
}

}  // namespace
}  // namespace sonde
