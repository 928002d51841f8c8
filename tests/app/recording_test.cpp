// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Recordings : public AppTest {
 protected:
  Recordings() : original(replay("boxes.sonde.json --record boxes.sonderec")) {}
  Csv replay(const std::string& arguments) const {
    return Csv(expect_done("replay " + arguments).out);
  }
  void cut(std::size_t bytes) const {
    const std::string whole = text_of(folder / "boxes.sonderec");
    folder.write("cut.sonderec", whole.substr(0, whole.size() - bytes));
  }
  const Csv original;
  static constexpr std::size_t last = 39;
};

TEST_F(Recordings, replayed_give_the_same_bits_but_for_the_times) {
  EXPECT_EQ(replay("boxes.sonderec").without(time_columns), original.without(time_columns));
}

TEST_F(Recordings, replayed_with_other_gains_differ_as_the_scene_does) {
  EXPECT_EQ(replay("boxes.sonderec --k 100").without(time_columns),
            replay("boxes.sonde.json --k 100").without(time_columns));
  EXPECT_EQ(replay("boxes.sonderec --method pdt").without(time_columns),
            replay("boxes.sonde.json --method pdt").without(time_columns));
}

TEST_F(Recordings, of_a_path_with_long_gaps_give_the_same_bits) {
  std::string path = "t,px,py,pz,qw,qx,qy,qz\n";
  for (int i = 0; i < 30; ++i)
    path += std::to_string(0.05 * i) + "," + std::to_string(0.16 - 0.001 * i) + ",0,0,1,0,0,0\n";
  folder.write("slow.csv", path);
  const std::string classic = "--coupling classic --b-t 5 ";
  const Csv first = replay("boxes.sonde.json --trajectory slow.csv " + classic + "--record s.rec");
  EXPECT_EQ(replay("s.rec").without(time_columns), first.without(time_columns));
}

TEST_F(Recordings, keep_the_gains_they_were_made_with) {
  replay("boxes.sonde.json --k 100 --record soft.sonderec");
  const Csv again = replay("soft.sonderec --record again.sonderec");
  EXPECT_NEAR(again.number(last, "fx"), 100 * 0.019, 0.004);
  EXPECT_EQ(replay("again.sonderec").without(time_columns), again.without(time_columns));
}

TEST_F(Recordings, are_a_table_as_they_were_without_their_meshes) {
  std::filesystem::remove(folder / "small.off");
  const Csv kept = replay("boxes.sonderec --as-recorded");
  for (const int row : {0, 20, 39}) {
    for (const char* column : {"t", "px", "qw", "depth"})
      EXPECT_EQ(kept.number(std::size_t(row), column), original.number(std::size_t(row), column));
    for (const char* column : {"fx", "tick_us"})  // kept to seven digits
      EXPECT_FLOAT_EQ(float(kept.number(std::size_t(row), column)),
                      float(original.number(std::size_t(row), column)));
  }
  EXPECT_EQ(sonde("replay boxes.sonde.json --as-recorded").exit_code, 2);
  EXPECT_EQ(sonde("replay boxes.sonderec --as-recorded --record x.sonderec").exit_code, 2);
  EXPECT_EQ(sonde("replay boxes.sonderec --as-recorded --phases").exit_code, 2);
  EXPECT_EQ(sonde("replay boxes.sonderec --as-recorded --phases-picture x.svg").exit_code, 2);
}

TEST_F(Recordings, are_not_written_over_by_a_picture) {
  expect_refused("replay boxes.sonde.json --record x.svg --phases-picture ./x.svg", 2,
                 "--record and --phases-picture name the same file");
}

TEST_F(Recordings, are_described_by_info) {
  const Outcome text = expect_done("info boxes.sonderec");
  for (const char* part : {"recording of    boxes", "ticks           40", "duration        0.039 s",
                           "as recorded", "ends            whole"})
    EXPECT_THAT(text.out, HasSubstr(part));
  const json report = json::parse(sonde("info --json boxes.sonderec").out).at("recordings").at(0);
  EXPECT_EQ(report.at("ticks"), 40);
  EXPECT_EQ(report.at("whole"), true);
  EXPECT_EQ(report.at("meshes_as_recorded"), true);
  EXPECT_EQ(report.at("bytes"), report.at("readable_bytes"));
}

TEST_F(Recordings, cut_ones_are_replayed_up_to_there_and_say_so) {
  cut(3);  // of the last block, which says that all is there
  const Outcome run = expect_done("replay cut.sonderec");
  EXPECT_THAT(run.err, HasSubstr("cut.sonderec: byte "));
  EXPECT_EQ(Csv(run.out).without(time_columns), original.without(time_columns));
  EXPECT_THAT(sonde("info cut.sonderec").out, HasSubstr("ends            cut: byte "));
  cut(50);  // of the only block of ticks
  EXPECT_THAT(sonde("info cut.sonderec").out, HasSubstr("ticks           0"));
}

TEST_F(Recordings, bad_ones_are_refused) {
  folder.write("short.sonderec", text_of(folder / "boxes.sonderec").substr(0, 100));
  expect_refused("replay short.sonderec", 3, "short.sonderec: byte 100: ");
  expect_refused("info short.sonderec", 3, "cut within its header");
  expect_refused("info small.off boxes.sonderec", 2, "not both at once");
  expect_refused("replay boxes.sonderec --trajectory path.csv", 2, "leave out --trajectory");
  expect_refused("replay boxes.sonde.json --record nowhere/x.sonderec", 3, "nowhere/x.sonderec");
  expect_refused("replay boxes.sonderec --record boxes.sonderec", 2, "would be overwritten");
  folder.write("small.off", box_off(0.06));
  expect_refused("replay boxes.sonderec", 3, "small.off is another mesh than was recorded");
  EXPECT_THAT(sonde("info boxes.sonderec").out, HasSubstr("small.off is another mesh"));
}

TEST_F(Recordings, appear_with_their_table_or_not_at_all) {
  expect_refused("replay boxes.sonde.json --record x --out x", 2, "name the same file");
  expect_refused("replay boxes.sonde.json --record x --out ./x", 2, "name the same file");
  expect_refused("replay boxes.sonde.json --record x.sonderec >/dev/full", 3, "standard output");
}

TEST_F(Recordings, and_calibrations_name_a_file_that_is_no_utf_8_as_info_does) {
  folder.write("b\xff.sonde.json", text_of(folder / "boxes.sonde.json"));
  expect_done("replay b\xff.sonde.json --record x\xff.sonderec");
  EXPECT_THAT(expect_done("info x\xff.sonderec --json").out, HasSubstr(R"("name": "b\\xff")"));
  const auto columns = [this](const std::string& of) {
    return Csv(expect_done("replay " + of).out).without(time_columns);
  };
  EXPECT_EQ(columns("x\xff.sonderec"), columns("boxes.sonde.json")) << "it is run again";
  expect_done("calibrate b\xff.sonde.json --count 0 --out c.json");
  EXPECT_THAT(text_of(folder / "c.json"), HasSubstr(R"(b\\xff)"));
}

TEST_F(Recordings, a_trajectory_that_fails_writes_none) {
  const std::size_t files = folder.file_count();
  folder.write("bad.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0,0,0,9,0,0,0\n");
  EXPECT_EQ(sonde("replay boxes.sonde.json --trajectory bad.csv --record x.sonderec").exit_code, 3);
  EXPECT_EQ(folder.file_count(), files + 1);
}

}  // namespace
}  // namespace sonde::test
