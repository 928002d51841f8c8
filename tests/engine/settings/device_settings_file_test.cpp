// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/device_settings_file.hpp"

#include <gmock/gmock.h>

#include "engine/base/error.hpp"
#include "engine/settings/settings.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::TempFolder;
using testing::AllOf;
using testing::HasSubstr;

DeviceSettings unusual() {
  DeviceSettings settings;
  settings.control = DeviceSettings::Control::position;
  settings.frame = DeviceSettings::Frame::y_up;
  settings.scaling = 1.0 / 3;
  settings.reach = 0.07;
  settings.turn = 0.1 + 0.2;
  settings.smoothing = 0;
  settings.clutch_button = 12;
  for (int i = 0; i < 6; ++i)
    settings.axes.axes[static_cast<std::size_t>(i)] = {5 - i, i % 2 == 0, 0.1 * i, 0.05 * i};
  settings.rate_hz = 2000.5;
  settings.passivity_control = false;
  return settings;
}

void expect_same(const DeviceSettings& a, const DeviceSettings& b) {
  EXPECT_EQ(a.control, b.control);
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.rate_hz, b.rate_hz);
  EXPECT_EQ(a.passivity_control, b.passivity_control);
  for (const Setting& s : device_settings()) EXPECT_EQ(get(a, s.key), get(b, s.key)) << s.key;
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(a.axes.axes[i].source, b.axes.axes[i].source);
    EXPECT_EQ(a.axes.axes[i].inverted, b.axes.axes[i].inverted);
    for (const Setting& s : axis_settings())
      EXPECT_EQ(get(a.axes.axes[i], s.key), get(b.axes.axes[i], s.key)) << s.key;
  }
}

DeviceSettings read_back(const std::string& text) {
  const TempFolder folder;
  return read_device_settings(folder.write("kept.json", text));
}

TEST(DeviceSettingsFile, what_was_written_reads_back_to_the_bit) {
  expect_same(read_back(device_settings_text(unusual())), unusual());
  expect_same(read_back(device_settings_text({})), {});
}

TEST(DeviceSettingsFile, what_is_left_out_has_its_default) {
  expect_same(read_back("{}"), {});
  DeviceSettings one;
  one.axes.axes[4].inverted = true;
  expect_same(read_back(R"({"axes": {"ry": {"inverted": true}}})"), one);
}

std::string settings_complaint(const std::string& text) {
  try {
    read_back(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(DeviceSettingsFile, bad_input_is_named_with_its_line) {
  EXPECT_THAT(settings_complaint("{\n\"scalin\": 1}"),
              AllOf(HasSubstr("kept.json:2: "), HasSubstr("nearest known one is \"scaling\"")));
  EXPECT_THAT(settings_complaint("{\n\n\"scaling\": 0}"),
              AllOf(HasSubstr(":3: "), HasSubstr("between")));
  EXPECT_THAT(settings_complaint(R"({"control": "rat"})"), HasSubstr("value is \"rate\""));
  EXPECT_THAT(settings_complaint(R"({"control": 1})"), HasSubstr("expected a string"));
  EXPECT_THAT(settings_complaint(R"({"axes": {"rw": {}}})"), HasSubstr("unknown key \"rw\""));
  EXPECT_THAT(settings_complaint(R"({"axes": {"x": {"swap": 1}}})"),
              HasSubstr("unknown key \"swap\""));
  EXPECT_THAT(settings_complaint(R"({"axes": {"x": {"inverted": 1}}})"),
              HasSubstr("expected true or false"));
  EXPECT_THAT(settings_complaint(R"({"axes": {"x": {"dead_zone": 1}}})"),
              HasSubstr("\"dead_zone\" is 1"));
  EXPECT_THAT(settings_complaint(R"({"clutch_button": 1.5})"), HasSubstr("a whole number"));
  EXPECT_THAT(settings_complaint(R"({"servo": {"rate": 900}})"), HasSubstr("rate_hz"));
  EXPECT_THAT(settings_complaint(R"({"servo": {"rate_hz": 9}})"),
              HasSubstr("between 500 and 10000 Hz"));
}

TEST(DeviceSettingsFile, each_device_has_a_name_of_its_own_that_is_no_path) {
  EXPECT_EQ(device_settings_name(0x256f, 0xc635, ""), "256f-c635.json");
  EXPECT_EQ(device_settings_name(0x256f, 0xc635, "A1"), "256f-c635-A1.json");
  EXPECT_EQ(device_settings_name(0x46d, 0xc626, "../a b"), "046d-c626-.._a_b.json");
  EXPECT_EQ(device_settings_name("sigma.7"), "sigma.7.json");
}

}  // namespace
}  // namespace sonde
