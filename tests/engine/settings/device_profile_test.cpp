// SPDX-License-Identifier: GPL-3.0-or-later
// References: the table of the manual, written out here once more, and the JSON Schema.
#include "engine/settings/device_profile.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "tests/support/complaint.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using nlohmann::ordered_json;
using test::TempFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::filesystem::path bundled = SONDE_DEVICES;

struct Row {
  const char* id;
  double force, torque, stiffness, rotational_stiffness, damping, rotational_damping;
};
constexpr Row rows[] = {
    {"lambda.7", 12, 0.2, 8000, 1.0, 30, 0.07},
    {"omega.7", 12, 0, 5000, 0, 30, 0},
    {"premium-1.5-6dof", 8.5, 0.188, 800, 0.3, 5, 0.004},
    {"premium-3.0-6dof", 22, 0.188, 1000, 0.3, 5, 0.004},
    {"sigma.7", 12, 0.2, 4000, 1.0, 30, 0.07},
    {"touch", 3.3, 0, 400, 0, 4, 0},
    {"touch-x", 7.9, 0, 1000, 0, 5, 0},
};

TEST(DeviceProfile, those_that_come_with_the_program_are_the_table) {
  std::vector<std::string> ids;
  for (const Row& row : rows) {
    ids.emplace_back(row.id);
    const DeviceProfile p = find_device_profile(row.id, {&bundled, 1});
    EXPECT_EQ(p.id, row.id);
    EXPECT_EQ(p.max_force.value, row.force) << row.id;
    EXPECT_EQ(p.max_torque.value, row.torque) << row.id;
    EXPECT_EQ(p.max_stiffness.value, row.stiffness) << row.id;
    EXPECT_EQ(p.max_rotational_stiffness.value, row.rotational_stiffness) << row.id;
    EXPECT_EQ(p.max_damping.value, row.damping) << row.id;
    EXPECT_EQ(p.max_rotational_damping.value, row.rotational_damping) << row.id;
    // The driver's limits have a source; nothing else was found.
    EXPECT_THAT(assumed_keys(p),
                ElementsAre("mass", "inertia", "damping", "rotational_damping", "friction",
                            "rotational_friction", "resolution", "rotational_resolution", "delay"));
    for (const ProfileKey& key : profile_keys()) EXPECT_NE((p.*key.value).origin, "") << key.key;
    EXPECT_NO_THROW(SimulatedDevice(simulated(p), 1e-3)) << row.id;
  }
  EXPECT_EQ(device_profile_ids({&bundled, 1}), ids);
}

/// A profile that is right, every value different, one key a line from line 2 on.
ordered_json right() {
  ordered_json json{{"name", "Mine"}};
  double value = 0.01;
  for (const ProfileKey& key : profile_keys()) {
    json[key.key] = {{"value", key.minimum + value * (key.maximum - key.minimum)},
                     {"source", std::string("a book on ") + key.key}};
    value += 0.01;
  }
  return json;
}
std::string lines_of(const ordered_json& json) {
  std::string text = "{\n";
  for (const auto& [key, value] : json.items())
    text += (text.size() > 2 ? ",\n" : "") + ordered_json(key).dump() + ": " + value.dump();
  return text + "\n}\n";
}

TEST(DeviceProfile, every_value_is_read_with_its_origin) {
  ordered_json json = right();
  json["mass"] = {{"value", 0.25}, {"assumed", "a guess"}};
  json["$schema"] = "somewhere";
  const TempFolder folder;
  const DeviceProfile p = read_device_profile(folder.write("my.own.json", lines_of(json)));
  EXPECT_EQ(p.id, "my.own");
  EXPECT_EQ(p.name, "Mine");
  for (const ProfileKey& key : profile_keys()) {
    const ProfileValue& value = p.*key.value;
    EXPECT_EQ(value.value, json[key.key]["value"]) << key.key;
    if (std::string(key.key) == "mass") continue;
    EXPECT_EQ(value.origin, std::string("a book on ") + key.key);
    EXPECT_FALSE(value.assumed);
  }
  EXPECT_EQ(p.mass.origin, "a guess");
  EXPECT_THAT(assumed_keys(p), ElementsAre("mass"));
}

