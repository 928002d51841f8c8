// SPDX-License-Identifier: GPL-3.0-or-later
// Without a device that is connected: devices/connected_device_test.cpp has those.
#include "ui/devices/device_control.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/study/identification/measured_hand.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/resources.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui::test {
namespace {

class DeviceControlTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(home.path().string()));
    std::filesystem::create_directory(home / "profiles");
    for (const char* id : {"sigma.7", "omega.7"})
      std::filesystem::copy_file(bundled() / (std::string(id) + ".json"),
                                 home / "profiles" / (std::string(id) + ".json"));
    make_control();
  }
  void TearDown() override {
    control.reset();
    session.reset();
  }
  static std::filesystem::path bundled() { return device_profile_folders()[1]; }
  void make_control() {
    control.reset();
    const std::vector<std::filesystem::path> folders{home / "profiles"};
    control = std::make_unique<DeviceControl>(home / "settings", folders);
    QObject::connect(control.get(), &DeviceControl::failed,
                     [this](const QString& reason) { complaints << reason; });
    QObject::connect(control.get(), &DeviceControl::changed, [this] { ++changed; });
  }
  DeviceProfile profile(const char* id) const {
    const std::vector<std::filesystem::path> folders{home / "profiles"};
    return find_device_profile(id, folders);
  }
  static LoadedScene cubes() {
    const auto cube = [] { return sonde::test::body(sonde::test::box({0.1, 0.1, 0.1})); };
    LoadedScene loaded{.pair = Pair(cube(), cube())};
    loaded.start.p = Vec3(0.3, 0, 0);
    loaded.servo.real_time = false;
    return loaded;
  }
  void open(LoadedScene loaded) {
    control->attach(nullptr);
    session = std::make_unique<Session>(std::move(loaded));
    control->attach(session.get());
  }
  bool simulates(const char* id) const {
    const auto* source = std::get_if<SimulatedSource>(&control->source());
    return source && source->profile.id == id;
  }
  bool is_mouse() const { return std::holds_alternative<MouseSource>(control->source()); }
  std::vector<std::string> names() const { return labels_of(control->choices()); }
  void scale(double by) {
    DeviceSettings settings = control->settings();
    settings.scaling = by;
    control->set_settings(settings);
  }

  sonde::test::TempFolder home;
  std::unique_ptr<Session> session;
  std::unique_ptr<DeviceControl> control;
  QStringList complaints;
  int changed = 0;
};

TEST_F(DeviceControlTest, before_a_choice_the_scenes_device_or_the_mouse_holds_the_probe) {
  open(cubes());
  EXPECT_TRUE(is_mouse());
  EXPECT_TRUE(control->mouse_leads());
  LoadedScene with_device = cubes();
  with_device.device = profile("omega.7");
  open(with_device);
  EXPECT_TRUE(simulates("omega.7"));
  EXPECT_TRUE(control->mouse_leads()) << "the mouse moves the hand on it";
  open(cubes());
  EXPECT_TRUE(is_mouse());
}

TEST_F(DeviceControlTest, a_choice_is_for_every_scene) {
  control->choose(SimulatedSource{profile("sigma.7")});
  LoadedScene with_device = cubes();
  with_device.device = profile("omega.7");
  open(with_device);
  EXPECT_TRUE(simulates("sigma.7"));
  control->choose(MouseSource{});
  open(with_device);
  EXPECT_TRUE(is_mouse());
}

TEST_F(DeviceControlTest, the_path_of_a_scene_that_has_none_leaves_the_mouse_and_says_so) {
  LoadedScene with_path = cubes();
  with_path.trajectory = {{0, with_path.start}, {1, with_path.start}};
  open(with_path);
  control->choose(PathSource{});
  EXPECT_FALSE(control->mouse_leads());
  EXPECT_TRUE(complaints.isEmpty());
  open(cubes());
  EXPECT_TRUE(is_mouse());
  ASSERT_EQ(complaints.size(), 1);
  EXPECT_TRUE(complaints[0].contains("no recorded path")) << complaints[0].toStdString();
}

TEST_F(DeviceControlTest, settings_are_kept_for_each_device) {
  control->choose(SimulatedSource{profile("sigma.7")});
  scale(3);
  control->choose(SimulatedSource{profile("omega.7")});
  EXPECT_EQ(control->settings().scaling, 1);
  control->choose(SimulatedSource{profile("sigma.7")});
  EXPECT_EQ(control->settings().scaling, 3);
  scale(4);
  make_control();  // the end keeps what was not kept yet
  control->choose(SimulatedSource{profile("sigma.7")});
  EXPECT_EQ(control->settings().scaling, 4);
  EXPECT_TRUE(complaints.isEmpty());
}

