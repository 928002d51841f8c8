// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/json_checks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

template <class Check>
std::string failure_of(Check check) {
  try {
    check();
  } catch (const InputError& error) {
    return error.what();
  }
  return "passed";
}

const std::filesystem::path checked_file = "made-up.json";
const JsonNode checked_root = parse_json("", "{\"speed\": 1,\n\"inner\":\n{\"size\": \"x\"}}");

TEST(JsonChecks, long_text_is_cut_in_quotes) {
  EXPECT_EQ(in_quotes(""), "\"\"");
  EXPECT_EQ(in_quotes("abc"), "\"abc\"");
  const std::string sixty(60, 'x');
  EXPECT_EQ(in_quotes(sixty), "\"" + sixty + "\"");
  EXPECT_EQ(in_quotes(sixty + "y"), "\"" + std::string(57, 'x') + "...\"");
}

TEST(JsonChecks, a_failure_names_file_line_and_reason) {
  EXPECT_EQ(failure_of([] { fail_at(checked_file, 7, "why"); }), "made-up.json:7: why");
}

TEST(JsonChecks, a_value_of_another_kind_is_refused_by_its_key) {
  const auto kind = [](const JsonNode& node, JsonNode::Kind wanted) {
    return failure_of([&] { expect_kind(checked_file, node, wanted); });
  };
  EXPECT_EQ(kind(checked_root, JsonNode::Kind::object), "passed");
  EXPECT_EQ(kind(checked_root, JsonNode::Kind::array),
            "made-up.json:1: the file's value is an object; expected a list");
  EXPECT_EQ(kind(*checked_root.find("inner"), JsonNode::Kind::number),
            "made-up.json:3: \"inner\" is an object; expected a number");
}

TEST(JsonChecks, an_unknown_key_is_refused_with_the_nearest_known_one) {
  const std::array<std::string_view, 3> all{"speed", "inner", "weight"}, some{"speed", "inertia"};
  const auto keys = [](const JsonNode& node, std::span<const std::string_view> known) {
    return failure_of([&] { expect_keys(checked_file, node, known); });
  };
  EXPECT_EQ(keys(checked_root, all), "passed");
  EXPECT_EQ(keys(checked_root, std::span(some).first(2)),
            "made-up.json:2: unknown key \"inner\"; the nearest known one is \"inertia\"");
  EXPECT_EQ(keys(*checked_root.find("speed"), all),
            "made-up.json:1: \"speed\" is a number; expected an object");
}

TEST(JsonChecks, a_key_that_is_needed_is_found_or_missed_by_its_object) {
  EXPECT_EQ(need_key(checked_file, checked_root, "speed", "the scene").number, 1);
  EXPECT_EQ(failure_of([] { need_key(checked_file, checked_root, "mass", "the scene"); }),
            "made-up.json:1: key \"mass\" is missing from the scene");
  EXPECT_EQ(
      failure_of([] { need_key(checked_file, *checked_root.find("inner"), "mass", "the scene"); }),
      "made-up.json:3: key \"mass\" is missing from \"inner\"");
}

TEST(JsonChecks, a_file_that_is_not_there_is_refused_at_the_line_that_names_it) {
  const auto file = [](const std::filesystem::path& named) {
    return failure_of([&] { expect_file(checked_file, 3, "mesh", named); });
  };
  EXPECT_EQ(file(std::filesystem::temp_directory_path()), "passed");
  EXPECT_EQ(file("/none/there.off"),
            "made-up.json:3: \"mesh\" names /none/there.off: no such file");
}

}  // namespace
}  // namespace sonde
