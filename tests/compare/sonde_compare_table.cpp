// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-compare-table [--pictures FOLDER] [PAIR...]: the table of resources/docs/use/compare.md on
// standard output, or the lines of some pairs; with a folder, their pictures as well.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/study/comparison/compare_report.hpp"
#include "engine/text/output_file.hpp"
#include "tests/compare/pairs.hpp"

namespace {

std::string file_name(std::string pair) {
  for (char& c : pair)
    if (c == ' ') c = '-';
  return pair + ".svg";
}

int run(const std::filesystem::path& pictures, const std::vector<std::string>& only) {
  if (only.empty()) std::fputs(sonde::test::table_head().c_str(), stdout);
  for (const sonde::test::ComparedPair& pair : sonde::test::compared_pairs()) {
    if (!only.empty() && std::ranges::find(only, pair.name) == only.end()) continue;
    const sonde::Comparison comparison = sonde::test::compare_pair(pair);
    std::fputs(sonde::test::table_row(pair.name, comparison).c_str(), stdout);
    std::fflush(stdout);
    if (pictures.empty()) continue;
    for (const sonde::StudyFile& file : sonde::compare_files(comparison))
      if (file.name == "wrench.svg") sonde::write_whole(pictures / file_name(pair.name), file.text);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> only(argv + 1, argv + argc);
  std::filesystem::path pictures;
  if (only.size() >= 2 && only[0] == "--pictures") {
    pictures = only[1];
    only.erase(only.begin(), only.begin() + 2);
  }
  if (!only.empty() && only[0].starts_with('-')) {
    std::fputs("usage: sonde-compare-table [--pictures FOLDER] [PAIR...]\n", stderr);
    return 2;
  }
  try {
    return run(pictures, only);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-compare-table: %s\n", error.what());
    return 4;
  }
}
