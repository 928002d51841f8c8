// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/device_panel.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <utility>

#include "engine/settings/device_settings_file.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/resources.hpp"
#include "ui/devices/hand_grip.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

/// The dock alone, as it shows a puck.
class DevicePanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    panel = std::make_unique<DevicePanel>();
    QObject::connect(panel.get(), &DevicePanel::settings_changed,
                     [this](const DeviceSettings& settings) { changes.push_back(settings); });
    QObject::connect(panel.get(), &DevicePanel::chosen,
                     [this](const InputSource& source) { choices.push_back(name_of(source)); });
    QObject::connect(panel.get(), &DevicePanel::led_switched, [this](bool on) { led = on; });
    panel->show();
  }
  template <class T>
  T* find(const char* name) {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  static SourceReport report(bool position) {
    SourceReport report;
    DeviceStatus& device = report.device;
    device.state = DeviceState::ready;
    device.path = "/dev/hidraw7";
    device.capabilities.position = device.capabilities.force = position;
    device.capabilities.led = !position;
    device.capabilities.max_force = 8;
    device.capabilities.max_torque = 0.25;
    device.reports = 1000;
    device.refused = 3;
    device.lost = 5;
    device.connections = 2;
    report.reports_per_s = 62.4;
    return report;
  }

  const InputSource puck = ConnectedSource{.choice = {1, 2, ""}, .name = "Puck"};
  std::unique_ptr<DevicePanel> panel;
  std::vector<DeviceSettings> changes;
  std::vector<std::string> choices;
  bool led = false;
};

TEST_F(DevicePanelTest, a_connected_device_shows_its_numbers_with_units) {
  panel->show_settings(puck, {});
  SourceReport now = report(true);
  now.clutch_open = true;
  panel->show_report(puck, now);
  EXPECT_TRUE(find<QLabel>("device_state")->text().contains("ready"));
  EXPECT_TRUE(find<QLabel>("device_reason")->text().contains("force to 8.00 N and 0.250 N·m"))
      << find<QLabel>("device_reason")->text().toStdString();
  EXPECT_EQ(find<QLabel>("device_rate")->text(), "62 Hz");
  EXPECT_EQ(find<QLabel>("device_lost")->text(), "5 reports");
  EXPECT_EQ(find<QLabel>("device_refused")->text(), "3 of 1000");
  EXPECT_EQ(find<QLabel>("device_connections")->text(), "2 times");
  EXPECT_TRUE(find<QLabel>("device_clutch")->text().startsWith("open"));
  now.device.state = DeviceState::faulty;
  now.device.reason = "its handle jumped 200 mm";
  panel->show_report(puck, now);
  EXPECT_TRUE(find<QLabel>("device_state")->text().contains("faulty"));
  EXPECT_TRUE(find<QLabel>("device_reason")->text().contains("jumped 200 mm"));
  now.device.scheduling = "no real-time scheduling: not permitted";
  panel->show_report(puck, now);
  EXPECT_TRUE(find<QLabel>("device_reason")->text().contains("no real-time scheduling"));
}

TEST_F(DevicePanelTest, it_shows_what_means_something_to_the_device_and_no_more) {
  const auto shown = [this](const char* name) { return find<QWidget>(name)->isVisible(); };
  panel->show_settings(MouseSource{}, {});
  panel->show_report(MouseSource{}, {});
  EXPECT_FALSE(shown("scaling_row") || shown("device_rate") || shown("axis_x_gain"));
  panel->show_settings(SimulatedSource{}, {});
  panel->show_report(SimulatedSource{}, {});
  EXPECT_TRUE(shown("scaling_row"));
  EXPECT_FALSE(shown("reach_row") || shown("device_rate") || shown("axis_x_gain"));
  panel->show_settings(puck, {});
  panel->show_report(puck, report(false));
  EXPECT_TRUE(shown("scaling_row") && shown("reach_row") && shown("axis_x_gain"));
  EXPECT_TRUE(shown("device_led") && shown("dead_zone_row"));
  panel->show_report(puck, report(true));
  EXPECT_TRUE(shown("scaling_row") && shown("clutch_button_row") && shown("axis_x_gain"));
  EXPECT_FALSE(shown("reach_row") || shown("smoothing_row") || shown("device_led"));
  EXPECT_FALSE(find<QWidget>("axis_x_dead_zone")->isEnabled());
}

