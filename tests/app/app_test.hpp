// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/app/run_program.hpp"

namespace sonde::test {

/// The columns of a replay that are measured times: no two runs agree on them.
inline const std::vector<std::string> time_columns{"tick_us", "late"};

/// A folder with a small box, a larger one, poses of the one in the other and a path into it.
class AppTest : public testing::Test {
 protected:
  AppTest() {
    folder.write("small.off", box_off(0.05));
    folder.write("large.off", box_off(0.1));
    folder.write("poses.csv",
                 "px,py,pz,qw,qx,qy,qz\n"
                 "0.14,0.01,0.02,1,0,0,0\n"
                 "0.3,0,0,0.6,0,0.8,0\n"
                 "0.01,0.02,0.13,0.8,0.6,0,0\n");
    std::string path = "t,px,py,pz,qw,qx,qy,qz\n";
    for (int i = 0; i < 40; ++i)
      path += std::to_string(0.001 * i) + "," + std::to_string(0.17 - 0.001 * i) + ",0,0,1,0,0,0\n";
    folder.write("path.csv", path);
    folder.write("boxes.sonde.json",
                 R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"},
                     "trajectory": "path.csv"})");
  }

  Outcome sonde(const std::string& arguments) const { return sonde_in(folder.path(), arguments); }

  /// Runs `sonde ARGUMENTS` in the folder, after other words for the shell.
  Outcome sonde_after(const std::string& before, const std::string& arguments) const {
    const TempFolder outputs;
    const std::string command =
        "cd '" + folder.path().string() + "' && " + before + " '" SONDE_PROGRAM "' " + arguments +
        " >'" + (outputs / "out").string() + "' 2>'" + (outputs / "err").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(outputs / "out"),
            text_of(outputs / "err")};
  }

  /// A run that has to succeed.
  Outcome expect_done(const std::string& arguments) const {
    Outcome run = sonde(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments << ": " << run.err;
    return run;
  }
  /// The program refuses, says why, and writes nothing.
  void expect_refused(const std::string& arguments, int exit_code,
                      const std::string& reason) const {
    SCOPED_TRACE(arguments);
    const std::size_t files = folder.file_count();
    const Outcome run = sonde(arguments);
    EXPECT_EQ(run.exit_code, exit_code);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, testing::StartsWith("sonde: "));
    EXPECT_THAT(run.err, testing::HasSubstr(reason));
    EXPECT_EQ(folder.file_count(), files);
  }

  static std::string box_off(double half) {
    std::string text = "OFF\n8 6 0\n";
    for (int i = 0; i < 8; ++i)
      for (int axis = 0; axis < 3; ++axis)
        text += std::to_string((i >> axis & 1) != 0 ? half : -half) + (axis == 2 ? "\n" : " ");
    return text + "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
  }

  const std::string loose = "--probe small.off --fixed large.off ";
  const TempFolder folder;
};

}  // namespace sonde::test
