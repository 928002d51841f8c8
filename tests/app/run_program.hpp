// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

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

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// A CSV result: its header and its fields.
struct Csv {
  std::string header;
  std::vector<std::vector<std::string>> rows;

  explicit Csv(const std::string& text) {
    std::vector<std::string> lines = split(text, '\n');
    lines.pop_back();  // after the last line's end
    if (lines.empty()) return;
    header = lines[0];
    for (std::size_t i = 1; i < lines.size(); ++i) rows.push_back(split(lines[i], ','));
  }
  std::size_t column(const std::string& name) const {
    const auto names = split(header, ',');
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) return i;
    throw std::out_of_range("no column " + name);
  }
  const std::string& text(std::size_t row, const std::string& name) const {
    return rows.at(row).at(column(name));
  }
  double number(std::size_t row, const std::string& name) const {
    return std::stod(text(row, name));
  }
  /// Without the columns that tell times, and so differ from run to run.
  std::vector<std::vector<std::string>> without(const std::vector<std::string>& names) const {
    auto copy = rows;
    for (auto& row : copy)
      for (const auto& name : names) row.at(column(name)).clear();
    return copy;
  }
};

}  // namespace sonde::test
