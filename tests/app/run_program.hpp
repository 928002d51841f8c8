// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/csv.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {

/// What a run of the program left.
struct Outcome {
  int exit_code = -1;  ///< -1 where a signal ended it
  std::string out, err;
};

/// Runs `sonde ARGUMENTS` in a folder; the arguments are a line for the shell.
inline Outcome sonde_in(const std::filesystem::path& folder, const std::string& arguments) {
  const TempFolder outputs;  // not in `folder`: the tests count what is there
  const std::string command = "cd '" + folder.string() + "' && '" SONDE_PROGRAM "' " + arguments;
  const std::string to = " >'" + (outputs / "out").string() + "'";
  const bool redirected = arguments.find('>') != std::string::npos;
  const int status = std::system(
      (command + (redirected ? "" : to) + " 2>'" + (outputs / "err").string() + "'").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(outputs / "out"),
          text_of(outputs / "err")};
}

}  // namespace sonde::test