TEST_F(DevicePanelTest, every_change_is_reported_with_all_the_rest_as_it_was) {
  DeviceSettings settings;
  settings.scaling = 3;
  panel->show_settings(puck, settings);
  panel->show_report(puck, report(false));
  EXPECT_TRUE(changes.empty()) << "showing is no change";
  find<TypedValue>("turn_value")->setValue(2);
  find<QComboBox>("axis_y_from")->setCurrentIndex(2);
  find<QCheckBox>("axis_rz_inverted")->click();
  find<TypedValue>("axis_rx_gain")->setValue(0.5);
  ASSERT_EQ(changes.size(), 4u);
  const DeviceSettings& last = changes.back();
  EXPECT_EQ(last.scaling, 3);
  EXPECT_EQ(last.turn, 2);
  EXPECT_EQ(last.axes.axes[1].source, 2);
  EXPECT_TRUE(last.axes.axes[5].inverted);
  EXPECT_EQ(last.axes.axes[3].gain, 0.5);
  find<TypedValue>("dead_zone_value")->setValue(0.2);
  for (const AxisSetting& axis : changes.back().axes.axes) EXPECT_EQ(axis.dead_zone, 0.2);
  EXPECT_EQ(find<TypedValue>("axis_z_dead_zone")->value(), 0.2);
  find<QCheckBox>("device_led")->click();
  EXPECT_TRUE(led);
}

TEST_F(DevicePanelTest, the_list_has_the_holder_now_and_choosing_is_told) {
  panel->show_choices({MouseSource{}, puck}, puck);
  auto* list = find<QComboBox>("holder");
  EXPECT_EQ(list->currentText(), "Puck");
  EXPECT_TRUE(choices.empty());
  emit list->activated(0);
  EXPECT_EQ(choices, std::vector<std::string>{"Mouse"});
}

/// The dock in the window, with the device that is simulated.
class SimulatedDeviceTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
  }
  void open_cubes_free() {
    folder.write("free.sonde.json",
                 R"({"probe": {"mesh": "cube.off", "pose": [0.2, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off"}})");
    open({path("free.sonde.json")});
  }
  void choose(const QString& name) {
    auto* list = window->findChild<QComboBox*>("holder");
    ASSERT_TRUE(wait_until([&] { return list->findText(name) >= 0; })) << name.toStdString();
    emit list->activated(list->findText(name));
  }
  Vec3 probe() const { return shown().separation.device.p; }
};

TEST_F(SimulatedDeviceTest, the_mouse_moves_the_hand_and_the_device_is_pushed_back) {
  choose("sigma.7 (simulated)");
  auto* status = window->findChild<QLabel*>("device_status");
  EXPECT_TRUE(wait_until([&] { return status->text() == "sigma.7 (simulated)"; }));
  // Overlapping by 10 mm, the wall of 500 N/m pushes the handle out against the hand's 300.
  const Vec3 wanted = window->session()->device_pose().p;
  ASSERT_TRUE(wait_until([&] { return probe().x() > wanted.x() + 0.003; })) << probe().x();
  EXPECT_EQ(window->session()->device_pose().p, wanted) << "the mouse has not moved";
  // Away from the wall, the probe comes to where the mouse wants it, but for the friction.
  Pose free = window->session()->device_pose();
  free.p.x() += 0.1;
  window->set_device_pose(free);
  EXPECT_TRUE(wait_until([&] { return (probe() - free.p).norm() < 0.003; }));
  Vec3 before = Vec3::Zero();
  ASSERT_TRUE(wait_until([&] {
    wait(50);
    return std::exchange(before, probe()) == probe();
  })) << "friction holds it";
  choose("Mouse");
  const Vec3 here = probe();
  wait(50);
  EXPECT_EQ(probe(), here) << "taken over where it was";
}

