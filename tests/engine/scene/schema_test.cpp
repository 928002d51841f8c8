// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON Schema of the scene says what the reader does.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "engine/scene/scene.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/file_unit.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using nlohmann::json;

json schema() { return json::parse(test::text_of(SONDE_SCHEMA)); }

/// What a "$ref" to "#/$defs/NAME" stands for, also as the first of a "oneOf".
json resolved(const json& root, const json& node) {
  if (node.contains("oneOf")) return resolved(root, node["oneOf"][0]);
  if (!node.contains("$ref")) return node;
  return root.at(json::json_pointer(node["$ref"].get<std::string>().substr(1)));
}

/// The keys of an object of the schema and of the objects below it, with dots.
void collect(const json& root, const json& object, const std::string& prefix,
             std::vector<std::string>& keys) {
  EXPECT_EQ(object.at("additionalProperties"), false) << prefix;
  for (const auto& [key, value] : object.at("properties").items()) {
    keys.push_back(prefix + key);
    const json property = resolved(root, value);
    if (property.contains("properties")) collect(root, property, prefix + key + ".", keys);
  }
}

TEST(Schema, it_has_the_keys_of_the_reader_and_no_others) {
  const json root = schema();
  std::vector<std::string> keys;
  collect(root, root, "", keys);
  EXPECT_THAT(keys, testing::UnorderedElementsAreArray(scene_keys()));
}

TEST(Schema, a_part_is_a_body_with_keys_of_its_own) {
  json part = schema().at("$defs").at("part");
  for (const char* own : {"name", "colour", "shown", "felt", "component"})
    EXPECT_EQ(part["properties"].erase(own), 1u) << own;
  EXPECT_EQ(part, schema().at("$defs").at("body"));
  for (const char* body : {"probe", "fixed"})
    EXPECT_EQ(schema()["properties"][body]["oneOf"][1]["items"]["$ref"], "#/$defs/part");
}

void expect_same(const json& properties, std::span<const Setting> settings) {
  for (const Setting& setting : settings) {
    SCOPED_TRACE(setting.key);
    const json& property = properties.at(setting.key);
    EXPECT_EQ(property.at("minimum"), setting.minimum);
    EXPECT_EQ(property.at("maximum"), setting.maximum);
    EXPECT_EQ(property.at("default"), setting.fallback);
    EXPECT_EQ(property.at("type"), setting.integer ? "integer" : "number");
    const std::string unit = *setting.unit != 0 ? std::string(setting.unit) + ". " : "";
    EXPECT_EQ(property.at("description"), unit + setting.doc);
  }
}

TEST(Schema, its_settings_are_those_of_the_table) {
  const json definitions = schema().at("$defs");
  expect_same(definitions.at("coupling").at("properties"), coupling_settings());
  expect_same(definitions.at("servo").at("properties"), servo_settings());
  expect_same(definitions.at("device").at("properties"), device_settings());
  expect_same(definitions.at("axis").at("properties"), axis_settings());
}

void expect_words(const json& property, std::span<const Choice> choices) {
  std::vector<std::string> known;
  for (const Choice& choice : choices) known.emplace_back(choice.key);
  EXPECT_EQ(property.at("enum").get<std::vector<std::string>>(), known);
}

TEST(Schema, its_words_are_those_of_the_reader) {
  const json root = schema();
  for (const json& unit : root["properties"]["unit"]["enum"])
    EXPECT_TRUE(unit_in_metres(unit.get<std::string>())) << unit;
  EXPECT_EQ(root["properties"]["unit"]["enum"].size(), 6u);
  for (const json& model : root["$defs"]["body"]["properties"]["model"]["enum"])
    EXPECT_TRUE(model_named(model.get<std::string>())) << model;
  const json& modes = root["$defs"]["coupling"]["properties"]["mode"]["enum"];
  EXPECT_EQ(modes.size(), coupling_modes().size());
  for (const json& mode : modes) EXPECT_TRUE(coupling_mode(mode.get<std::string>())) << mode;
  expect_words(root["$defs"]["device"]["properties"]["control"], device_controls());
  expect_words(root["$defs"]["device"]["properties"]["frame"], device_frames());
  expect_words(root["$defs"]["axis"]["properties"]["from"], device_axes());
}

}  // namespace
}  // namespace sonde
