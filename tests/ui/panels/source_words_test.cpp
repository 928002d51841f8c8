// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/source_words.hpp"

#include <gtest/gtest.h>

#include "ui/devices/device_control.hpp"

namespace sonde::ui::test {
namespace {

SourceReport arm() {
  SourceReport out;
  out.device.capabilities.position = out.device.capabilities.force = true;
  return out;
}

DeviceProfile profile() {
  DeviceProfile out;
  out.id = "sigma.7";
  out.mass.assumed = true;
  return out;
}

TEST(SourceWords, say_by_what_gains_that_wait_are_judged) {
  SourceReport report = arm();
  EXPECT_TRUE(words_of(report).contains("No profile has its name"))
      << words_of(report).toStdString();
  EXPECT_TRUE(words_of(report).contains("0.200 N·s/m"));
  report.profile = profile();
  EXPECT_TRUE(words_of(report).contains("by the profile sigma.7. Assumed: mass."))
      << words_of(report).toStdString();
  report.device.capabilities.force = false;
  EXPECT_FALSE(words_of(report).contains("wait"));
}

TEST(SourceWords, of_a_simulated_device_say_what_is_assumed_and_else_nothing_of_it) {
  DeviceProfile one = profile();
  EXPECT_TRUE(words_of(one).endsWith("Assumed: mass."));
  one.mass.assumed = false;
  EXPECT_FALSE(words_of(one).contains("Assumed"));
}

TEST(SourceWords, of_a_device_say_what_it_can_and_what_is_wrong_a_line_each) {
  SourceReport report;
  report.device.path = "/dev/hidraw7";
  report.device.capabilities.buttons = 2;
  report.device.reason = "it is silent";
  EXPECT_EQ(words_of(report),
            QStringLiteral("/dev/hidraw7: tells deflections, no force, 2 buttons\nit is silent"));
}

}  // namespace
}  // namespace sonde::ui::test
