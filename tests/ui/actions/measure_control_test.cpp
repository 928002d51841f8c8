// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the profile that the device is simulated from.
#include "ui/actions/measure_control.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <cstdlib>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/resources.hpp"

namespace sonde::ui::test {
namespace {

class Measuring : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    window->prompts().ask_profile = [this](const QString& first) {
      suggested = first;
      return file;
    };
    window->show_device_dock();
  }

  static DeviceProfile profile(const char* id) {
    return find_device_profile(id, device_profile_folders());
  }
  void hold_by(const DeviceProfile& device) { window->devices().choose(SimulatedSource{device}); }
  /// Where nothing touches the probe.
  void take_out() {
    Pose free = window->session()->device_pose();
    free.p += Vec3(0.2, 0, 0);
    window->set_device_pose(free);
    ASSERT_TRUE(wait_until([this] {
      return shown().separation.status == Status::separated &&
             (shown().separation.device.p - window->session()->device_pose().p).norm() < 0.01;
    })) << "but for its friction";
  }
  template <class T>
  T* find(const char* name) const {
    T* found = window->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  MeasureDialog* dialog() const {
    return static_cast<MeasureDialog*>(window->findChild<QDialog*>("measure_dialog"));
  }
  /// A whole measurement, with the fit after it: half a minute or so, many times that in a thread
  /// sanitizer.
  void wait_for_the_end() {
    const auto is_there = [this] {
      return find<QTableWidget>("measure_table")->isVisible() || !ended().isEmpty();
    };
    for (int i = 0; i < 20 && !is_there(); ++i) wait_until(is_there);
  }
  bool closed() const { return !dialog() || !dialog()->isVisible(); }
  QString ended() const {
    const auto* label = window->findChild<QLabel*>("measure_ended");
    return label && label->isVisible() ? label->text() : QString();
  }
  bool running() const { return window->devices().measuring(); }
  void ask() {
    auto* button = find<QPushButton>("measure_device");
    ASSERT_TRUE(wait_until([&] { return button->isEnabled(); }));
    button->click();
    ASSERT_TRUE(dialog());
  }
  void start() { find<QPushButton>("measure_start")->click(); }
  /// Asks, starts, and waits until it pushes.
  void begin() {
    hold_by(profile("sigma.7"));
    take_out();
    ask();
    start();
    ASSERT_TRUE(running()) << ended().toStdString();
    ASSERT_TRUE(wait_until([this] { return shown().wrench.force.norm() > 0.1; }));
  }
  void expect_over() {
    EXPECT_FALSE(running());
    EXPECT_TRUE(wait_until([this] { return shown().wrench.force.isZero(0); }));
    const std::uint64_t tick = shown().tick;
    ASSERT_TRUE(wait_until([&] {
      EXPECT_TRUE(shown().wrench.force.isZero(0) && shown().wrench.torque.isZero(0));
      return shown().tick > tick + 500;
    }));
  }
  void press_escape() {
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(dialog(), &press);
  }
  /// Pictures for the eye, where SONDE_TEST_PICTURES names a folder.
  void keep_picture(const char* name) const {
    const char* to = std::getenv("SONDE_TEST_PICTURES");
    if (to) dialog()->grab().save(QString::fromUtf8(to) + '/' + name + ".png");
  }

  QString file, suggested;  ///< the answer, and what it began with
};

TEST_F(Measuring, the_button_is_for_devices_with_a_handle) {
  auto* button = find<QPushButton>("measure_device");
  EXPECT_FALSE(button->isVisible()) << "the mouse is none";
  hold_by(profile("sigma.7"));
  EXPECT_TRUE(wait_until([&] { return button->isVisible() && button->isEnabled(); }));
}

TEST_F(Measuring, it_says_what_will_happen_before_anything_does) {
  hold_by(profile("sigma.7"));
  take_out();
  ask();
  keep_picture("measure_consent");
  const QString what = find<QLabel>("measure_what")->text();
  for (const char* words : {"sigma.7 (simulated)", "96 pulses", "2.00 N", "0.0500 N·m", " s.",
                            "Take your hand off the handle", "Esc", "10.0 mm"})
    EXPECT_TRUE(what.contains(QString::fromUtf8(words))) << words << "\n" << what.toStdString();
  auto* force = find<QDoubleSpinBox>("measure_force");
  force->setValue(0.7);
  EXPECT_TRUE(find<QLabel>("measure_what")->text().contains("0.700 N"));
  EXPECT_FALSE(running());
  dialog()->reject();
  EXPECT_TRUE(wait_until([this] { return closed(); }));
  EXPECT_FALSE(running());
}

TEST_F(Measuring, limits_beyond_those_of_the_device_are_refused) {
  hold_by(profile("sigma.7"));
  ask();
  auto* force = find<QDoubleSpinBox>("measure_force");
  auto* torque = find<QDoubleSpinBox>("measure_torque");
  force->setValue(1000);
  torque->setValue(5);
  EXPECT_EQ(force->value(), 6) << "half of 12 N";
  EXPECT_EQ(torque->value(), 0.1);
  force->setValue(-3);
  torque->setValue(0);
  EXPECT_GT(force->value(), 0);
  EXPECT_GT(torque->value(), 0);
  EXPECT_GT(dialog()->limits().force, 0);
}

TEST_F(Measuring, a_device_without_torque_is_asked_for_none) {
  hold_by(profile("touch-x"));
  ask();
  EXPECT_FALSE(find<QDoubleSpinBox>("measure_torque")->isVisible());
  const QString what = find<QLabel>("measure_what")->text();
  EXPECT_TRUE(what.contains("48 pulses")) << what.toStdString();
  EXPECT_FALSE(what.contains(QString::fromUtf8("N·m")));
}

TEST_F(Measuring, it_does_not_begin_in_contact_nor_without_force) {
  hold_by(profile("sigma.7"));
  ask();
  start();
  EXPECT_FALSE(running());
  EXPECT_TRUE(ended().contains("in contact")) << ended().toStdString();
  take_out();
  window->set_force(false);
  start();
  EXPECT_FALSE(running());
  EXPECT_TRUE(ended().contains("force is off")) << ended().toStdString();
  window->set_force(true);
  start();
  EXPECT_TRUE(running()) << "and then it does";
  EXPECT_EQ(ended(), QString());
}

TEST_F(Measuring, cancel_ends_the_force_and_the_mouse_moves_the_hand_again) {
  begin();
  find<QPushButton>("measure_cancel")->click();
  EXPECT_TRUE(ended().contains("cancelled")) << ended().toStdString();
  expect_over();
  dialog()->reject();
  Pose there = window->session()->device_pose();
  there.p.y() += 0.01;
  window->set_device_pose(there);
  EXPECT_TRUE(wait_until([&] { return (shown().separation.device.p - there.p).norm() < 1e-3; }));
}

TEST_F(Measuring, esc_ends_it_with_the_force_at_zero) {
  begin();
  press_escape();
  EXPECT_FALSE(window->session()->force_on());
  EXPECT_TRUE(ended().contains("switched off")) << ended().toStdString();
  expect_over();
}

TEST_F(Measuring, another_holder_ends_it) {
  begin();
  window->devices().choose(MouseSource{});
  EXPECT_TRUE(wait_until([this] { return ended().contains("something else holds"); }))
      << ended().toStdString();
  expect_over();
}

TEST_F(Measuring, a_window_that_closes_in_the_middle_ends_it) {
  begin();
  window.reset();
}

TEST_F(Measuring, what_cannot_be_told_is_refused_with_its_reason) {
  DeviceProfile stiff = profile("touch-x");
  stiff.friction.value = 50;  // it will not move
  take_out();                 // by the mouse itself
  hold_by(stiff);
  ask();
  find<QDoubleSpinBox>("measure_travel")->setValue(1);  // it is shorter so
  start();
  ASSERT_TRUE(wait_until([this] { return !running(); }));
  EXPECT_TRUE(wait_until([this] { return ended().contains("did not move"); }))
      << ended().toStdString();
}

TEST_F(Measuring, a_simulated_device_is_recovered_within_a_twentieth_saved_and_used) {
  const DeviceProfile truth = profile("sigma.7");
  begin();
  keep_picture("measure_progress");
  auto* table = find<QTableWidget>("measure_table");
  wait_for_the_end();
  ASSERT_TRUE(wait_until([&] { return table->isVisible(); })) << ended().toStdString();
  wait(100);
  keep_picture("measure_result");
  EXPECT_LE(table->horizontalHeader()->length(), table->viewport()->width()) << "all of it shows";
  ASSERT_EQ(table->rowCount(), 9);
  EXPECT_EQ(table->item(0, 0)->text(), "mass");
  EXPECT_NEAR(table->item(0, 1)->text().toDouble(), truth.mass.value, 0.05 * truth.mass.value);
  EXPECT_EQ(table->item(0, 3)->text(), "kg");
  EXPECT_EQ(table->item(0, 4)->text(), "0.3, assumed");

  auto* use = find<QPushButton>("measure_use");
  EXPECT_FALSE(use->isEnabled()) << "nothing is saved yet";
  find<QPushButton>("measure_save")->click();
  EXPECT_FALSE(use->isEnabled()) << "given up";
  EXPECT_TRUE(suggested.endsWith("sonde/devices/sigma.7-measured.json")) << suggested.toStdString();
  file = path("mine.json");
  find<QPushButton>("measure_save")->click();
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const DeviceProfile saved = read_device_profile(folder / "mine.json");
  for (const auto value :
       {&DeviceProfile::mass, &DeviceProfile::damping, &DeviceProfile::friction,
        &DeviceProfile::delay, &DeviceProfile::resolution, &DeviceProfile::inertia,
        &DeviceProfile::rotational_damping, &DeviceProfile::rotational_friction}) {
    const ProfileValue &found = saved.*value, &true_value = truth.*value;
    EXPECT_NEAR(found.value, true_value.value, 0.05 * true_value.value);
    EXPECT_FALSE(found.assumed);
    ASSERT_TRUE(found.interval);
    EXPECT_LE(found.interval->low, found.value);
    EXPECT_GE(found.interval->high, found.value);
    EXPECT_NE(found.origin.find("measured by Sonde on"), std::string::npos) << found.origin;
  }
  EXPECT_EQ(saved.max_force.value, truth.max_force.value);

  ASSERT_TRUE(use->isEnabled());
  use->click();
  EXPECT_TRUE(wait_until([this] { return closed(); }));
  EXPECT_EQ(name_of(window->devices().source()), "sigma.7, measured (simulated)");
  auto* holders = find<QComboBox>("holder");
  EXPECT_EQ(holders->currentText(), "sigma.7, measured (simulated)");
}

TEST_F(Measuring, a_profile_that_cannot_be_written_is_a_complaint) {
  hold_by(profile("touch-x"));
  take_out();
  ask();
  start();
  auto* table = find<QTableWidget>("measure_table");
  wait_for_the_end();
  ASSERT_TRUE(wait_until([&] { return table->isVisible(); })) << ended().toStdString();
  folder.write("file", "");
  file = path("file/below.json");
  find<QPushButton>("measure_save")->click();
  EXPECT_EQ(complaints.size(), 1U);
  EXPECT_FALSE(find<QPushButton>("measure_use")->isEnabled());
}

}  // namespace
}  // namespace sonde::ui::test