TEST(DeviceProfile, the_simulated_device_is_that_of_the_profile) {
  const TempFolder folder;
  const DeviceProfile p = read_device_profile(folder.write("a.json", lines_of(right())));
  const SimulatedDeviceParameters s = simulated(p);
  EXPECT_EQ(s.translation.inertia, p.mass.value);
  EXPECT_EQ(s.translation.damping, p.damping.value);
  EXPECT_EQ(s.translation.friction, p.friction.value);
  EXPECT_EQ(s.translation.resolution, p.resolution.value);
  EXPECT_EQ(s.translation.limit, p.max_force.value);
  EXPECT_EQ(s.rotation.inertia, p.inertia.value);
  EXPECT_EQ(s.rotation.damping, p.rotational_damping.value);
  EXPECT_EQ(s.translation.most_virtual_damping, p.max_damping.value);
  EXPECT_EQ(s.rotation.most_virtual_damping, p.max_rotational_damping.value);
  EXPECT_EQ(s.rotation.friction, p.rotational_friction.value);
  EXPECT_EQ(s.rotation.resolution, p.rotational_resolution.value);
  EXPECT_EQ(s.rotation.limit, p.max_torque.value);
  EXPECT_EQ(s.delay, p.delay.value);
  EXPECT_EQ(s.translation.hand_stiffness, SimulatedDeviceParameters{}.translation.hand_stiffness);
}

/// The complaint about a profile of this text, from the line on; empty where there is none.
std::string profile_complaint(const std::string& text) {
  return test::complaint_of(text, "bad.json", read_device_profile);
}
/// The complaint where the value of `key` is this JSON text.
std::string complaint_about(const char* key, const std::string& value) {
  std::string text = lines_of(right());
  const std::string start = "\n" + ordered_json(key).dump() + ": ";
  const std::size_t at = text.find(start) + start.size();
  return profile_complaint(text.replace(at, text.find('\n', at) - at, value + ","));
}

TEST(DeviceProfile, bad_files_are_named_with_their_line_and_reason) {
  EXPECT_EQ(profile_complaint(lines_of(right())), "");
  ordered_json json = right();
  json["masss"] = 1;
  EXPECT_THAT(profile_complaint(lines_of(json)),
              AllOf(StartsWith("18: "), HasSubstr("unknown key \"masss\""), HasSubstr("\"mass\"")));
  json = right();
  json.erase("friction");
  EXPECT_THAT(profile_complaint(lines_of(json)),
              AllOf(StartsWith("1: "), HasSubstr("\"friction\" is missing from the profile")));
  json = right();
  json.erase("name");
  EXPECT_THAT(profile_complaint(lines_of(json)), HasSubstr("\"name\" is missing"));

  // "mass" stands in line 9.
  const char* source = R"(, "source": "s"})";
  EXPECT_THAT(complaint_about("mass", R"({"value": -0.1)" + std::string(source)),
              AllOf(StartsWith("9: "), HasSubstr("\"mass\" is -0.1; it must be between 0.001 and "
                                                 "100 kg")));
  EXPECT_THAT(complaint_about("mass", R"({"value": 0)" + std::string(source)),
              HasSubstr("\"mass\" is 0; it must be"));
  EXPECT_THAT(complaint_about("mass", R"({"value": NaN)" + std::string(source)),
              AllOf(StartsWith("9: "), HasSubstr("not JSON")));
  EXPECT_THAT(complaint_about("mass", R"({"value": 1e999)" + std::string(source)),
              AllOf(StartsWith("9: "), HasSubstr("number")));
  EXPECT_THAT(complaint_about("mass", R"({"value": "0.1")" + std::string(source)),
              AllOf(StartsWith("9: "), HasSubstr("\"value\" is a string; expected a number")));
  EXPECT_THAT(complaint_about("mass", "0.1"),
              AllOf(StartsWith("9: "), HasSubstr("\"mass\" is a number; expected an object")));
  EXPECT_THAT(complaint_about("mass", R"({"source": "s"})"),
              AllOf(StartsWith("9: "), HasSubstr("\"value\" is missing from \"mass\"")));
  EXPECT_THAT(complaint_about("mass", R"({"value": 0.1})"), HasSubstr("neither a \"source\" nor"));
  EXPECT_THAT(complaint_about("mass", R"({"value": 0.1, "source": "s", "assumed": "a"})"),
              HasSubstr("both a \"source\" and"));
  EXPECT_THAT(complaint_about("mass", R"({"value": 0.1, "source": ""})"),
              HasSubstr("\"source\" is empty"));
  EXPECT_THAT(complaint_about("mass", R"({"value": 0.1, "sauce": "s"})"),
              AllOf(HasSubstr("\"sauce\""), HasSubstr("\"source\"")));

  EXPECT_THAT(profile_complaint("mass = 0.1\n"), AllOf(StartsWith("1: "), HasSubstr("not JSON")));
  EXPECT_THAT(profile_complaint("{\n\"name\": \"cut"),
              AllOf(StartsWith("2: "), HasSubstr("not JSON")));
  EXPECT_THAT(profile_complaint("[]"), HasSubstr("the file's value is a list; expected an object"));
  EXPECT_THAT(profile_complaint(""), HasSubstr("empty"));
}

