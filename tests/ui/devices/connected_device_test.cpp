// SPDX-License-Identifier: GPL-3.0-or-later
// A SpaceMouse that umockdev plays moves the probe of a running session, by the real hidapi.

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

#include "tests/engine/devices/controller_descriptors.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/mock_hid.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/devices/device_control.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::Bytes;
using sonde::test::joint_descriptor;
using sonde::test::MockHid;
using sonde::test::MockSystem;
using sonde::test::words;

class ConnectedDevice : public WindowTest {
 protected:
  void SetUp() override {
    puck.descriptor = joint_descriptor();
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
  }
  void TearDown() override { window.reset(); }

  /// Under the next number each time, as the test bed wants it.
  void plug() {
    ++puck.number;
    system.plug(puck);
  }
  /// The puck repeats itself about 62 times a second, as it is pushed, until something holds.
  bool push_until(const std::vector<int>& deflection, const std::function<bool()>& holds) {
    return wait_until([&] {
      system.send(puck.number, words(1, deflection));
      wait(16);
      return holds();
    });
  }
  QString status() const { return window->findChild<QLabel*>("device_status")->text(); }
  Vec3 probe() const { return shown().separation.device.p; }
  DeviceStatus device() { return window->devices().report().device; }

  MockSystem system;
  MockHid puck;
};

TEST_F(ConnectedDevice, replayed_it_moves_the_probe_and_may_be_unplugged_in_the_middle) {
  plug();
  window->devices().choose(find_source("auto", {}));
  ASSERT_TRUE(wait_until([&] { return status() == "SpaceMouse Compact: ready"; }))
      << status().toStdString();
  const Vec3 right = window->viewport().camera().axes().right;
  const Vec3 start = probe();
  const auto moved = [&](const Vec3& from) { return (probe() - from).dot(right); };
  ASSERT_TRUE(push_until({350, 0, 0, 0, 0, 0}, [&] { return moved(start) > 0.01; }));
  EXPECT_LT(((probe() - start) - right * moved(start)).norm(), 1e-9) << "to the right";

  system.unplug(puck.number);
  ASSERT_TRUE(wait_until([&] { return device().state == DeviceState::absent; }));
  EXPECT_TRUE(wait_until([&] { return status().contains("unplugged"); })) << status().toStdString();
  const Vec3 there = probe();
  const std::uint64_t tick = shown().tick;
  ASSERT_TRUE(wait_until([&] { return shown().tick > tick + 100; })) << "the session lives";
  EXPECT_EQ(probe(), there);

  plug();
  ASSERT_TRUE(wait_until([&] { return status() == "SpaceMouse Compact: ready"; }));
  EXPECT_EQ(device().connections, 2U);
  EXPECT_LT((probe() - there).norm(), 1e-12) << "back, it does not jump";
  EXPECT_TRUE(push_until({-350, 0, 0, 0, 0, 0}, [&] { return moved(there) < -0.01; }));
}

TEST_F(ConnectedDevice, what_is_plugged_in_shows_in_the_dock_and_can_be_chosen) {
  auto* list = window->findChild<QComboBox*>("holder");
  EXPECT_LT(list->findText("SpaceMouse Compact"), 0);
  plug();
  ASSERT_TRUE(wait_until([&] { return list->findText("SpaceMouse Compact") >= 0; }));
  emit list->activated(list->findText("SpaceMouse Compact"));
  ASSERT_TRUE(wait_until([&] { return device().state == DeviceState::ready; }));
  EXPECT_EQ(list->currentText(), "SpaceMouse Compact");
  window->findChild<QCheckBox*>("device_led")->setChecked(true);
  wait(50);
  EXPECT_EQ(system.written(puck.number, 30000), (Bytes{4, 1}));
  // The button holds the clutch open: pushed, the probe stays.
  system.send(puck.number, Bytes{3, 1, 0});
  auto* clutch = window->findChild<QLabel*>("device_clutch");
  ASSERT_TRUE(wait_until([&] { return clutch->text().startsWith("open"); }));
  const Vec3 before = probe();
  const std::uint64_t reports = device().reports;
  ASSERT_TRUE(push_until({350, 0, 0, 0, 0, 0}, [&] { return device().reports > reports + 20; }));
  EXPECT_EQ(probe(), before);
}