TEST_F(SimulatedDeviceTest, settings_are_kept_for_each_device) {
  choose("sigma.7 (simulated)");
  window->findChild<TypedValue*>("scaling_value")->setValue(2.5);
  EXPECT_EQ(window->devices().settings().scaling, 2.5);
  const auto file = folder / "sonde/devices/sigma.7.json";
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(file); }));
  EXPECT_EQ(read_device_settings(file).scaling, 2.5);
  choose("omega.7 (simulated)");
  EXPECT_EQ(window->devices().settings().scaling, 1);
  choose("sigma.7 (simulated)");
  EXPECT_EQ(window->devices().settings().scaling, 2.5);
  // Another window, and one that finds a file it cannot read.
  window = std::make_unique<MainWindow>();
  choose("sigma.7 (simulated)");
  EXPECT_EQ(window->devices().settings().scaling, 2.5);
  std::filesystem::remove(file);
  folder.write("sonde/devices/sigma.7.json", "{\"scalin\": 1}");
  QString complaint;
  window->prompts().report_error = [&](const QString& text) { complaint = text; };
  choose("Mouse");
  choose("sigma.7 (simulated)");
  EXPECT_TRUE(complaint.contains("\"scalin\"")) << complaint.toStdString();
  EXPECT_EQ(window->devices().settings().scaling, 1);
  // The next change does not overwrite it.
  window->findChild<TypedValue*>("scaling_value")->setValue(2);
  const auto aside = folder / "sonde/devices/sigma.7.json.bad";
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(aside); }));
  EXPECT_EQ(read_device_settings(file).scaling, 2);
}

TEST_F(SimulatedDeviceTest, a_scene_names_its_device_and_a_choice_stays) {
  folder.write("own.sonde.json", R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off"}, "device": {"profile": "omega.7", "scaling": 4}})");
  open({path("own.sonde.json")});
  EXPECT_EQ(name_of(window->devices().source()), "omega.7 (simulated)");
  EXPECT_EQ(window->devices().settings().scaling, 4);
  open_cubes();
  EXPECT_EQ(name_of(window->devices().source()), "Mouse") << "this scene names none";
  choose("sigma.7 (simulated)");
  open({path("own.sonde.json")});
  EXPECT_EQ(name_of(window->devices().source()), "sigma.7 (simulated)");
  folder.write("bad.sonde.json", R"({"probe": {"mesh": "cube.off"}, "fixed": {"mesh": "cube.off"},
      "device": "omega7"})");
  open({path("bad.sonde.json")});
  EXPECT_TRUE(complaints.back().contains("omega.7")) << complaints.back().toStdString();
}

TEST_F(SimulatedDeviceTest, what_a_scene_sets_never_reaches_the_file_of_the_device) {
  choose("omega.7 (simulated)");
  window->findChild<TypedValue*>("scaling_value")->setValue(3);
  const auto file = folder / "sonde/devices/omega.7.json";
  auto* note = window->findChild<QLabel*>("settings_from_scene");
  EXPECT_TRUE(note->isHidden());
  folder.write("own.sonde.json", R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off"}, "device": {"profile": "omega.7", "scaling": 4}})");
  open({path("own.sonde.json")});
  EXPECT_EQ(read_device_settings(file).scaling, 3) << "kept before the scene came";
  EXPECT_EQ(window->devices().settings().scaling, 4);
  EXPECT_FALSE(note->isHidden());
  window->findChild<TypedValue*>("scaling_value")->setValue(5);
  EXPECT_EQ(window->devices().settings().scaling, 5) << "holds while the scene is open";
  open_cubes();
  EXPECT_EQ(window->devices().settings().scaling, 3);
  EXPECT_TRUE(note->isHidden());
  open({path("own.sonde.json")});
  window->findChild<TypedValue*>("scaling_value")->setValue(6);
  window.reset();  // keeps whatever is still to be kept
  EXPECT_EQ(read_device_settings(file).scaling, 3);
}

