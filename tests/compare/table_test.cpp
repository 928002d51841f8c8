// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the manual says what the program finds: some of its rows are computed again.
#include <gmock/gmock.h>

#include <random>

#include "tests/compare/pairs.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {
namespace {

void expect_in_the_manual(const ComparedPair& pair) {
  const std::string manual = text_of(SONDE_TABLE);
  EXPECT_THAT(manual, testing::HasSubstr(table_head()));
  EXPECT_THAT(manual, testing::HasSubstr(table_row(pair.name, compare_pair(pair))));
}

TEST(CompareTable, a_seeded_sample_of_its_rows_is_found_again) {
  std::vector<ComparedPair> pairs = compared_pairs();
  // These take a minute each: where surfaces lie along each other there is much to look at.
  std::erase_if(pairs, [](const ComparedPair& pair) {
    return pair.name == "peg-in-hole" || pair.name == "nut-on-bolt";
  });
  std::mt19937_64 random(20);
  for (int i = 0; i < 3; ++i) expect_in_the_manual(pairs[random() % pairs.size()]);
}

TEST(CompareTable, Full_every_row_is_found_again) {
  for (const ComparedPair& pair : compared_pairs()) expect_in_the_manual(pair);
}

}  // namespace
}  // namespace sonde::test
