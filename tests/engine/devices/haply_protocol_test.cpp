// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/haply_protocol.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/geometry/random.hpp"

namespace sonde::test {
namespace {

using haply::decode;
using haply::encode;

/// The members that the maker's documentation shows ("WebSocket Protocol", step 1).
constexpr const char* first_message = R"({"session_id": 7, "inverse3": [{"device_id": "049D",
  "config": {"type": "inverse3", "preset": "defaults", "basis": {"permutation": "XYZ"},
    "mount": {"position": {"x": 0, "y": 0, "z": 0}, "scale": {"x": 1, "y": 1, "z": 1}}},
  "state": {"cursor_position": {"x": 0.0, "y": -0.12, "z": 0.15},
    "cursor_velocity": {"x": 0.0, "y": 0.0, "z": 0.0}, "control_mode": "idle"},
  "status": {"calibrated": true, "in_use": false, "power_supply": true, "ready": true}}],
  "verse_grip": [],
  "wireless_verse_grip": [{"device_id": "61576", "state": {"battery_level": 0.5, "hall": 3,
    "orientation": {"w": 0.5, "x": 0.5, "y": -0.5, "z": 0.5},
    "buttons": {"a": false, "b": true, "c": false}}, "status": {"awake": true}}]})";

TEST(HaplyProtocol, the_first_message_says_what_is_connected) {
  const auto message = decode(first_message);
  ASSERT_TRUE(message);
  ASSERT_EQ(message->arms.size(), 1U);
  const haply::Arm& arm = message->arms[0];
  EXPECT_EQ(arm.id, "049D");
  EXPECT_EQ(arm.model, "inverse3");
  EXPECT_EQ(arm.position, Vec3(0, -0.12, 0.15));
  EXPECT_EQ(arm.calibrated, true);
  EXPECT_EQ(arm.powered, true);
  EXPECT_EQ(arm.basis, "XYZ");
  EXPECT_EQ(arm.mount_scaled, false);
  EXPECT_FALSE(arm.place_scaled);
  ASSERT_EQ(message->grips.size(), 1U);
  const haply::Grip& grip = message->grips[0];
  EXPECT_EQ(grip.id, "61576");
  ASSERT_TRUE(grip.orientation);
  EXPECT_EQ(grip.orientation->coeffs(), Quat(0.5, 0.5, -0.5, 0.5).coeffs());
  EXPECT_EQ(grip.ready, true);
  EXPECT_EQ(grip.buttons, 2U);
}

TEST(HaplyProtocol, later_messages_leave_out_what_has_not_changed) {
  const auto message = decode(
      R"({"inverse3": [{"device_id": "1", "state": {"cursor_position": {"x": 1, "y": 2, "z": 3}}}]})");
  ASSERT_TRUE(message);
  ASSERT_EQ(message->arms.size(), 1U);
  EXPECT_EQ(message->arms[0].position, Vec3(1, 2, 3));
  EXPECT_FALSE(message->arms[0].model || message->arms[0].calibrated ||
               message->arms[0].mount_scaled);
  EXPECT_TRUE(message->grips.empty());
  EXPECT_TRUE(decode("{}"));
  EXPECT_TRUE(decode(R"({"inverse3": null})"));
}

TEST(HaplyProtocol, a_scale_of_the_mount_or_of_the_scene_is_seen) {
  const auto arm = [](const std::string& rest) {
    return decode(R"({"inverse3": [{"device_id": "1", )" + rest + "}]}")->arms.at(0);
  };
  const std::string two = R"({"scale": {"x": 1, "y": 1, "z": 2}})";
  const std::string one = R"({"scale": {"x": 1, "y": 1, "z": 1.0000000001}})";
  EXPECT_EQ(arm(R"("config": {"mount": )" + two + "}").mount_scaled, true);
  EXPECT_EQ(arm(R"("config": {"mount": {"transform": )" + two + "}}").mount_scaled, true);
  EXPECT_EQ(arm(R"("config": {"mount": )" + one + "}").mount_scaled, false);
  EXPECT_EQ(arm(R"("state": {"transform": )" + two + "}").place_scaled, true);
  EXPECT_EQ(arm(R"("state": {"transform": )" + two + "}").mount_scaled, std::nullopt);
  EXPECT_EQ(arm(R"("state": {})").place_scaled, std::nullopt);
}

TEST(HaplyProtocol, what_is_no_message_is_refused) {
  for (const char* text :
       {"", "[]", "7", "null", "{", "\"inverse3\"", R"({"inverse3": {}})", R"({"inverse3": [{}]})",
        R"({"inverse3": [{"device_id": 7}]})", R"({"inverse3": [7]})",
        R"({"inverse3": [{"device_id": "1", "state": {"cursor_position": {"x": 1, "y": 2}}}]})",
        R"({"inverse3": [{"device_id": "1", "state": {"cursor_position": [1, 2, 3]}}]})",
        R"({"inverse3": [{"device_id": "1",
            "state": {"cursor_position": {"x": NaN, "y": 0, "z": 0}}}]})",
        R"({"inverse3": [{"device_id": "1",
            "state": {"cursor_position": {"x": 1e999, "y": 0, "z": 0}}}]})",
        R"({"inverse3": [{"device_id": "1",
            "state": {"cursor_position": {"x": "1", "y": 0, "z": 0}}}]})",
        R"({"inverse3": [{"device_id": "1",
            "state": {"cursor_position": {"x": null, "y": 0, "z": 0}}}]})",
        R"({"inverse3": [{"device_id": "1", "status": {"calibrated": 1}}]})",
        R"({"wireless_verse_grip": [{"device_id": "1", "state": {"orientation": {"w": 1}}}]})"})
    EXPECT_FALSE(decode(text)) << text;
  EXPECT_FALSE(decode(std::string(100000, '[')));
}

/// Whatever comes, it is a message or none: bytes of the example changed, cut off or doubled.
TEST(HaplyProtocol, damaged_messages_do_no_harm) {
  Random random(5);
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = first_message;
    for (int k = 0; k < 3; ++k) {
      const auto at =
          static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(text.size() - 1));
      const double kind = random.uniform(0, 3);
      if (kind < 1)
        text[at] = static_cast<char>(random.uniform(0, 256));
      else if (kind < 2)
        text.erase(at, 1);
      else
        text.insert(at, text.substr(at, 5));
    }
    if (const auto message = decode(text)) {
      ++read;
      for (const haply::Arm& arm : message->arms)
        EXPECT_TRUE(!arm.position || arm.position->allFinite());
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 19000);
}

TEST(HaplyProtocol, a_command_is_what_the_documentation_shows) {
  const auto json = nlohmann::json::parse(encode("049D", {.force = {1.5, -2, 1e-9}}));
  EXPECT_EQ(json, nlohmann::json::parse(R"({"inverse3": [{"device_id": "049D", "commands":
      {"set_cursor_force": {"values": {"x": 1.5, "y": -2.0, "z": 1e-9}}}}]})"));
  const auto more =
      nlohmann::json::parse(encode("049D", {.ask_everything = true, .set_basis = true}));
  EXPECT_EQ(more["session"], nlohmann::json::parse(R"({"force_render_full_state": {},
      "configure": {"basis": {"permutation": "XYZ"}}})"));
}

}  // namespace
}  // namespace sonde::test
