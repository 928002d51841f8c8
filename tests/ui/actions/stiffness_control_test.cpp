// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/stiffness_control.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "engine/study/stability/press_and_hold.hpp"
#include "tests/ui/canned_study.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/panels/map_plot.hpp"
#include "ui/panels/stiffness_panel.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

class StiffnessTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    write_canned_study(folder / "tuned", folder / "cube.off", folder / "cube.off");
    window->stiffness().panel().raise();
  }
  template <class T>
  T* find(const char* name) {
    T* found = window->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  StiffnessControl& stiffness() { return window->stiffness(); }
  /// Ends with the tuning read, or with a complaint.
  void load(const char* name) {
    const auto before = complaints.size();
    const auto* old = stiffness().tuning() ? &stiffness().tuning()->folder : nullptr;
    const std::string was = old ? old->string() : "";
    stiffness().load(path(name));
    ASSERT_TRUE(wait_until([&] {
      return complaints.size() > before ||
             (stiffness().tuning() && stiffness().tuning()->folder.string() != was);
    }));
  }
  double k() const { return window->session()->coupling().k; }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
};

TEST_F(StiffnessTest, the_point_on_the_map_moves_with_the_slider) {
  EXPECT_FALSE(find<MapPlot>("map_plot")->isVisible()) << "there is no map yet";
  load("tuned");
  auto* plot = find<MapPlot>("map_plot");
  ASSERT_TRUE(wait_until([&] { return plot->isVisible(); }));
  ASSERT_TRUE(plot->now());
  EXPECT_EQ(plot->now()->stiffness, 500);
  EXPECT_TRUE(text("map_place").contains("0.556 of the boundary, 900 N/m"))
      << text("map_place").toStdString();
  const double before = plot->place(*plot->now()).x();
  auto* slider = find<QSlider>("k_slider");
  slider->setValue(slider->value() + 150);
  EXPECT_EQ(plot->now()->stiffness, k());
  EXPECT_GT(plot->place(*plot->now()).x(), before + 20);
  EXPECT_TRUE(text("map_place").contains("unstable")) << k();
  EXPECT_EQ(plot->recommended()->stiffness, 600);
}

TEST_F(StiffnessTest, one_kind_of_contact_can_be_looked_at) {
  load("tuned");
  auto* kinds = find<QComboBox>("map_kind");
  EXPECT_EQ(find<MapPlot>("map_plot")->map().rows.size(), 2u);
  kinds->setCurrentIndex(kinds->findText("flat"));
  EXPECT_EQ(find<MapPlot>("map_plot")->map().rows.size(), 1u);
}

TEST_F(StiffnessTest, the_recommended_gains_act_at_once_and_can_be_undone) {
  load("tuned");
  EXPECT_TRUE(text("recommendation").contains("stability (edge contact, light hand)"));
  EXPECT_TRUE(text("recommendation").contains("mass 0.500 to 1.11 times"));
  const double force = 500 * shown().separation.depth;
  ASSERT_TRUE(wait_until([&] { return shown().wrench.force.norm() > 0.99 * force; }));
  find<QPushButton>("apply_recommended")->click();
  EXPECT_EQ(k(), 600);
  EXPECT_EQ(window->session()->coupling().max_force, 8) << "the limits it was studied with too";
  EXPECT_EQ(find<TypedValue>("k_value")->value(), 600);
  EXPECT_TRUE(wait_until([&] {
    return std::abs(shown().wrench.force.norm() - 1.2 * force) < 0.01 * force;
  })) << shown().wrench.force.norm();
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 500);
  EXPECT_EQ(window->session()->coupling().max_force, 10);
  find<QAction>("redo")->trigger();
  EXPECT_EQ(k(), 600);
}

TEST_F(StiffnessTest, two_sets_of_gains_by_button_and_by_key_while_in_contact) {
  auto* value = find<TypedValue>("k_value");
  find<QPushButton>("gains_b")->click();
  EXPECT_EQ(k(), 500) << "both begin as opened";
  EXPECT_TRUE(find<QPushButton>("gains_b")->isChecked());
  EXPECT_FALSE(find<QPushButton>("gains_a")->isChecked());
  value->setValue(800);
  EXPECT_TRUE(find<QPushButton>("gains_b")->text().contains("800"));
  EXPECT_TRUE(find<QPushButton>("gains_a")->text().contains("500"));
  QApplication::setActiveWindow(window.get());  // there is no window manager to do it
  QTest::keyClick(window->viewport().canvas(), Qt::Key_B);
  EXPECT_TRUE(find<QPushButton>("gains_a")->isChecked());
  EXPECT_EQ(k(), 500);
  EXPECT_EQ(shown().separation.status, Status::penetrating);
  find<QPushButton>("gains_a")->click();
  EXPECT_EQ(k(), 500) << "it is active already";
  EXPECT_TRUE(find<QPushButton>("gains_a")->isChecked());
  // Undone in the order it was done: the switch, the gain, the first switch.
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 800);
  EXPECT_EQ(stiffness().sets().active(), 1u);
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 500);
  find<QAction>("undo")->trigger();
  EXPECT_EQ(stiffness().sets().active(), 0u);
}