TEST_F(DeviceControlTest, settings_of_a_scene_come_before_those_kept_and_are_not_kept) {
  control->choose(SimulatedSource{profile("sigma.7")});
  scale(3);
  LoadedScene with_settings = cubes();
  with_settings.device_settings.emplace().scaling = 0.5;
  open(with_settings);
  EXPECT_TRUE(control->settings_from_scene());
  EXPECT_EQ(control->settings().scaling, 0.5);
  scale(7);
  EXPECT_EQ(control->settings().scaling, 7);
  open(cubes());
  EXPECT_FALSE(control->settings_from_scene());
  EXPECT_EQ(control->settings().scaling, 3);
}

TEST_F(DeviceControlTest, a_file_of_settings_with_a_slip_is_named_and_put_aside) {
  const SimulatedSource source{profile("sigma.7")};
  const std::filesystem::path file = home / "settings" / settings_name_of(source);
  std::filesystem::create_directories(home / "settings");
  home.write("settings/" + settings_name_of(source), "{\"scaling\": ");
  control->choose(source);
  ASSERT_EQ(complaints.size(), 1);
  EXPECT_TRUE(complaints[0].startsWith(QString::fromStdString(file.string())))
      << complaints[0].toStdString();
  EXPECT_EQ(control->settings().scaling, usual_settings(source).scaling);
  scale(2);
  make_control();
  EXPECT_EQ(sonde::test::text_of(file.string() + ".bad"), "{\"scaling\": ")
      << "nobody's work is lost";
  control->choose(source);
  EXPECT_EQ(control->settings().scaling, 2);
}

TEST_F(DeviceControlTest, settings_that_cannot_be_kept_are_a_complaint_once) {
  home.write("settings", "no folder");
  for (const double by : {2.0, 3.0}) {
    control->choose(SimulatedSource{profile("sigma.7")});
    scale(by);
    control->choose(MouseSource{});
  }
  EXPECT_EQ(complaints.size(), 1) << complaints.join('\n').toStdString();
}

TEST_F(DeviceControlTest, everything_that_could_hold_the_probe_can_be_chosen) {
  const std::vector<std::string> without = names();
  ASSERT_GE(without.size(), 3u);
  EXPECT_EQ(without[0], name_of(MouseSource{}));
  EXPECT_EQ(std::ranges::count(without, name_of(SimulatedSource{profile("sigma.7")})), 1);
  EXPECT_EQ(std::ranges::count(without, name_of(SimulatedSource{profile("omega.7")})), 1);
  LoadedScene with_path = cubes();
  with_path.trajectory = {{0, with_path.start}, {1, with_path.start}};
  open(with_path);
  EXPECT_EQ(names().size(), without.size() + 1);
  EXPECT_EQ(names()[1], name_of(PathSource{}));
}

TEST_F(DeviceControlTest, a_profile_that_cannot_be_read_is_left_out_and_one_can_be_added) {
  home.write("profiles/broken.json", "{");
  make_control();
  const std::size_t before = names().size();
  EXPECT_EQ(std::ranges::count_if(
                names(), [](const std::string& name) { return name.starts_with("broken"); }),
            0);
  DeviceProfile own = profile("sigma.7");
  own.id = "own";
  control->add_profile(own);
  EXPECT_EQ(names().size(), before + 1);
  own.mass.value *= 2;
  control->add_profile(own);
  EXPECT_EQ(names().size(), before + 1) << "it takes the place of that with its id";
}

TEST_F(DeviceControlTest, the_loop_runs_as_the_device_wants_and_else_as_the_scene) {
  LoadedScene scene = cubes();
  scene.servo.rate_hz = 800;
  scene.servo.passivity.control = false;
  open(scene);
  EXPECT_EQ(control->servo().rate_hz, 800);
  DeviceSettings settings = control->settings();
  settings.rate_hz = 2000;
  settings.passivity_control = true;
  control->set_settings(settings);
  EXPECT_EQ(control->servo().rate_hz, 2000);
  EXPECT_TRUE(control->servo().passivity.control);
  settings.rate_hz.reset();
  control->set_settings(settings);
  EXPECT_EQ(control->servo().rate_hz, 800);
}

TEST_F(DeviceControlTest, a_simulated_device_is_measured_until_another_choice) {
  const PulsePlan plan = plan_pulses(profile("sigma.7"), {}, 1e-3);
  const PulseBounds bounds = bounds_of(plan, {});
  EXPECT_FALSE(control->begin_measuring(plan, bounds)) << "nothing is open";
  open(cubes());
  EXPECT_FALSE(control->begin_measuring(plan, bounds)) << "the mouse is none to measure";
  EXPECT_FALSE(control->report().measurable);
  control->choose(SimulatedSource{profile("sigma.7")});
  EXPECT_TRUE(control->report().measurable);
  EXPECT_TRUE(control->begin_measuring(plan, bounds));
  EXPECT_TRUE(control->measuring());
  control->end_measuring();
  EXPECT_FALSE(control->measuring());
  EXPECT_TRUE(control->begin_measuring(plan, bounds));
  control->choose(MouseSource{});
  EXPECT_FALSE(control->measuring());
  const int before = changed;
  control->end_measuring();
  EXPECT_EQ(changed, before) << "there is nothing to end";
}

}  // namespace
}  // namespace sonde::ui::test
