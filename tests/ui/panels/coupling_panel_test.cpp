// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/coupling_panel.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QTest>
#include <QUndoStack>

#include "engine/settings/settings.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

/// The dock alone.
class CouplingPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<CouplingPanel>(undo);
    QObject::connect(panel.get(), &CouplingPanel::changed,
                     [this](const Coupling& coupling) { told.push_back(coupling); });
  }
  template <class T>
  T* find(const std::string& name) const {
    T* found = panel->findChild<T*>(QString::fromStdString(name));
    EXPECT_TRUE(found) << name;
    return found;
  }
  bool shows(const char* name) const { return find<QWidget>(name)->isVisibleTo(panel.get()); }

  QUndoStack undo;
  std::unique_ptr<CouplingPanel> panel;
  std::vector<Coupling> told;
};

TEST_F(CouplingPanelTest, every_gain_has_a_slider_and_a_typed_value) {
  for (const Setting& setting : coupling_settings()) {
    EXPECT_TRUE(find<QSlider>(std::string(setting.key) + "_slider"));
    EXPECT_TRUE(find<TypedValue>(std::string(setting.key) + "_value"));
  }
}

TEST_F(CouplingPanelTest, the_mode_shows_its_own_gains) {
  EXPECT_TRUE(shows("k_row"));
  EXPECT_FALSE(shows("b_t_row"));
  find<QRadioButton>("mode_classic")->click();
  EXPECT_EQ(told.back().mode, Coupling::Mode::classic);
  EXPECT_FALSE(shows("k_row"));
  EXPECT_TRUE(shows("b_t_row") && shows("k_r_row"));
  EXPECT_TRUE(shows("max_force_row")) << "of every mode";
}

TEST_F(CouplingPanelTest, what_is_felt_is_told_apart_from_what_waits) {
  EXPECT_FALSE(shows("gains_waiting"));
  GainGlide::Blend felt;
  felt.now.k = 345;
  panel->show_rendered(felt);
  EXPECT_TRUE(shows("gains_waiting"));
  EXPECT_TRUE(find<QLabel>("gains_waiting")->text().contains("Felt now: k 345 N/m"));
  felt.before = felt.now;
  felt.now.mode = Coupling::Mode::classic;
  felt.share = 0.25;  // of a change of mode that is held
  panel->show_rendered(felt);
  EXPECT_TRUE(find<QLabel>("gains_waiting")
                  ->text()
                  .contains("Felt now: 75.0 % of k 345 N/m, and 25.0 % of k_t 500 N/m"))
      << find<QLabel>("gains_waiting")->text().toStdString();
  panel->show_rendered({});
  EXPECT_FALSE(shows("gains_waiting"));
}

TEST_F(CouplingPanelTest, gains_of_a_newly_opened_pair_are_shown_and_are_no_change) {
  Coupling opened;
  opened.k = 1200;
  opened.max_force = 7;
  panel->take(opened);
  panel->show_origin([](const Coupling& now) {
    return now.k == 40 ? QStringLiteral("changed") : QStringLiteral("from the scene");
  });
  EXPECT_EQ(find<TypedValue>("k_value")->value(), 1200);
  EXPECT_EQ(find<TypedValue>("max_force_value")->value(), 7);
  EXPECT_EQ(find<QLabel>("gains_origin")->text(), "from the scene");
  EXPECT_TRUE(told.empty());
  EXPECT_FALSE(undo.canUndo());
  find<TypedValue>("k_value")->setValue(40);
  EXPECT_EQ(find<QLabel>("gains_origin")->text(), "changed") << "of the gains that are set";
}

TEST_F(CouplingPanelTest, gains_as_opened_come_back_and_each_change_can_be_undone) {
  Coupling opened;
  opened.k = 1200;
  panel->take(opened);
  find<TypedValue>("k_value")->setValue(300);
  find<TypedValue>("max_force_value")->setValue(4);
  find<QPushButton>("gains_as_opened")->click();
  EXPECT_EQ(panel->coupling().k, 1200);
  EXPECT_EQ(panel->coupling().max_force, opened.max_force);
  ASSERT_EQ(undo.count(), 3) << "changes of different settings are changes of their own";
  undo.undo();
  EXPECT_EQ(panel->coupling().k, 300);
  EXPECT_EQ(told.back().max_force, 4);
  undo.undo();
  EXPECT_EQ(panel->coupling().k, 300);
  EXPECT_EQ(panel->coupling().max_force, opened.max_force);
  undo.undo();
  EXPECT_EQ(find<TypedValue>("k_value")->value(), 1200);
}

TEST_F(CouplingPanelTest, the_gain_of_the_mouse_is_none_of_the_coupling) {
  double gain = 0;
  QObject::connect(panel.get(), &CouplingPanel::mouse_gain_changed,
                   [&](double value) { gain = value; });
  find<TypedValue>("mouse_gain_value")->setValue(0.5);
  EXPECT_EQ(gain, 0.5);
  EXPECT_TRUE(told.empty());
  EXPECT_FALSE(undo.canUndo());
}

/// The dock in the window, of two cubes that overlap.
class CouplingInWindow : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (!HasFatalFailure()) open_cubes();
  }
  double force() const { return shown().wrench.force.norm(); }
};

TEST_F(CouplingInWindow, a_slider_acts_on_the_force) {
  // The force comes in from zero.
  ASSERT_TRUE(wait_until([this] { return shown().hand.share >= 1; }));
  const double before = force(), k_before = window->session()->coupling().k;
  auto* slider = find<QSlider>("k_slider");
  slider->setValue(slider->value() - 80);
  const double ratio = window->session()->coupling().k / k_before;
  EXPECT_LT(ratio, 0.6);
  EXPECT_NEAR(find<TypedValue>("k_value")->value(), window->session()->coupling().k, 1e-6);
  EXPECT_TRUE(wait_until([&] {
    return std::abs(force() - ratio * before) < 0.02 * ratio * before;
  })) << force()
      << " N, not " << ratio * before;
}

TEST_F(CouplingInWindow, a_typed_value_acts_and_can_be_undone) {
  auto* typed = find<TypedValue>("k_value");
  typed->setFocus();
  typed->selectAll();
  QTest::keyClicks(typed, "250,5");  // a decimal comma is as good as a point
  EXPECT_EQ(window->session()->coupling().k, 500) << "half a number is no gain";
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(window->session()->coupling().k, 250.5);
  act("undo");
  EXPECT_EQ(window->session()->coupling().k, 500);
  EXPECT_EQ(typed->value(), 500);
  act("redo");
  EXPECT_DOUBLE_EQ(window->session()->coupling().k, 250.5);
}

}  // namespace
}  // namespace sonde::ui::test