TEST_F(SimulatedDeviceTest, the_loop_runs_as_the_device_wants_and_else_as_the_scene_says) {
  const auto passive = [this] { return window->session()->loaded().servo.passivity.control; };
  const auto rate = [this] { return window->session()->loaded().servo.rate_hz; };
  auto* box = window->findChild<QCheckBox*>("passivity_control");
  choose("sigma.7 (simulated)");
  EXPECT_TRUE(passive());
  EXPECT_EQ(rate(), 1000);
  box->click();
  window->findChild<TypedValue*>("rate_hz_value")->setValue(2000);
  EXPECT_FALSE(passive());
  EXPECT_EQ(rate(), 2000);
  choose("omega.7 (simulated)");
  EXPECT_TRUE(passive());
  EXPECT_TRUE(box->isChecked());
  EXPECT_EQ(rate(), 1000);
  folder.write("own.sonde.json", R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off"}, "servo": {"rate_hz": 700, "passivity_control": 0}})");
  open({path("own.sonde.json")});
  EXPECT_FALSE(passive()) << "this device wants nothing";
  EXPECT_FALSE(box->isChecked());
  EXPECT_EQ(rate(), 700);
  choose("sigma.7 (simulated)");
  EXPECT_EQ(rate(), 2000);
  box->click();
  window = std::make_unique<MainWindow>();
  QObject::connect(window.get(), &MainWindow::opened, [this] { ++opened; });
  open({path("own.sonde.json")});
  choose("sigma.7 (simulated)");
  EXPECT_TRUE(passive()) << "kept for the device, and before the scene's";
  EXPECT_EQ(rate(), 2000);
}

TEST_F(SimulatedDeviceTest, an_energy_that_rounds_to_nothing_has_no_sign) {
  DevicePanel panel;
  panel.show_energy({.given = -1e-6, .excess = -0.0, .dissipated = -2e-3});
  const auto text = [&](const char* name) { return panel.findChild<QLabel*>(name)->text(); };
  EXPECT_EQ(text("energy_given"), "0.0 mJ");
  EXPECT_EQ(text("energy_excess"), "0.0 mJ");
  EXPECT_EQ(text("energy_dissipated"), "-2.0 mJ");
}

TEST_F(SimulatedDeviceTest, the_energy_is_on_show_whether_the_controller_is_on_or_not) {
  auto* given = window->findChild<QLabel*>("energy_given");
  EXPECT_TRUE(wait_until([&] { return given->text().endsWith(" mJ"); }));
  window->devices().choose(window->devices().choices()[0]);  // the mouse, which is in contact
  Pose deeper = window->session()->device_pose();
  const auto press = [&] {  // on and on, since the force comes in from zero
    deeper.p.x() -= 1e-4;
    window->set_device_pose(deeper);
    return given->text().startsWith("-");
  };
  EXPECT_TRUE(wait_until(press)) << "the hand gave it: " << given->text().toStdString();
}

TEST_F(SimulatedDeviceTest, a_path_from_a_file_is_played_in_any_scene) {
  const auto file =
      folder.write("way.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.3,0,0,1,0,0,0\n0.2,0.4,0,0,1,0,0,0\n");
  window->devices().choose(find_source(file.string(), {}));
  auto* list = window->findChild<QComboBox*>("holder");
  EXPECT_EQ(list->currentText(), "way.csv (recorded path)");
  EXPECT_TRUE(wait_until([&] { return probe().x() == 0.4; }));
  open_cubes_free();
  EXPECT_EQ(name_of(window->devices().source()), "way.csv (recorded path)") << "it stays";
  EXPECT_TRUE(wait_until([&] { return probe().x() == 0.4; }));
}

