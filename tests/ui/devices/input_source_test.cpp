// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/input_source.hpp"

#include <gmock/gmock.h>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::ui {
namespace {

using testing::HasSubstr;

/// Those of the program, and a folder of the user's.
struct HolderTest : testing::Test {
  sonde::test::TempFolder own;
  std::vector<std::filesystem::path> folders{own.path(), SONDE_RESOURCES "/devices"};
};

TEST_F(HolderTest, an_id_or_a_file_is_a_simulated_device) {
  const InputSource sigma = find_source("sigma.7", folders);
  ASSERT_TRUE(std::holds_alternative<SimulatedSource>(sigma));
  EXPECT_EQ(std::get<SimulatedSource>(sigma).profile.max_force.value, 12);
  EXPECT_EQ(name_of(sigma), "sigma.7 (simulated)");
  EXPECT_EQ(settings_name_of(sigma), "sigma.7.json");
  const InputSource file = find_source(SONDE_RESOURCES "/devices/touch.json", folders);
  EXPECT_TRUE(same(file, find_source("touch", folders)));
  EXPECT_FALSE(same(file, sigma));
}

TEST_F(HolderTest, a_table_of_poses_is_a_recorded_path) {
  const auto file =
      own.write("way.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n0.5,0.1,0,0,1,0,0,0\n");
  const InputSource path = find_source(file.string(), folders);
  ASSERT_TRUE(std::holds_alternative<PathSource>(path));
  EXPECT_EQ(std::get<PathSource>(path).path->size(), 2u);
  EXPECT_EQ(name_of(path), "way.csv (recorded path)");
  EXPECT_FALSE(same(path, PathSource{})) << "the scene's own";
  EXPECT_TRUE(same(path, find_source(file.string(), folders)));
}

TEST_F(HolderTest, a_bad_table_is_named_with_its_line_and_reason) {
  const auto complaint = [&](const std::string& text) -> std::string {
    try {
      find_source(own.write("way.csv", text).string(), folders);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  const std::string header = "t,px,py,pz,qw,qx,qy,qz\n";
  EXPECT_THAT(complaint(header + "0,0,0,0,1,0,0,0\n0.5,0.1,zero,0,1,0,0,0\n"),
              testing::AllOf(HasSubstr("way.csv:3"), HasSubstr("zero")));
  EXPECT_THAT(complaint(header), HasSubstr("way.csv: it holds no pose"));
  EXPECT_THROW(find_source("no/such.csv", folders), InputError);
}

TEST_F(HolderTest, the_mouse_has_no_settings) {
  const InputSource mouse = find_source("mouse", folders);
  EXPECT_TRUE(std::holds_alternative<MouseSource>(mouse));
  EXPECT_EQ(settings_name_of(mouse), "");
  EXPECT_FALSE(same(mouse, PathSource{}));
}

TEST_F(HolderTest, what_is_not_there_is_said) {
  EXPECT_THROW(find_source("", folders), UnknownDevice);
  try {
    find_source("lambda7", folders);
    FAIL();
  } catch (const UnknownDevice& unknown) {
    EXPECT_THAT(unknown.what(), HasSubstr("nearest known one is \"lambda.7\""));
  }
  try {
    find_source("/dev/hidraw99", folders);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/hidraw99: "));
  }
  EXPECT_THROW(find_source("no/such.json", folders), InputError);
}

TEST_F(HolderTest, a_connected_device_is_known_by_its_ids) {
  const auto puck = [](const char* path, const char* serial) -> InputSource {
    return source_of({path, 0x256f, 0xc635, "", "", serial, 0, {}});
  };
  const InputSource one = puck("/dev/hidraw3", "A1");
  EXPECT_EQ(name_of(one), "SpaceMouse Compact");
  EXPECT_EQ(settings_name_of(one), "256f-c635-A1.json");
  EXPECT_TRUE(same(one, puck("/dev/hidraw9", "A1"))) << "plugged in again";
  EXPECT_FALSE(same(one, puck("/dev/hidraw3", "B2")));
  EXPECT_FALSE(same(puck("/dev/hidraw3", ""), puck("/dev/hidraw9", ""))) << "two alike";
  EXPECT_EQ(std::get<ConnectedSource>(one).choice.path, "/dev/hidraw3");
}

TEST_F(HolderTest, without_a_serial_number_the_port_tells_two_alike_apart) {
  const auto puck = [](const char* path, const char* port) -> InputSource {
    return source_of({path, 0x256f, 0xc635, "", "", "", 0, {}, port});
  };
  const InputSource one = puck("/dev/hidraw3", "usb-0000:00:14.0-2/input0");
  EXPECT_TRUE(same(one, puck("/dev/hidraw9", "usb-0000:00:14.0-2/input0"))) << "plugged in again";
  EXPECT_FALSE(same(one, puck("/dev/hidraw3", "usb-0000:00:14.0-3/input0")));
  EXPECT_EQ(settings_name_of(one), "256f-c635-port-usb-0000_00_14.0-2_input0.json");
  EXPECT_EQ(model_settings_name_of(one), "256f-c635.json");
  EXPECT_EQ(model_settings_name_of(source_of({"", 0x256f, 0xc635, "", "", "A1", 0, {}, "p"})), "");
  EXPECT_EQ(model_settings_name_of(MouseSource{}), "");
}

TEST_F(HolderTest, sticks_begin_with_a_wider_dead_zone_than_pucks) {
  const InputSource pad = source_of({"/dev/hidraw3", 0x046d, 0xc216, "", "", "", 0, {joystick}});
  EXPECT_EQ(usual_settings(pad).axes.axes[0].dead_zone, 0.125) << "as Linux has it for joysticks";
  EXPECT_EQ(usual_settings(MouseSource{}).axes.axes[0].dead_zone, AxisSetting{}.dead_zone);
}

TEST_F(HolderTest, a_list_tells_two_alike_apart_and_their_names_stay) {
  const auto puck = [](const char* path) -> InputSource {
    return source_of({path, 0x256f, 0xc635, "", "", "", 0, {}});
  };
  const std::vector<InputSource> two{MouseSource{}, puck("/dev/hidraw3"), puck("/dev/hidraw4")};
  EXPECT_EQ(labels_of(two), (std::vector<std::string>{"Mouse", "SpaceMouse Compact (/dev/hidraw3)",
                                                      "SpaceMouse Compact (/dev/hidraw4)"}));
  EXPECT_EQ(name_of(two[1]), "SpaceMouse Compact") << "the node is another when it comes back";
  EXPECT_EQ(labels_of(std::span(two).first(2))[1], "SpaceMouse Compact") << "alone";
}

}  // namespace
}  // namespace sonde::ui
