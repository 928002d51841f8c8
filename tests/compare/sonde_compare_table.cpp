// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-compare-table [--pictures FOLDER]: the table of resources/docs/compare.md on standard
// output; with a folder, the pictures of every pair as well.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "engine/scene/output_file.hpp"
#include "engine/study/compare_report.hpp"
#include "tests/compare/pairs.hpp"

namespace {

std::string file_name(std::string pair) {
  for (char& c : pair)
    if (c == ' ') c = '-';
  return pair + ".svg";
}

int run(const std::filesystem::path& pictures) {
  std::fputs(sonde::test::table_head().c_str(), stdout);
  for (const sonde::test::ComparedPair& pair : sonde::test::compared_pairs()) {
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
  const bool with_pictures = argc == 3 && std::string(argv[1]) == "--pictures";
  if (argc != 1 && !with_pictures) {
    std::fputs("usage: sonde-compare-table [--pictures FOLDER]\n", stderr);
    return 2;
  }
  try {
    return run(with_pictures ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-compare-table: %s\n", error.what());
    return 4;
  }
}
