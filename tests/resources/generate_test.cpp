// SPDX-License-Identifier: GPL-3.0-or-later
// What is committed is what the generator writes, byte for byte; but for the scenes' pictures,
// which the window draws (resources/draw/gallery.cpp).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "tests/support/temp_folder.hpp"

namespace sonde::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> files_under(const fs::path& root) {
  std::set<std::string> files;
  for (const char* folder : {"models", "scenes"})
    for (const auto& entry : fs::directory_iterator(root / folder))
      if (entry.path().extension() != ".png")
        files.insert(std::string(folder) + "/" + entry.path().filename().string());
  return files;
}

TEST(Generate, writes_what_is_committed) {
  const TempFolder folder;
  const std::string command =
      std::string("\"") + SONDE_GENERATE + "\" \"" + folder.path().string() + "\"";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const fs::path committed = SONDE_RESOURCES;
  EXPECT_EQ(files_under(folder.path()), files_under(committed));
  for (const std::string& file : files_under(folder.path()))
    EXPECT_TRUE(text_of(folder / file) == text_of(committed / file))
        << file << " differs: build the target resources and commit what it writes";
}

TEST(Generate, models_are_small) {
  for (const auto& entry : fs::directory_iterator(fs::path(SONDE_RESOURCES) / "models"))
    EXPECT_LE(entry.file_size(), 2'000'000U) << entry.path();
}

}  // namespace
}  // namespace sonde::test
