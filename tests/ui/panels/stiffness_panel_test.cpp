// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/stiffness_panel.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>

#include "tests/engine/study/tuning/made_up_results.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/panels/study_box.hpp"

namespace sonde::ui::test {
namespace {

/// A flat contact is stable up to 1500 N/m and an edge up to 900, so 900/1.5 are recommended.
Tuning tuning_to_600() {
  Tuning out{.folder = "/studies/mine", .results = sonde::test::stable_up_to({1500, 900})};
  out.results.device_id = "omega.7";
  return out;
}

Coupling stiff(double k) {
  Coupling out;
  out.k = k;
  return out;
}

class StiffnessPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<StiffnessPanel>(std::vector<std::string>{"omega.7", "sigma.7"});
  }
  template <class T>
  T* find(const char* name) const {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  QString text(const char* name) const { return find<QLabel>(name)->text(); }
  bool shows(const char* name) const { return find<QWidget>(name)->isVisibleTo(panel.get()); }

  std::unique_ptr<StiffnessPanel> panel;
};

TEST_F(StiffnessPanelTest, the_recommended_gains_can_be_used_once_every_row_is_found) {
  int applied = 0;
  QObject::connect(panel.get(), &StiffnessPanel::apply_asked, [&] { ++applied; });
  EXPECT_FALSE(shows("map_axis") || shows("apply_recommended") || shows("recommendation"));
  EXPECT_TRUE(text("tuning_source").startsWith("There is no map yet"));
  Tuning tuning = tuning_to_600();
  tuning.rows = 2;
  tuning.of_rows = 5;
  panel->show_tuning(tuning);
  EXPECT_FALSE(shows("apply_recommended")) << "a row to come may limit";
  EXPECT_EQ(text("tuning_source"), "2 of 5 rows, for omega.7. Compute goes on from these.");
  tuning.rows = 5;
  panel->show_tuning(tuning);
  EXPECT_EQ(text("tuning_source"), "mine, for omega.7.");
  EXPECT_TRUE(text("recommendation").contains("k 600 N/m"));
  ASSERT_TRUE(shows("apply_recommended"));
  EXPECT_EQ(find<QPushButton>("apply_recommended")->text(), "Use recommended: k 600 N/m");
  find<QPushButton>("apply_recommended")->click();
  EXPECT_EQ(applied, 1);
  EXPECT_FALSE(find<QPushButton>("save_tuning")->isEnabled()) << "it is in a folder";
  tuning.computed = true;
  panel->show_tuning(tuning);
  EXPECT_TRUE(find<QPushButton>("save_tuning")->isEnabled());
}

TEST_F(StiffnessPanelTest, the_gains_and_the_contact_are_compared_with_what_is_recommended) {
  panel->show_tuning(tuning_to_600());
  panel->show_gains(stiff(450));
  EXPECT_TRUE(text("map_place").startsWith("By the study of omega.7, k = 450 N/m is "));
  EXPECT_TRUE(text("map_place").endsWith("could be 1.33 times as stiff."))
      << text("map_place").toStdString();
  panel->show_contact("flat");
  EXPECT_TRUE(text("map_place")
                  .endsWith("Contact now: flat, in it the study allows 600 N/m, limited by "
                            "stability (edge contact, light hand): could be 1.33 times as stiff."))
      << "never more than over all: " << text("map_place").toStdString();
  panel->show_contact("corner");
  EXPECT_TRUE(text("map_place").endsWith("Contact now: corner, which the study has not."));
  Coupling classic;
  classic.mode = Coupling::Mode::classic;
  panel->show_gains(classic);
  EXPECT_EQ(text("map_place"), "The map is of the object coupling, the sliders are not.");
}

TEST_F(StiffnessPanelTest, a_map_of_another_device_is_doubted) {
  panel->show_tuning(tuning_to_600());
  EXPECT_FALSE(shows("tuning_doubt"));
  panel->show_device("omega.7", "");
  EXPECT_FALSE(shows("tuning_doubt"));
  panel->show_device("sigma.7", "");
  ASSERT_TRUE(shows("tuning_doubt"));
  EXPECT_EQ(text("tuning_doubt"), "This map is of another device: omega.7, not sigma.7.");
  EXPECT_EQ(panel->device_id(), "sigma.7") << "the one to compute for";
  panel->show_device("", "Omega.7 left-handed");
  EXPECT_FALSE(shows("tuning_doubt")) << "it calls itself by that name";
  panel->show_device("", "Some arm", "sigma.7-measured");
  EXPECT_EQ(panel->device_id(), "sigma.7-measured") << "the model of what is connected";
  panel->findChild<StudyBox*>()->choose_device("omega.7");
  panel->show_device("", "Some arm", "sigma.7-measured");
  EXPECT_EQ(panel->device_id(), "omega.7") << "what the user has chosen since";
  EXPECT_TRUE(text("tuning_doubt").contains("Whether Some arm is one is not known"));
}

TEST_F(StiffnessPanelTest, of_two_sets_of_gains_one_is_pressed) {
  int switched = 0;
  QObject::connect(panel.get(), &StiffnessPanel::switch_asked, [&] { ++switched; });
  Coupling classic;
  classic.mode = Coupling::Mode::classic;
  classic.k_t = 250;
  classic.k_r = 0.5;
  panel->show_sets({stiff(450), classic}, 0);
  auto *a = find<QPushButton>("gains_a"), *b = find<QPushButton>("gains_b");
  EXPECT_EQ(a->text(), "A: k 450 N/m");
  EXPECT_EQ(b->text(), "B: k_t 250 N/m\nk_r 0.500 N·m/rad");
  EXPECT_TRUE(a->isChecked() && !b->isChecked());
  a->click();
  EXPECT_TRUE(a->isChecked()) << "it stays";
  EXPECT_EQ(switched, 0);
  b->click();
  EXPECT_EQ(switched, 1);
}

TEST_F(StiffnessPanelTest, figures_of_a_pair_end_with_it) {
  Buzz buzz;
  buzz.energy = -0.0125;
  panel->show_buzz(buzz, 1);
  EXPECT_EQ(text("energy_value"), "-12.5 mJ");
  panel->clear_history();
  EXPECT_EQ(text("energy_value"), "–");
}

}  // namespace
}  // namespace sonde::ui::test
