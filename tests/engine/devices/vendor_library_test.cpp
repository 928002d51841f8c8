// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/vendor_library.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/engine/devices/loaded_standin.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* files[] = {"libmade-up.so", "libmade-up.so.3"};
constexpr VendorLibraryName made_up{.name = "libmade-up",
                                    .maker = "Nobody",
                                    .files = files,
                                    .variable = "SONDE_TEST_LIBRARY",
                                    .source = "nowhere"};

struct VendorLibraries : testing::Test {
  TempFolder folder;
  VendorLibraries() { ::unsetenv(made_up.variable); }
  ~VendorLibraries() override { ::unsetenv(made_up.variable); }
  std::string put(const std::string& name) {
    std::filesystem::copy_file(STANDIN_DHD, folder / name);
    return (folder / name).string();
  }
};

TEST_F(VendorLibraries, the_variable_goes_before_the_folders_and_the_better_name_first) {
  const std::string here = folder.path().string();
  const char* const folders[] = {"/none/there", here.c_str()};
  EXPECT_TRUE(find_vendor_library(made_up, folders).empty());
  const std::string third = put("libmade-up.so.3");
  EXPECT_EQ(find_vendor_library(made_up, folders), third);
  const std::string plain = put("libmade-up.so");
  EXPECT_EQ(find_vendor_library(made_up, folders), plain);
  ::setenv(made_up.variable, STANDIN_DHD, 1);
  EXPECT_EQ(find_vendor_library(made_up, folders), STANDIN_DHD);
  ::setenv(made_up.variable, "", 1);
  EXPECT_EQ(find_vendor_library(made_up, folders), plain);
}

TEST_F(VendorLibraries, the_working_folder_is_never_looked_into) {
  put("libmade-up.so");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const char* const folders[] = {"", ".", "relative"};
  EXPECT_TRUE(find_vendor_library(made_up, folders).empty());
  EXPECT_TRUE(find_vendor_library(made_up).empty());
  EXPECT_THAT(refusal([] { VendorLibrary("libmade-up.so"); }), HasSubstr("not absolute"));
  for (const char* value : {"libmade-up.so", "./libmade-up.so"}) {
    ::setenv(made_up.variable, value, 1);
    EXPECT_THAT(refusal([] { find_vendor_library(made_up); }),
                AllOf(HasSubstr(value), HasSubstr("SONDE_TEST_LIBRARY"), HasSubstr("absolute")));
  }
  std::filesystem::current_path(before);
}

TEST_F(VendorLibraries, a_variable_that_names_nothing_says_so) {
  ::setenv(made_up.variable, "/none/there.so", 1);
  EXPECT_THAT(refusal([] { find_vendor_library(made_up); }),
              AllOf(HasSubstr("/none/there.so"), HasSubstr("no such file")));
}

TEST_F(VendorLibraries, one_that_is_missing_is_to_be_installed_only_where_it_could_be_loaded) {
  EXPECT_THAT(why_missing(made_up, true),
              AllOf(HasSubstr("not installed"), HasSubstr("install libmade-up from nowhere"),
                    HasSubstr("SONDE_TEST_LIBRARY")));
  EXPECT_EQ(why_missing(made_up, false),
            "not supported: this build of Sonde loads no makers' libraries");
  EXPECT_EQ(why_missing(made_up), why_missing(made_up, loads_shared_libraries()));
}

TEST_F(VendorLibraries, a_file_that_is_no_library_is_refused) {
  folder.write("text.so", "not a library at all, but long enough");
  folder.write("short.so",
               "\x7f"
               "ELF");
  for (const char* name : {"text.so", "short.so"})
    EXPECT_THAT(refusal([&] { VendorLibrary(folder / name); }),
                AllOf(HasSubstr(name), HasSubstr("no shared library")));
}

// The head of a library says the processor: bytes 4 (word length) and 18 (ELF specification).
TEST_F(VendorLibraries, one_for_another_processor_names_both) {
  const std::string path = put("foreign.so");
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(18);
  file.put('\x28');  // EM_ARM
  file.seekp(4);
  file.put('\x01');  // 32 bits
  file.close();
  EXPECT_THAT(refusal([&] { VendorLibrary{path}; }),
              AllOf(HasSubstr(path), HasSubstr("another processor"), HasSubstr("32-bit ARM")));
}

TEST_F(VendorLibraries, one_that_is_cut_off_gives_the_loaders_word) {
  const std::string path = put("cut.so");
  std::filesystem::resize_file(path, 900);
  EXPECT_THAT(refusal([&] { VendorLibrary{path}; }),
              AllOf(HasSubstr(path), HasSubstr("cannot be loaded")));
}

TEST_F(VendorLibraries, a_function_that_is_missing_is_named) {
  const VendorLibrary library(STANDIN_DHD);
  int (*count)() = nullptr;
  library.bind(count, "dhdGetDeviceCount");
  EXPECT_EQ(count(), 1);
  EXPECT_THAT(refusal([&] { library.bind(count, "dhdNotThere"); }),
              AllOf(HasSubstr(STANDIN_DHD), HasSubstr("no function dhdNotThere")));
}

}  // namespace
}  // namespace sonde::test