TEST_F(SimulatedDeviceTest, a_path_is_chosen_from_a_file_in_the_dock) {
  auto* list = window->findChild<QComboBox*>("holder");
  QString file;
  window->prompts().ask_path = [&] { return file; };
  const auto ask = [&](const std::string& name) {
    file = QString::fromStdString(name);
    emit list->activated(list->count() - 1);
  };
  ask("");
  EXPECT_EQ(list->currentText(), "Mouse") << "given up";
  ask(folder.write("bad.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.3,0,0,1,0,0\n").string());
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("bad.csv:2")) << complaints[0].toStdString();
  EXPECT_EQ(list->currentText(), "Mouse");
  ask(folder.write("way.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.3,0,0,1,0,0,0\n").string());
  EXPECT_EQ(list->currentText(), "way.csv (recorded path)");
  EXPECT_TRUE(wait_until([&] { return probe().x() == 0.3; }));
}

TEST_F(SimulatedDeviceTest, a_recorded_path_is_played) {
  folder.write("path.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.3,0,0,1,0,0,0\n0.2,0.4,0,0,1,0,0,0\n");
  folder.write("path.sonde.json",
               R"({"probe": {"mesh": "cube.off", "pose": [0.2, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off"}, "trajectory": "path.csv"})");
  open({path("path.sonde.json")});
  choose("Recorded path");
  EXPECT_TRUE(wait_until([&] { return probe().x() == 0.4; }));
  window->reset();
  EXPECT_TRUE(wait_until([&] { return window->shown() && probe().x() < 0.35; })) << "again";
  EXPECT_TRUE(wait_until([&] { return probe().x() == 0.4; }));
}

/// The window's dock. A firm hand comes nearer to where the mouse wants the probe, against the same
/// wall, and so gets more force.
TEST_F(DevicePanelTest, the_hand_on_a_simulated_device_has_grips_with_names_and_sliders) {
  open_cubes();
  window->show_device_dock();
  auto& dock = *window->findChild<QDockWidget*>("device_panel");
  auto* box = dock.findChild<QWidget*>("grip_box");
  EXPECT_FALSE(box->isVisible()) << "the mouse alone has no hand on a device";
  auto* sources = dock.findChild<QComboBox*>("holder");
  emit sources->activated(sources->findText("sigma.7 (simulated)"));
  ASSERT_TRUE(wait_until([&] { return box->isVisible(); }));
  const auto button = [&](const char* name) { return dock.findChild<QPushButton*>(name); };
  EXPECT_TRUE(button("grip_usual")->isChecked());
  const auto settled_force = [&] {
    wait(1500);
    return shown().wrench.force.norm();
  };
  button("grip_light")->click();
  EXPECT_EQ(dock.findChild<TypedValue*>("hand_stiffness_value")->value(), 200);
  EXPECT_FALSE(button("grip_usual")->isChecked());
  const double light = settled_force();
  button("grip_firm")->click();
  EXPECT_EQ(dock.findChild<TypedValue*>("hand_damping_value")->value(), 10);
  // In series with k = 500 N/m: 143 and 333 N per metre; friction, 0.4 N, may hold either back.
  EXPECT_GT(settled_force(), light + 0.3);
  auto* mass = dock.findChild<QSlider*>("hand_mass_slider");
  mass->setValue(mass->maximum() / 2);
  EXPECT_EQ(window->devices().grip().mass, 1);
  EXPECT_FALSE(button("grip_firm")->isChecked()) << "it has no name any more";
  EXPECT_EQ(chosen_grip(), window->devices().grip()) << "kept for the next time";
}

/// A dock is 272 pixels wide at first, of which its scroll bar takes some.
TEST_F(DevicePanelTest, a_long_name_does_not_make_the_dock_wider_than_a_small_screen_has) {
  SimulatedSource sigma;
  sigma.profile = find_device_profile("sigma.7", device_profile_folders());
  panel->show_choices({MouseSource{}, sigma}, sigma);
  panel->show_settings(sigma, {});
  panel->show_report(sigma, {});
  const QWidget* content = find<QComboBox>("holder")->parentWidget();
  EXPECT_LE(content->minimumSizeHint().width(), 256);
}

}  // namespace
}  // namespace sonde::ui::test