TEST_F(ConnectedDevice,
       of_two_alike_the_node_asked_for_moves_the_probe_and_the_dock_tells_them_apart) {
  puck.serial = "";
  plug();
  const std::string first = puck.path();
  plug();
  const std::string second = puck.path();
  window->devices().choose(find_source(second, {}));
  ASSERT_TRUE(wait_until([&] { return device().state == DeviceState::ready; }));
  EXPECT_EQ(device().path, second);
  const Vec3 start = probe();
  EXPECT_TRUE(push_until({350, 0, 0, 0, 0, 0}, [&] { return (probe() - start).norm() > 0.01; }));
  auto* list = window->findChild<QComboBox*>("holder");
  const auto entry = [&](const std::string& path) {
    return list->findText("SpaceMouse Compact (" + QString::fromStdString(path) + ")");
  };
  ASSERT_TRUE(wait_until([&] { return entry(first) >= 0 && entry(second) >= 0; }));
  EXPECT_EQ(list->currentIndex(), entry(second));
  emit list->activated(entry(first));
  ASSERT_TRUE(wait_until([&] { return device().path == first; }));
  EXPECT_TRUE(wait_until([&] { return list->currentIndex() == entry(first); }));
  EXPECT_TRUE(wait_until([&] { return status() == "SpaceMouse Compact: ready"; }))
      << "the node is the list's alone: " << status().toStdString();
}

TEST_F(ConnectedDevice, a_game_pad_moves_the_probe_and_the_dock_tells_how_long_that_takes) {
  puck.vendor = 0x054c;
  puck.product = 0x09cc;
  puck.name = "Wireless Controller";
  puck.descriptor = sonde::test::dualshock_descriptor();
  plug();
  window->devices().choose(find_source("wireless controller", {}));
  ASSERT_TRUE(wait_until([&] { return device().state == DeviceState::ready; }));
  EXPECT_EQ(window->devices().settings().axes.axes[0].dead_zone, 0.125);
  const Vec3 right = window->viewport().camera().axes().right;
  const Vec3 start = probe();
  const auto stick = [&](std::uint8_t x) {
    Bytes report(64);
    report[0] = 1;
    report[1] = x;
    for (int i = 2; i < 5; ++i) report[static_cast<std::size_t>(i)] = 128;
    report[5] = 8;
    system.send(puck.number, report);
    wait(16);
  };
  for (int i = 0; i < 20; ++i) stick(std::uint8_t(128 + i % 15));  // within the dead zone
  EXPECT_LT((probe() - start).norm(), 1e-12);
  ASSERT_TRUE(wait_until([&] {
    stick(255);
    return (probe() - start).dot(right) > 0.01;
  }));
  const auto* latency = window->findChild<QLabel*>("device_latency");
  EXPECT_TRUE(wait_until([&] {
    stick(128);
    return latency->text().contains("99.9 %");
  })) << latency->text().toStdString();
}

TEST_F(ConnectedDevice, two_alike_in_two_ports_keep_settings_of_their_own) {
  puck.serial = "";
  puck.port = "1";
  plug();
  const std::string left = puck.path();
  puck.port = "2";
  plug();
  const std::string right = puck.path();
  const auto take = [&](const std::string& path) {
    window->devices().choose(find_source(path, {}));
    return window->devices().settings();
  };
  DeviceSettings settings = take(left);
  settings.scaling = 3;
  window->devices().set_settings(settings);
  settings = take(right);
  EXPECT_EQ(settings.scaling, 3) << "the newest of the model, in a port without settings";
  settings.scaling = 5;
  window->devices().set_settings(settings);
  EXPECT_EQ(take(left).scaling, 3);
  EXPECT_EQ(take(right).scaling, 5);
}

TEST_F(ConnectedDevice, of_two_alike_the_one_that_opens_is_taken_by_name) {
  puck.serial = "";
  puck.descriptor_in_sysfs = false;
  plug();
  puck.descriptor_in_sysfs = true;
  plug();
  const InputSource found = find_source("SpaceMouse Compact", {});
  ASSERT_TRUE(std::holds_alternative<ConnectedSource>(found));
  EXPECT_EQ(std::get<ConnectedSource>(found).choice.path, puck.path());
}

TEST_F(ConnectedDevice, one_that_does_not_open_says_why_and_the_mouse_can_go_on) {
  puck.descriptor_in_sysfs = false;
  plug();
  EXPECT_THROW(find_source("SpaceMouse Compact", {}), InputError);
  EXPECT_EQ(name_of(find_source("auto", {})), "Mouse");
  auto* list = window->findChild<QComboBox*>("holder");
  ASSERT_TRUE(wait_until([&] { return list->findText("SpaceMouse Compact") >= 0; }));
  emit list->activated(list->findText("SpaceMouse Compact"));
  EXPECT_TRUE(wait_until([&] { return status().contains("refused"); })) << status().toStdString();
  EXPECT_TRUE(window->findChild<QLabel*>("device_reason")->text().contains("report descriptor"));
  emit list->activated(list->findText("Mouse"));
  Pose moved = window->session()->device_pose();
  moved.p.y() += 0.01;
  window->set_device_pose(moved);
  EXPECT_TRUE(wait_until([&] { return probe() == moved.p; }));
}

}  // namespace
}  // namespace sonde::ui::test
