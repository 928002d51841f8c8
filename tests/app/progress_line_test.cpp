// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace sonde::app {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Elsewhere = ProgressLine::Elsewhere;

/// What is on stderr, which is no terminal here, after a study that is silent for a while.
std::string written(bool quiet, Elsewhere elsewhere, std::chrono::milliseconds every,
                    double under_way = 0) {
  testing::internal::CaptureStderr();
  {
    ProgressLine progress(quiet, elsewhere, every);
    progress.show("trade, parts", 3, 48, under_way);
    std::this_thread::sleep_for(200ms);
    progress.clear();
    std::this_thread::sleep_for(50ms);
  }
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressLine, a_file_gets_plain_lines_by_the_clock) {
  const std::string lines = written(false, Elsewhere::lines, 20ms);
  EXPECT_THAT(lines, testing::StartsWith("sonde: trade, parts: 3 of 48 (after 0 s)\nsonde: "));
  EXPECT_EQ(lines.back(), '\n');
  EXPECT_EQ(lines.find('\r'), lines.npos) << "nothing for a terminal";
}

TEST(ProgressLine, what_is_over_sooner_gets_none) {
  EXPECT_EQ(written(false, Elsewhere::lines, 10s), "");
}

TEST(ProgressLine, quiet_is_quiet_and_a_query_says_nothing_in_a_pipe) {
  EXPECT_EQ(written(true, Elsewhere::lines, 20ms), "");
  EXPECT_EQ(written(false, Elsewhere::nothing, 20ms), "");
}

TEST(ProgressLine, what_is_under_way_counts) {
  EXPECT_THAT(written(false, Elsewhere::lines, 20ms, 1.8),
              HasSubstr("trade, parts: 3 of 48, 10 %"));
}

TEST(ProgressLine, a_percentage_is_told_until_it_is_stopped) {
  testing::internal::CaptureStderr();
  {
    ProgressLine line(false, Elsewhere::lines, 20ms);
    bool stop = false;
    const Progress progress = line.percent("calibration", [&stop] { return stop; });
    EXPECT_TRUE(progress(0.345));
    std::this_thread::sleep_for(100ms);
    stop = true;
    EXPECT_FALSE(progress(0.5));
    EXPECT_TRUE(line.percent("for ever")(0.5));
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("sonde: calibration: 34 %"));
}

}  // namespace
}  // namespace sonde::app
