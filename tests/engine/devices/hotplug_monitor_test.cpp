// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hotplug_monitor.hpp"

#include "tests/engine/devices/over_hid.hpp"

namespace sonde::test {
namespace {

TEST_F(PuckTest, what_is_plugged_in_and_out_is_seen_without_opening_it) {
  HotplugMonitor watch;
  EXPECT_TRUE(watch.connected().empty());
  puck.answers_ioctl = false;  // it could not be opened
  plug();
  ASSERT_TRUE(comes_true([&] { return watch.connected().size() == 1; }));
  EXPECT_EQ(watch.connected()[0].info.path, puck.path());
  EXPECT_EQ(watch.connected()[0].kind, DeviceKind::space_mouse);
  unplug();
  EXPECT_TRUE(comes_true([&] { return watch.connected().empty(); }));
}

}  // namespace
}  // namespace sonde::test