TEST_F(StiffnessTest, what_cannot_be_read_says_why_and_the_map_stays) {
  load("tuned");
  const auto tells = [&](const char* name, const QString& what) {
    load(name);
    ASSERT_FALSE(complaints.empty());
    EXPECT_TRUE(complaints.back().contains(what)) << complaints.back().toStdString();
    ASSERT_TRUE(stiffness().tuning());
    EXPECT_EQ(stiffness().tuning()->folder, folder / "tuned");
    EXPECT_EQ(find<MapPlot>("map_plot")->map().rows.size(), 2u);
  };
  std::filesystem::create_directory(folder / "empty");
  tells("empty", "study.json");
  tells("nowhere", "nowhere");
  folder.write("garbled/study.json", "{\"study\": \"tune\", \"about\"");
  tells("garbled", "study.json");
  write_canned_study(folder / "half", folder / "cube.off", folder / "cube.off");
  std::filesystem::remove(folder / "half/parts/edge1.100.json");
  tells("half", "edge1.100");
  write_canned_study(folder / "broken", folder / "cube.off", folder / "cube.off");
  folder.write("broken/parts/edge1.100.json", "{\"situation\": 7}");
  tells("broken", "broken");
}

TEST_F(StiffnessTest, a_map_of_another_scene_or_another_device_says_so) {
  write_canned_study(folder / "other", folder / "large.off", folder / "cube.off");
  load("other");
  EXPECT_TRUE(text("tuning_doubt").contains("another scene: its probe is large.off, not cube.off"))
      << text("tuning_doubt").toStdString();
  load("tuned");
  EXPECT_FALSE(find<QLabel>("tuning_doubt")->isVisible());
  auto* sources = find<QComboBox>("holder");
  emit sources->activated(sources->findText("omega.7 (simulated)"));
  EXPECT_TRUE(text("tuning_doubt").contains("another device: sigma.7, not omega.7"));
  EXPECT_EQ(find<QComboBox>("tuning_device")->currentText(), "omega.7");
}

TEST_F(StiffnessTest, another_scene_has_no_map) {
  load("tuned");
  open_cubes();
  EXPECT_FALSE(stiffness().tuning());
  EXPECT_FALSE(find<QPushButton>("apply_recommended")->isVisible());
}

TEST_F(StiffnessTest, beyond_the_boundary_the_simulated_device_buzzes_and_the_dock_shows_it) {
  auto* sources = find<QComboBox>("holder");
  emit sources->activated(sources->findText("sigma.7 (simulated)"));
  auto* typed = find<TypedValue>("k_value");
  const auto settled = [&] {
    wait(1500);  // a whole second without what came before
    EXPECT_TRUE(wait_until([&] { return stiffness().buzz().has_value(); }));
    return *stiffness().buzz();
  };
  typed->setValue(400);
  const Buzz quiet = settled();
  EXPECT_FALSE(text("chatter_value").contains("buzzing")) << quiet.chatter;
  EXPECT_EQ(shown().separation.status, Status::penetrating);
  EXPECT_GT(shown().wrench.force.norm(), 1) << "it is quiet in contact";
  // Damped with 2 N·s/m of its own and 5 of the hand, one sample late: without friction the end is
  // near 2 b/(T + 2 t_d) = 4.7 kN/m.
  typed->setValue(40'000);
  const Buzz loud = settled();
  EXPECT_GT(loud.chatter, chatter_limit);
  EXPECT_GT(loud.chatter, 10 * quiet.chatter);
  EXPECT_TRUE(wait_until([&] { return text("chatter_value").contains("buzzing"); }));
  EXPECT_TRUE(text("energy_value").endsWith("mJ"));
  typed->setValue(400);
  EXPECT_LT(settled().chatter, loud.chatter / 10) << "and is quiet again";
}

TEST_F(StiffnessTest, computing_writes_a_folder_and_shows_it_and_can_be_cancelled) {
  // All kinds of contact take long enough to be shown at work; one of them may not.
  auto* kinds = find<QComboBox>("tuning_kind");
  kinds->setCurrentIndex(kinds->findText("all contacts"));
  auto* devices = find<QComboBox>("tuning_device");
  devices->setCurrentIndex(devices->findText("sigma.7"));
  stiffness().compute(path("new"));
  QDialog* dialog = nullptr;
  ASSERT_TRUE(wait_until([&] {
    dialog = window->findChild<QDialog*>("progress_dialog");
    return dialog && dialog->isVisible();
  }));
  dialog->reject();
  wait(50);
  EXPECT_FALSE(stiffness().tuning());
  EXPECT_TRUE(complaints.empty());
  load("tuned");
  kinds->setCurrentIndex(kinds->findText("flat"));
  stiffness().compute(path("new"));
  ASSERT_TRUE(wait_until(
      [&] { return !complaints.empty() || stiffness().tuning()->folder == folder / "new"; }));
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  EXPECT_EQ(stiffness().tuning()->results.device_id, "sigma.7");
  EXPECT_TRUE(std::filesystem::exists(folder / "new/recommendation.json"));
  EXPECT_FALSE(find<QLabel>("tuning_doubt")->isVisible());
  EXPECT_GE(find<MapPlot>("map_plot")->map().rows.size(), 1u);
}

}  // namespace
}  // namespace sonde::ui::test
