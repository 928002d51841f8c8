// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

class Traces : public AppTest {
 protected:
  static constexpr const char* quick =
      "traces boxes.sonde.json --device sigma.7 --trajectory path.csv --k 200,400 ";
};

TEST_F(Traces, writes_a_table_a_summary_and_a_picture) {
  const Outcome run = expect_done(std::string(quick) + "--out out --quiet");
  EXPECT_THAT(run.out, HasSubstr("| step | 200 | 0 |"));
  const Csv table(text_of(folder / "out/traces.csv"));
  EXPECT_EQ(table.header, "course,k,b,t,fx,fy,fz,tx,ty,tz,depth");
  EXPECT_EQ(table.rows.size(), 2u * 4 * 1200);
  EXPECT_EQ(Csv(text_of(folder / "out/summary.csv")).rows.size(), 2u * 4);
  EXPECT_THAT(text_of(folder / "out/traces.svg"), HasSubstr("k = 400 N/m"));
}

TEST_F(Traces, shards_are_merged_into_the_same_files) {
  expect_done(std::string(quick) + "--out whole");
  for (const char* shard : {"2/2", "1/2"})
    expect_done(std::string(quick) + "--out part" + shard[0] + " --shard " + shard);
  expect_done("merge part1 part2 --out joined");
  for (const char* file : {"traces.csv", "summary.csv", "summary.md", "traces.svg"})
    EXPECT_EQ(text_of(folder / "joined" / file), text_of(folder / "whole" / file)) << file;
}

TEST_F(Traces, bad_gains_are_refused_before_any_work) {
  for (const char* k : {"0", "-1", "nan", "200,x", "1e400"})
    EXPECT_EQ(
        sonde(std::string("traces boxes.sonde.json --device sigma.7 --out o --k=") + k).exit_code,
        2)
        << k;
  const std::string classic =
      "traces boxes.sonde.json --device sigma.7 --out o --coupling classic ";
  expect_refused(classic + "--k 1e12", 2, "between 1 and 100000 N/m");
  expect_refused(classic + "--b 1e12", 2, "between 0 and 100 N·s/m");
  expect_refused(classic + "--b=-1", 2, "between 0 and 100 N·s/m");
  expect_refused("traces boxes.sonde.json --device sigma.7 --out o --b 1", 2, "no damping");
  expect_refused("traces boxes.sonde.json --device none.7 --out o", 2, "none.7");
  EXPECT_FALSE(std::filesystem::exists(folder / "o"));
}

}  // namespace
}  // namespace sonde::test
