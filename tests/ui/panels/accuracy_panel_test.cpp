// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/accuracy_panel.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QRadioButton>
#include <limits>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

class AccuracyPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<AccuracyPanel>();
  }
  template <class T>
  T* find(const char* name) const {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  std::string text(const char* name) const { return find<QLabel>(name)->text().toStdString(); }
  bool shows(const char* name) const { return find<QWidget>(name)->isVisibleTo(panel.get()); }

  std::unique_ptr<AccuracyPanel> panel;
};

TEST_F(AccuracyPanelTest, only_what_is_given_has_a_slider) {
  ServoSettings servo;
  servo.budget.microseconds = 300;
  panel->show_knob(servo, {});
  EXPECT_TRUE(find<QRadioButton>("knob_time")->isChecked());
  EXPECT_TRUE(shows("tick_time_row"));
  EXPECT_FALSE(shows("tick_accuracy_row"));
  EXPECT_EQ(find<TypedValue>("tick_time_value")->value(), 300);
  servo.accuracy = 0.02;  // the time follows from it
  panel->show_knob(servo, {});
  EXPECT_TRUE(find<QRadioButton>("knob_accuracy")->isChecked());
  EXPECT_FALSE(shows("tick_time_row"));
  EXPECT_EQ(find<TypedValue>("tick_accuracy_value")->value(), 2) << "%";
  servo.accuracy = servo.budget.microseconds = 0;
  panel->show_knob(servo, {});
  EXPECT_TRUE(find<QRadioButton>("knob_none")->isChecked());
  EXPECT_FALSE(shows("tick_time_row") || shows("tick_accuracy_row"));
}

TEST_F(AccuracyPanelTest, what_the_user_gives_is_told_as_a_share_and_in_microseconds) {
  std::vector<double> times, shares, sures;
  std::vector<AccuracyPanel::Knob> kinds;
  QObject::connect(panel.get(), &AccuracyPanel::time_changed,
                   [&](double us) { times.push_back(us); });
  QObject::connect(panel.get(), &AccuracyPanel::accuracy_changed,
                   [&](double share) { shares.push_back(share); });
  QObject::connect(panel.get(), &AccuracyPanel::sure_changed,
                   [&](double share) { sures.push_back(share); });
  QObject::connect(panel.get(), &AccuracyPanel::kind_chosen,
                   [&](AccuracyPanel::Knob kind) { kinds.push_back(kind); });
  find<TypedValue>("tick_time_value")->setValue(125);
  find<TypedValue>("tick_accuracy_value")->setValue(5);
  find<QRadioButton>("knob_accuracy")->click();
  find<QRadioButton>("knob_none")->click();
  auto* sure = find<QComboBox>("search_sure");
  EXPECT_EQ(sure->currentText(), "90 %");
  emit sure->activated(sure->currentIndex());
  EXPECT_EQ(times, std::vector<double>{125});
  EXPECT_EQ(shares, std::vector<double>{0.05});
  EXPECT_EQ(sures, std::vector<double>{0.9});
  EXPECT_EQ(kinds, (std::vector{AccuracyPanel::Knob::accuracy, AccuracyPanel::Knob::none}));
}

TEST_F(AccuracyPanelTest, the_expected_accuracy_says_of_which_time_and_why_it_is_not_known) {
  panel->show_knob({}, {.time_us = 250, .within = 0.012, .here = 0.03});
  EXPECT_EQ(text("expected_accuracy"), "within 1.20 % in 250 µs");
  EXPECT_EQ(text("expected_here"), "within 3.00 %");
  panel->show_knob({},
                   {.time_us = 250, .within = std::numeric_limits<double>::infinity(), .here = {}});
  EXPECT_EQ(text("expected_accuracy"), "not measured in 250 µs");
  EXPECT_EQ(text("expected_here"), "not measured");
  panel->show_knob({}, {.here = 0.03, .no_here = "line 3: no number"});
  EXPECT_EQ(text("expected_accuracy"), "no limit of time");
  EXPECT_EQ(text("expected_here"), "cannot be read");
  EXPECT_EQ(find<QLabel>("expected_here")->toolTip(), "line 3: no number");
}

TEST_F(AccuracyPanelTest, what_was_reached_is_there_with_its_phases_until_there_is_none) {
  Reached reached{.within = 0.004, .rows_us = 90, .tick_us = 12, .converged = 0.975, .phases = {}};
  reached.phases[Phase::look] = 30;
  reached.phases[Phase::couple] = 10;
  panel->show_reached(reached);
  EXPECT_EQ(text("reached_accuracy"), "within 0.400 %");
  EXPECT_EQ(text("converged_share"), "97.5 %");
  EXPECT_EQ(text("rows_time"), "90.0 µs");
  EXPECT_EQ(text("tick_time_used"), "12.0 µs");
  EXPECT_TRUE(find<QLabel>("phases")->text().contains("look&nbsp;30.0&nbsp;µs")) << text("phases");
  EXPECT_TRUE(find<QLabel>("phases")->text().contains("couple&nbsp;10.0&nbsp;µs"));
  panel->show_reached({});
  for (const char* name : {"reached_accuracy", "converged_share", "rows_time", "tick_time_used"})
    EXPECT_EQ(text(name), "–") << name;
  EXPECT_EQ(text("phases"), "");
}

TEST_F(AccuracyPanelTest, a_claim_says_what_it_rests_on) {
  panel->show_claim(Claim{Claim::By::certified, 0.015}, 0.9);
  EXPECT_EQ(text("search_claim"), "within 1.50 %, certified");
  panel->show_claim(Claim{Claim::By::expected, 0.015}, 0.99);
  EXPECT_EQ(text("search_claim"), "within 1.50 %, 99 in 100");
  panel->show_claim(Claim{}, 0.9);
  EXPECT_EQ(text("search_claim"), "not measured");
  panel->show_claim({}, 0.9);
  EXPECT_EQ(text("search_claim"), "–");
  PhaseTimes phases;
  phases[Phase::verify] = 400;
  panel->show_search(phases, 1500);
  EXPECT_EQ(text("search_time"), "1500 µs");
  EXPECT_TRUE(find<QLabel>("search_phases")->text().contains("verify&nbsp;400&nbsp;µs"));
  panel->show_search({}, 1500);
  EXPECT_EQ(text("search_time"), "–") << "it was not timed";
}

}  // namespace
}  // namespace sonde::ui::test
