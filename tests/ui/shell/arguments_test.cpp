// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/arguments.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sonde::ui::test {
namespace {

using testing::HasSubstr;

struct Answer {
  Parsed parsed;
  std::string out, err;
};

Answer answer_to(std::vector<std::string> words) {
  words.insert(words.begin(), "sonde-view");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Answer answer;
  answer.parsed = parse_arguments(static_cast<int>(words.size()), argv.data());
  answer.out = testing::internal::GetCapturedStdout();
  answer.err = testing::internal::GetCapturedStderr();
  return answer;
}

TEST(Arguments, none_are_needed) {
  const Answer answer = answer_to({});
  EXPECT_FALSE(answer.parsed.exit_code);
  const Arguments& arguments = answer.parsed.arguments;
  EXPECT_TRUE(arguments.files.empty());
  EXPECT_FALSE(arguments.unit);
  EXPECT_EQ(arguments.device + arguments.screenshot + arguments.demo, "");
  EXPECT_EQ(answer.out + answer.err, "");
}

TEST(Arguments, two_meshes_may_have_a_unit_which_is_told_in_metres) {
  const Answer answer = answer_to({"spoon.ply", "--unit", "mm", "cup.ply"});
  ASSERT_FALSE(answer.parsed.exit_code) << answer.err;
  EXPECT_EQ(answer.parsed.arguments.files, (std::vector<std::string>{"spoon.ply", "cup.ply"}));
  EXPECT_EQ(answer.parsed.arguments.unit, 1e-3);
  EXPECT_EQ(answer_to({"a", "b", "--unit", "in"}).parsed.arguments.unit, 0.0254);
}

TEST(Arguments, a_scene_may_come_with_a_device_and_a_picture_to_write) {
  const Arguments arguments =
      answer_to({"cup.sonde.json", "--device", "sigma.7", "--screenshot", "a.png"})
          .parsed.arguments;
  EXPECT_EQ(arguments.files, std::vector<std::string>{"cup.sonde.json"});
  EXPECT_EQ(arguments.device, "sigma.7");
  EXPECT_EQ(arguments.screenshot, "a.png");
  EXPECT_EQ(answer_to({"--demo", "b.png"}).parsed.arguments.demo, "b.png");
}

TEST(Arguments, help_and_version_leave_nothing_to_do_and_are_no_fault) {
  for (const char* asked : {"--help", "-h"}) {
    const Answer help = answer_to({asked});
    EXPECT_EQ(help.parsed.exit_code, 0);
    for (const char* option : {"--unit", "--device", "--screenshot", "--demo", "--version"})
      EXPECT_THAT(help.out, HasSubstr(option));
    EXPECT_EQ(help.err, "");
  }
  const Answer version = answer_to({"--version"});
  EXPECT_EQ(version.parsed.exit_code, 0);
  EXPECT_EQ(version.out, "sonde-view " SONDE_VERSION "\n");
}

TEST(Arguments, wrong_usage_is_2_with_a_reason_and_where_to_read_more) {
  const std::pair<std::vector<std::string>, const char*> wrong[] = {
      {{"--nonsense"}, "nonsense"},
      {{"a", "b", "c"}, "not 3 files"},
      {{"a", "b", "--unit", "parsec"}, "parsec"},
      {{"a", "b", "--unit", ""}, "--unit"},
      {{"a.sonde.json", "--unit", "mm"}, "a scene says its own"},
      {{"--device", ""}, "--device"},
      {{"--device"}, "--device"},
      {{"--demo", "a.png", "--screenshot", "b.png"}, "--demo"}};
  for (const auto& [words, reason] : wrong) {
    const Answer answer = answer_to(words);
    EXPECT_EQ(answer.parsed.exit_code, 2) << reason;
    EXPECT_THAT(answer.err, testing::StartsWith("sonde-view: "));
    EXPECT_THAT(answer.err, HasSubstr(reason));
    EXPECT_THAT(answer.err, HasSubstr("\nTry 'sonde-view --help'.\n"));
    EXPECT_EQ(answer.out, "") << "what reads the output gets no complaint";
  }
}

TEST(Arguments, a_complaint_has_no_control_character) {
  EXPECT_THAT(answer_to({"a", "b", "--unit", "\x1b[31m"}).err, HasSubstr("\\x1b[31m"));
}

TEST(Arguments, a_file_may_begin_with_a_dash_behind_two_of_them) {
  const Answer answer = answer_to({"--", "-a.off", "-b.off"});
  EXPECT_FALSE(answer.parsed.exit_code) << answer.err;
  EXPECT_EQ(answer.parsed.arguments.files, (std::vector<std::string>{"-a.off", "-b.off"}));
}

}  // namespace
}  // namespace sonde::ui::test
