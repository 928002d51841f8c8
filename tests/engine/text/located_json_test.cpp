// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/located_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using Kind = JsonNode::Kind;

std::string json_refusal(const std::string& text) {
  try {
    parse_json("made-up.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(LocatedJson, values_are_those_of_the_text_in_its_order) {
  const JsonNode root = parse_json(
      "", R"({"b": [1, -2.5e3, 18446744073709551615, "t\u00e4\n"], "a": {"c": null}, "d": true})");
  EXPECT_EQ(root.kind, Kind::object);
  ASSERT_EQ(root.children.size(), 3u);
  EXPECT_EQ(root.children[0].key, "b");
  EXPECT_EQ(root.children[1].key, "a");
  const JsonNode& list = root.children[0];
  EXPECT_EQ(list.kind, Kind::array);
  ASSERT_EQ(list.children.size(), 4u);
  EXPECT_EQ(list.children[0].number, 1);
  EXPECT_EQ(list.children[1].number, -2500);
  EXPECT_EQ(list.children[2].number, 18446744073709551615.0);
  EXPECT_EQ(list.children[3].kind, Kind::string);
  EXPECT_EQ(list.children[3].text, "t\xc3\xa4\n");
  EXPECT_EQ(list.children[0].key, "");
  ASSERT_TRUE(root.find("a"));
  ASSERT_TRUE(root.find("a")->find("c"));
  EXPECT_EQ(root.find("a")->find("c")->kind, Kind::null);
  EXPECT_EQ(root.find("d")->kind, Kind::boolean);
  EXPECT_TRUE(root.find("d")->boolean);
  EXPECT_FALSE(root.find("c"));
  EXPECT_FALSE(list.find(""));  // a list has no keys
  EXPECT_EQ(parse_json("", "false").kind, Kind::boolean);
  EXPECT_FALSE(parse_json("", "false").boolean);
}

// Reference: the lines as they are written here.
TEST(LocatedJson, every_value_and_key_knows_its_line) {
  const JsonNode root =
      parse_json("", "\n{ \"a\": 1\n,\n\"b\":\n [2,\n3\n,\"x\"], \"c\"\n:\n{}}\n");
  EXPECT_EQ(root.line, 2u);
  EXPECT_EQ(root.find("a")->line, 2u);
  EXPECT_EQ(root.find("a")->key_line, 2u);
  const JsonNode& b = *root.find("b");
  EXPECT_EQ(b.key_line, 4u);
  EXPECT_EQ(b.line, 5u);
  EXPECT_EQ(b.children[0].line, 5u);
  EXPECT_EQ(b.children[1].line, 6u);  // though the line ends right after the number
  EXPECT_EQ(b.children[2].line, 7u);
  EXPECT_EQ(root.find("c")->key_line, 7u);
  EXPECT_EQ(root.find("c")->line, 9u);
}

TEST(LocatedJson, an_object_and_a_list_know_their_own_text) {
  const std::string text = "  {\"a\" : [1, {\"b\":2} ], \"c\": \"}\"}  ";
  const JsonNode root = parse_json("", text);
  const auto text_of_node = [&](const JsonNode& node) {
    return text.substr(node.begin, node.end - node.begin);
  };
  EXPECT_EQ(text_of_node(root), "{\"a\" : [1, {\"b\":2} ], \"c\": \"}\"}");
  EXPECT_EQ(text_of_node(*root.find("a")), "[1, {\"b\":2} ]");
  EXPECT_EQ(text_of_node(root.find("a")->children[1]), "{\"b\":2}");
}

TEST(LocatedJson, what_is_not_json_is_refused_by_its_line) {
  EXPECT_THAT(json_refusal("{\"a\": 1,\n\n]"), testing::StartsWith("made-up.json:3: not JSON: "));
  EXPECT_THAT(json_refusal(""), testing::StartsWith("made-up.json:1: not JSON: "));
  EXPECT_THAT(json_refusal("{} {}"), testing::HasSubstr("not JSON"));
  EXPECT_THAT(json_refusal("[1e400]"), testing::HasSubstr("made-up.json:1: "));
  EXPECT_THAT(json_refusal("{\"a\": nan}"), testing::HasSubstr("not JSON"));
  // The library's own words, "[json.exception...] parse error at line 1, column 2:", are left out.
  EXPECT_THAT(json_refusal("[1,\n"), testing::Not(testing::HasSubstr("column")));
  EXPECT_THAT(json_refusal("[1e400]"), testing::Not(testing::HasSubstr("json.exception")));
}

TEST(LocatedJson, a_repeated_key_is_refused_with_both_lines) {
  EXPECT_EQ(json_refusal("{\"a\": 1,\n\"b\": 2,\n\"a\": 3}"),
            "made-up.json:3: key \"a\" is given twice (first in line 1)");
  EXPECT_EQ(json_refusal("[{\"a\": 1}, {\"a\": 2}]"), "accepted");
  EXPECT_EQ(json_refusal("{\"a\": {\"a\": 2}}"), "accepted");
}

TEST(LocatedJson, too_many_levels_or_keys_are_refused) {
  const auto nested = [](std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
  };
  EXPECT_EQ(json_refusal(nested(64)), "accepted");
  EXPECT_THAT(json_refusal(nested(65)), testing::HasSubstr("nested too deeply"));
  EXPECT_THAT(json_refusal(std::string(1'000'000, '[')), testing::HasSubstr("nested too deeply"));
  const auto keys = [](int count) {
    std::string out = "{";
    for (int i = 0; i < count; ++i) out += (i ? ",\"" : "\"") + std::to_string(i) + "\":0";
    return out + "}";
  };
  EXPECT_EQ(json_refusal(keys(1000)), "accepted");
  EXPECT_THAT(json_refusal(keys(1001)), testing::HasSubstr("too many keys"));
}

TEST(LocatedJson, kinds_have_names_for_messages) {
  EXPECT_STREQ(name_of(Kind::null), "null");
  EXPECT_STREQ(name_of(Kind::boolean), "true or false");
  EXPECT_STREQ(name_of(Kind::number), "a number");
  EXPECT_STREQ(name_of(Kind::string), "a string");
  EXPECT_STREQ(name_of(Kind::array), "a list");
  EXPECT_STREQ(name_of(Kind::object), "an object");
}

}  // namespace
}  // namespace sonde