TEST(DeviceProfile, an_interval_is_read_and_holds_the_value) {
  ordered_json json = right();
  json["mass"] = {{"value", 0.25}, {"low", 0.2}, {"high", 0.26}, {"source", "measured"}};
  const TempFolder folder;
  const DeviceProfile p = read_device_profile(folder.write("a.json", lines_of(json)));
  ASSERT_TRUE(p.mass.interval);
  EXPECT_EQ(p.mass.interval->low, 0.2);
  EXPECT_EQ(p.mass.interval->high, 0.26);
  EXPECT_FALSE(p.friction.interval);
  const auto about_mass = [](const std::string& ends) {
    return complaint_about("mass", R"({"value": 0.25, )" + ends + R"("source": "s"})");
  };
  EXPECT_EQ(about_mass(R"("low": 0.25, "high": 0.25, )"), "");
  EXPECT_THAT(about_mass(R"("low": 0.2, )"),
              AllOf(StartsWith("9: "), HasSubstr("\"high\" is missing from \"mass\"")));
  EXPECT_THAT(about_mass(R"("high": 0.3, )"), HasSubstr("\"low\" is missing from \"mass\""));
  EXPECT_THAT(about_mass(R"("low": 0.26, "high": 0.3, )"),
              AllOf(StartsWith("9: "), HasSubstr("\"mass\" is not between its \"low\"")));
  EXPECT_THAT(about_mass(R"("low": "0.2", "high": 0.3, )"), HasSubstr("\"low\" is a string"));
  // What is simulated at its ends must be a device there too.
  for (const char* ends : {R"("low": 0, "high": 0.3, )", R"("low": -1, "high": 0.3, )",
                           R"("low": 0.2, "high": 1000, )"})
    EXPECT_THAT(about_mass(ends),
                AllOf(StartsWith("9: "), HasSubstr("it must be between 0.001 and 100 kg")))
        << ends;
}

TEST(DeviceProfile, its_text_reads_back_as_it_was) {
  ordered_json json = right();
  json["mass"] = {{"value", 0.1 / 3}, {"low", 0.03}, {"high", 0.04}, {"source", "a \"scale\" µ"}};
  json["delay"] = {{"value", 1e-3}, {"assumed", "a guess"}};
  const TempFolder folder;
  DeviceProfile p = read_device_profile(folder.write("a.json", lines_of(json)));
  const DeviceProfile again = read_device_profile(folder.write("b.json", device_profile_text(p)));
  EXPECT_EQ(again.id, "b");
  EXPECT_EQ(again.name, p.name);
  for (const ProfileKey& key : profile_keys()) {
    const ProfileValue &was = p.*key.value, &is = again.*key.value;
    EXPECT_EQ(is.value, was.value) << key.key;
    EXPECT_EQ(is.origin, was.origin) << key.key;
    EXPECT_EQ(is.assumed, was.assumed) << key.key;
    EXPECT_EQ(is.interval.has_value(), was.interval.has_value()) << key.key;
  }
  EXPECT_EQ(again.mass.interval->high, 0.04);
  p.mass.interval->low = 1e-4;
  EXPECT_THROW(device_profile_text(p), InputError);
  p.mass.value = 1e-4;
  EXPECT_THROW(device_profile_text(p), InputError);
}

