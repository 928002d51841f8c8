// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/tuner.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "tests/ui/actions/stiffness_fixture.hpp"
#include "ui/panels/map_plot.hpp"

namespace sonde::ui::test {
namespace {

using TunerTest = StiffnessTest;

/// All kinds of contact: it takes tens of seconds, and something is found before the end.
TEST_F(TunerTest, a_study_is_computed_beside_everything_else_and_is_saved_where_asked) {
  int asked = 0;
  window->prompts().ask_tuning_folder = [&] { return ++asked, path("saved"); };
  auto* kinds = find<QComboBox>("tuning_kind");
  kinds->setCurrentIndex(kinds->findText("all contacts"));
  auto* devices = find<QComboBox>("tuning_device");
  devices->setCurrentIndex(devices->findText("sigma.7"));
  auto* compute = find<QPushButton>("compute_tuning");
  auto* progress = find<QWidget>("study_progress");
  EXPECT_FALSE(progress->isVisible());
  QTest::mouseClick(compute, Qt::LeftButton);
  EXPECT_TRUE(stiffness().computing());
  EXPECT_TRUE(progress->isVisible());
  // A study stands back behind all else: beside other work it takes several times as long.
  const auto wait_long = [](const auto& holds) {
    for (int times = 0; times < 5; ++times)
      if (wait_until(holds)) return true;
    return false;
  };
  const auto begun = [&] { return stiffness().tuning().has_value() || !complaints.empty(); };
  ASSERT_TRUE(wait_long(begun));
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  const std::size_t first = stiffness().tuning()->rows;
  EXPECT_FALSE(stiffness().tuning()->finished()) << "rows come as they are found";
  EXPECT_GE(find<MapPlot>("map_plot")->map().rows.size(), 1u);
  EXPECT_FALSE(find<QPushButton>("apply_recommended")->isVisible()) << "not before all are there";
  const auto goes_on = [&] { return stiffness().tuning()->rows > first; };
  EXPECT_TRUE(wait_long(goes_on));
  EXPECT_TRUE(text("study_progress_words").contains(" left"))
      << text("study_progress_words").toStdString();
  // Meanwhile the servo runs, the probe moves, the force comes and goes, and nothing is modal.
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  EXPECT_EQ(window->findChild<QDialog*>("progress_dialog"), nullptr);
  const double force = shown().wrench.force.norm();
  EXPECT_GT(force, 0);
  QApplication::setActiveWindow(window.get());
  QTest::keyClick(window->viewport().canvas(), Qt::Key_Escape);
  EXPECT_FALSE(window->session()->force_on());
  EXPECT_TRUE(wait_until([&] { return shown().wrench.force.norm() == 0; }));
  EXPECT_TRUE(stiffness().computing()) << "Esc is about the force alone";
  EXPECT_EQ(asked, 0);
  QTest::mouseClick(find<QPushButton>("stop_tuning"), Qt::LeftButton);
  EXPECT_FALSE(stiffness().computing());
  EXPECT_FALSE(progress->isVisible());
  EXPECT_TRUE(complaints.empty());
  const std::size_t stopped_at = stiffness().tuning()->rows;
  EXPECT_FALSE(find<QPushButton>("save_tuning")->isEnabled()) << "half a study is none to save";
  // It goes on from there: another kind's rows are taken over.
  const std::string& kind = stiffness().tuning()->results.lines.front().kind;
  kinds->setCurrentIndex(kinds->findText(QString::fromStdString(kind)));
  QTest::mouseClick(compute, Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return !stiffness().computing(); }));
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  ASSERT_TRUE(stiffness().tuning()->finished());
  EXPECT_GE(stopped_at, 1u);
  EXPECT_EQ(stiffness().tuning()->results.device_id, "sigma.7");
  EXPECT_FALSE(find<QLabel>("tuning_doubt")->isVisible());
  EXPECT_EQ(asked, 0) << "a folder is asked for only to save";
  QTest::mouseClick(find<QPushButton>("save_tuning"), Qt::LeftButton);
  EXPECT_EQ(asked, 1);
  ASSERT_TRUE(wait_until([&] { return stiffness().tuning()->folder == folder / "saved"; }));
  for (const char* file : {"study.json", "recommendation.json", "map.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / "saved" / file)) << file;
  EXPECT_FALSE(find<QPushButton>("save_tuning")->isEnabled());
}

TEST(TimeLeft, is_told_from_the_rows_that_were_computed_and_not_before_one) {
  EXPECT_EQ(time_left_text(3, 0, 7, 3), "");
  EXPECT_EQ(time_left_text(20, 2, 4, 0), "about 40 s left");
  EXPECT_EQ(time_left_text(20, 2, 4, 15), "about 25 s left");
  EXPECT_EQ(time_left_text(20, 2, 4, 500), "about 1 s left");
  EXPECT_EQ(time_left_text(60, 1, 5, 0), "about 5 min left");
}

}  // namespace
}  // namespace sonde::ui::test
