// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/temp_folder.hpp"

namespace sonde::ui::test {

/// The real sonde-view, run in a folder of its own, where its settings are too.
class Program : public ::testing::Test {
 protected:
  struct Outcome {
    int exit_code;
    std::string out, err;
  };
  Outcome run(const std::string& arguments, const std::string& environment = "") const {
    const std::string command = "cd '" + folder.path().string() + "' && XDG_CONFIG_HOME=. " +
                                environment + " timeout 60 '" SONDE_VIEW_PROGRAM "' " + arguments +
                                " >out 2>err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, sonde::test::text_of(folder / "out"),
            sonde::test::text_of(folder / "err")};
  }
  sonde::test::TempFolder folder;
};

}  // namespace sonde::ui::test
