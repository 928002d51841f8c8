// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/depths_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::reference {
namespace {

Row example() {
  Row row{.pair = "egg-egg", .index = 3, .kind = "medium", .triangles_a = 12, .triangles_b = 34};
  row.pose = {Quat(0.6, 0, 0.8, 0), {1.0 / 3, -2e-17, 3}};
  row.starts = 400;
  row.seeds = {0.1, 0.1002, 0.2};
  row.best = 0.1;
  row.hits = 7;
  row.pdt = 0.3;
  row.separated = {Quat(0, 1, 0, 0), {0.1, 0.2, 0.7}};
  return row;
}

TEST(DepthsFile, rows_are_read_as_they_were_written) {
  const test::TempFolder folder;
  const auto file = folder / "depths.csv";
  write_rows(file, {example(), example()});
  const std::vector<Row> rows = read_rows(file);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(to_line(rows[1]), to_line(example()));
  EXPECT_EQ(rows[1].pose.p[1], -2e-17);
  EXPECT_EQ(name(rows[1]), "egg-egg/3 medium");
}

TEST(DepthsFile, two_seeds_at_the_best_agree_and_one_does_not) {
  Row row = example();
  EXPECT_TRUE(agreed(row));
  row.seeds[1] = 0.1004;
  EXPECT_FALSE(agreed(row));
  row = example();
  row.best = 0.099;  // found since
  EXPECT_FALSE(agreed(row));
}

TEST(DepthsFile, a_row_cut_short_is_named_with_its_line) {
  const test::TempFolder folder;
  const auto file = folder / "depths.csv";
  const std::string line = to_line(example());
  std::ofstream(file) << header() << line << line.substr(0, line.rfind(',')) << "\n";
  try {
    read_rows(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("depths.csv:3: too few columns"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace sonde::reference
