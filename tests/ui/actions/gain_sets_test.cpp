// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gain_sets.hpp"

#include <gtest/gtest.h>

#include <QUndoStack>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/coupling_panel.hpp"

namespace sonde::ui::test {
namespace {

Coupling of_stiffness(double k) {
  Coupling coupling;
  coupling.k = k;
  return coupling;
}

/// The sets of a pair that was opened with 500 N/m.
class GainSetsTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<CouplingPanel>(undo);
    sets = std::make_unique<GainSets>(*panel, undo);
    panel->take(of_stiffness(500));
    sets->take(of_stiffness(500));
    QObject::connect(panel.get(), &CouplingPanel::changed,
                     [this](const Coupling& coupling) { felt.push_back(coupling.k); });
    QObject::connect(sets.get(), &GainSets::switched, [this] { ++switched; });
  }
  void slide_to(double k) { panel->request(of_stiffness(k), "Stiffness"); }
  double k(std::size_t set) const { return sets->gains(set).k; }

  QUndoStack undo;
  std::unique_ptr<CouplingPanel> panel;
  std::unique_ptr<GainSets> sets;
  std::vector<double> felt;  ///< N/m, what the loop was told
  int switched = 0;
};

TEST_F(GainSetsTest, both_are_those_of_the_pair_at_first_and_the_first_is_active) {
  EXPECT_EQ(sets->active(), 0u);
  EXPECT_EQ(k(0), 500);
  EXPECT_EQ(k(1), 500);
  EXPECT_FALSE(undo.canUndo());
}

TEST_F(GainSetsTest, the_sliders_change_the_active_one_alone) {
  slide_to(700);
  EXPECT_EQ(k(0), 700);
  EXPECT_EQ(k(1), 500);
  sets->switch_over();
  EXPECT_EQ(sets->active(), 1u);
  EXPECT_EQ(panel->coupling().k, 500);
  EXPECT_EQ(k(0), 700) << "the other keeps its values";
  slide_to(300);
  EXPECT_EQ(k(0), 700);
  EXPECT_EQ(k(1), 300);
  sets->switch_over();
  EXPECT_EQ(panel->coupling().k, 700);
  EXPECT_EQ(felt, (std::vector<double>{700, 500, 300, 700})) << "each is felt at once";
}

TEST_F(GainSetsTest, a_switch_is_a_step_among_those_of_the_sliders) {
  slide_to(700);
  sets->switch_over();
  slide_to(300);
  EXPECT_EQ(switched, 1);
  undo.undo();
  EXPECT_EQ(k(1), 500);
  undo.undo();
  EXPECT_EQ(sets->active(), 0u);
  EXPECT_EQ(panel->coupling().k, 700);
  EXPECT_EQ(switched, 2);
  undo.undo();
  EXPECT_EQ(panel->coupling().k, 500);
  for (int i = 0; i < 3; ++i) undo.redo();
  EXPECT_EQ(sets->active(), 1u);
  EXPECT_EQ(k(0), 700);
  EXPECT_EQ(k(1), 300);
}

TEST_F(GainSetsTest, another_pair_begins_anew) {
  slide_to(700);
  sets->switch_over();
  panel->take(of_stiffness(900));
  sets->take(of_stiffness(900));
  EXPECT_EQ(sets->active(), 0u);
  EXPECT_EQ(k(0), 900);
  EXPECT_EQ(k(1), 900);
  EXPECT_EQ(switched, 2) << "what shows the active one is told";
}

TEST_F(GainSetsTest, kept_ones_are_restored_without_a_step_where_there_is_none_before) {
  sets->restore({of_stiffness(100), of_stiffness(200)}, 1);
  EXPECT_EQ(sets->active(), 1u);
  EXPECT_EQ(k(0), 100);
  EXPECT_EQ(k(1), 200);
  EXPECT_EQ(felt, std::vector<double>{200});
  EXPECT_EQ(switched, 1);
  EXPECT_FALSE(undo.canUndo());
}

TEST_F(GainSetsTest, behind_other_steps_restoring_is_one_too_and_goes_back_whole) {
  slide_to(700);
  sets->switch_over();
  sets->restore({of_stiffness(100), of_stiffness(200)}, 0);
  EXPECT_EQ(sets->active(), 0u);
  EXPECT_EQ(k(0), 100);
  slide_to(150);
  undo.undo();
  undo.undo();
  EXPECT_EQ(sets->active(), 1u);
  EXPECT_EQ(k(0), 700);
  EXPECT_EQ(k(1), 500);
  undo.redo();
  EXPECT_EQ(sets->active(), 0u);
  EXPECT_EQ(k(0), 100);
  EXPECT_EQ(k(1), 200);
  undo.redo();
  EXPECT_EQ(k(0), 150);
  for (int i = 0; i < 4; ++i) undo.undo();
  EXPECT_EQ(k(0), 500) << "as it was opened";
}

}  // namespace
}  // namespace sonde::ui::test
