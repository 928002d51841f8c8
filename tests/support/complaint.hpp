// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {

/// What a reader complains of in a file with this text, without the file's name, which it begins
/// with; empty where there is no complaint.
template <class Read>
std::string complaint_of(const std::string& text, const char* name, const Read& read) {
  const TempFolder folder;
  const auto file = folder.write(name, text);
  try {
    read(file);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_THAT(what, testing::StartsWith(file.string() + ":"));
    return what.substr(file.string().size() + 1);
  }
  return {};
}

}  // namespace sonde::test
