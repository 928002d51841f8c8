// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/temp_folder.hpp"

namespace sonde::test {

/// Makes a locale such as "de_DE" of UTF-8, whatever the machine has: a folder for LOCPATH.
inline std::filesystem::path make_locale(const TempFolder& folder, const std::string& name) {
  const std::filesystem::path locales = folder / "locales";
  std::filesystem::create_directories(locales);
  const std::string command = "localedef -i " + name + " -f UTF-8 '" +
                              (locales / (name + ".UTF-8")).string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0)
      << "Debian's package locales is missing: packaging/deps installs it";
  return locales;
}

}  // namespace sonde::test
