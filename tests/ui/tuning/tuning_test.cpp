// SPDX-License-Identifier: GPL-3.0-or-later
// What is read and saved of studies. actions/tuner_test.cpp computes one.
#include "ui/tuning/tuning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/ui/canned_study.hpp"

namespace sonde::ui::test {
namespace {

namespace fs = std::filesystem;

/// Two tetrahedra as files, and a study of them.
class TuningTest : public testing::Test {
 protected:
  TuningTest() {
    const std::string corners = "OFF\n4 4 0\n0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.1\n";
    const std::string sides = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    folder.write("probe.off", corners + sides);
    folder.write("fixed.off", corners + sides + "\n");
    folder.write("other.off", corners + sides + "\n\n");
    write_canned_study(folder / "study", folder / "probe.off", folder / "fixed.off");
  }
  LoadedScene opened(const char* probe = "probe.off", const char* fixed = "fixed.off") const {
    const std::string text = R"({"unit": "m", "probe": {"mesh": ")" + std::string(probe) +
                             R"(", "pose": [0.3, 0, 0, 1, 0, 0, 0]}, "fixed": {"mesh": ")" + fixed +
                             "\"}}";
    return open_scene(folder.write("pair.sonde.json", text));
  }
  std::string complaint_about(const fs::path& study) const {
    try {
      load_tuning(study, opened());
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  sonde::test::TempFolder folder;
};

TEST_F(TuningTest, is_read_from_its_folder_or_any_file_in_it) {
  for (const fs::path& from : {folder / "study", folder / "study" / "study.json"}) {
    const Tuning tuning = load_tuning(from, opened());
    EXPECT_EQ(tuning.folder, folder / "study");
    EXPECT_EQ(tuning.doubt, "");
    EXPECT_EQ(tuning.rows, 4u);
    EXPECT_TRUE(tuning.finished());
    EXPECT_FALSE(tuning.computed);
    EXPECT_EQ(tuning.results.device_id, "sigma.7");
    EXPECT_EQ(tuning.results.lines.size(), 4u);
  }
}

TEST_F(TuningTest, of_other_bodies_it_is_read_with_a_doubt_that_names_them) {
  EXPECT_EQ(load_tuning(folder / "study", opened("probe.off", "other.off")).doubt,
            "This map is of another scene: its fixed body is fixed.off, not other.off.");
  EXPECT_EQ(load_tuning(folder / "study", opened("other.off", "fixed.off")).doubt,
            "This map is of another scene: its probe is probe.off, not other.off.");
  folder.write("fixed.off", sonde::test::text_of(folder / "other.off"));
  EXPECT_EQ(load_tuning(folder / "study", opened()).doubt,
            "This map is of another scene: its fixed body is fixed.off, not this file of that "
            "name.");
}

TEST_F(TuningTest, what_is_missing_or_broken_is_named) {
  EXPECT_THAT(complaint_about(folder / "nowhere"), testing::HasSubstr("nowhere"));
  EXPECT_NE(complaint_about(folder / "probe.off"), "") << "its folder holds no study";
  folder.write("study/study.json", "{");
  EXPECT_THAT(complaint_about(folder / "study"), testing::HasSubstr("study.json"));
}

TEST_F(TuningTest, with_a_part_missing_it_is_refused) {
  fs::path part;
  for (const auto& entry : fs::directory_iterator(folder / "study" / "parts")) part = entry.path();
  ASSERT_FALSE(part.empty());
  fs::remove(part);
  EXPECT_NE(complaint_about(folder / "study"), "");
}

TEST_F(TuningTest, saved_elsewhere_it_reads_the_same_with_its_reports) {
  const Tuning tuning = load_tuning(folder / "study", opened());
  save_tuning(tuning, folder / "saved");
  for (const char* file : {"study.json", "recommendation.json", "map.csv"})
    EXPECT_TRUE(fs::exists(folder / "saved" / file)) << file;
  const Tuning again = load_tuning(folder / "saved", opened());
  EXPECT_EQ(again.results.about, tuning.results.about);
  ASSERT_EQ(again.results.lines.size(), tuning.results.lines.size());
  for (std::size_t i = 0; i < again.results.lines.size(); ++i) {
    EXPECT_EQ(again.results.lines[i].kind, tuning.results.lines[i].kind);
    EXPECT_EQ(again.results.lines[i].columns[0].stable.stiffness,
              tuning.results.lines[i].columns[0].stable.stiffness);
  }
}

TEST_F(TuningTest, no_folder_that_holds_something_else_is_written_to) {
  const Tuning tuning = load_tuning(folder / "study", opened());
  folder.write("file", "text");
  EXPECT_THROW(save_tuning(tuning, folder / "file"), InputError);
  EXPECT_EQ(sonde::test::text_of(folder / "file"), "text");
  write_canned_study(folder / "another", folder / "other.off", folder / "fixed.off");
  const std::string before = sonde::test::text_of(folder / "another" / "study.json");
  EXPECT_THROW(save_tuning(tuning, folder / "another"), InputError);
  EXPECT_EQ(sonde::test::text_of(folder / "another" / "study.json"), before);
}

TEST_F(TuningTest, a_connected_device_is_known_by_what_it_calls_itself) {
  const std::vector<std::string> known{"sigma.7", "touch", "touch-x"};
  TuningResults results;
  results.device_id = "sigma.7";
  EXPECT_TRUE(is_named_in(results, "sigma.7 right-handed", known));
  EXPECT_TRUE(is_named_in(results, "Force Dimension SIGMA.7", known));
  EXPECT_FALSE(is_named_in(results, "omega.7", known));
  results.device_id = "";
  EXPECT_FALSE(is_named_in(results, "omega.7", known)) << "a map of nothing is of no device";
  results.device_id = "touch";
  EXPECT_TRUE(is_named_in(results, "Touch", known));
  EXPECT_FALSE(is_named_in(results, "Touch X", known));
}

TEST_F(TuningTest, each_kind_of_contact_can_be_studied_alone) {
  const std::vector<std::string> kinds = situation_kinds();
  EXPECT_THAT(kinds, testing::Contains("flat"));
  EXPECT_THAT(kinds, testing::Contains("edge"));
  EXPECT_EQ(std::set<std::string>(kinds.begin(), kinds.end()).size(), kinds.size());
}

TEST_F(TuningTest, studies_that_nobody_saved_are_in_the_users_data) {
  const QByteArray before = qgetenv("XDG_DATA_HOME");
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString(folder.path().string()));
  const fs::path studies = computed_studies_folder();
  qputenv("XDG_DATA_HOME", before);
  EXPECT_THAT(studies.string(), testing::StartsWith(folder.path().string()));
  EXPECT_EQ(studies.filename(), "studies");
}

}  // namespace
}  // namespace sonde::ui::test