TEST(DeviceProfile, the_users_own_come_first) {
  const TempFolder own;
  ordered_json json = right();
  own.write("touch.json", lines_of(json));
  own.write("mine.json", lines_of(json));
  own.write("notes.txt", "not a profile");
  const std::filesystem::path folders[] = {own.path(), bundled, own / "not there"};
  EXPECT_EQ(find_device_profile("touch", folders).name, "Mine");
  EXPECT_EQ(find_device_profile("touch-x", folders).name, "Touch X");
  EXPECT_EQ(find_device_profile((own / "mine.json").string(), {}).id, "mine");
  EXPECT_EQ(device_profile_ids(folders).size(), std::size(rows) + 1);
}

std::string complaint_about_id(std::string_view id,
                               std::span<const std::filesystem::path> folders) {
  try {
    find_device_profile(id, folders);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(DeviceProfile, an_unknown_id_names_the_nearest) {
  EXPECT_EQ(complaint_about_id("omega7", {&bundled, 1}),
            "no device profile \"omega7\"; the nearest known one is \"omega.7\"");
  EXPECT_THAT(complaint_about_id("../devices/touch", {&bundled, 1}),
              HasSubstr("a profile's file ends in \".json\""));
  EXPECT_THAT(complaint_about_id("touch", {}), HasSubstr("none was found at all"));
  EXPECT_THAT(complaint_about_id("missing.json", {&bundled, 1}), StartsWith("missing.json: "));
}

TEST(DeviceProfile, a_word_that_names_none_is_told_from_a_file_that_cannot_be_used) {
  for (const char* word : {"omega7", "", "Touch"})
    EXPECT_THROW(find_device_profile(word, {&bundled, 1}), UnknownProfile) << word;
  for (const char* path : {"missing.json", "../devices/touch", "/"}) try {
      find_device_profile(path, {&bundled, 1});
      ADD_FAILURE() << path;
    } catch (const UnknownProfile&) {
      ADD_FAILURE() << path;
    } catch (const InputError&) {
    }
}

TEST(DeviceProfile, the_schema_says_what_the_reader_does) {
  const auto schema = ordered_json::parse(test::text_of(SONDE_DEVICE_SCHEMA));
  EXPECT_EQ(schema["additionalProperties"], false);
  std::vector<std::string> keys{"$schema", "name"}, required{"name"};
  for (const ProfileKey& key : profile_keys()) {
    keys.emplace_back(key.key);
    required.emplace_back(key.key);
    const auto& property = schema["properties"][key.key];
    EXPECT_EQ(property["description"], std::string(key.unit) + ". " + key.doc);
    for (const char* each : {"value", "low", "high"}) {
      EXPECT_EQ(property["properties"][each]["minimum"], key.minimum) << key.key;
      EXPECT_EQ(property["properties"][each]["maximum"], key.maximum) << key.key;
    }
    EXPECT_EQ(property["properties"]["value"]["maximum"], key.maximum) << key.key;
  }
  std::vector<std::string> named;
  for (const auto& [key, value] : schema["properties"].items()) named.push_back(key);
  EXPECT_EQ(named, keys);
  EXPECT_EQ(schema["required"].get<std::vector<std::string>>(), required);
  const auto& value = schema["$defs"]["value"];
  EXPECT_EQ(value["additionalProperties"], false);
  EXPECT_EQ(value["required"], ordered_json({"value"}));
  EXPECT_EQ(value["properties"].size(), 5u);
  EXPECT_EQ(value["dependentRequired"], ordered_json({{"low", {"high"}}, {"high", {"low"}}}));
}

}  // namespace
}  // namespace sonde
