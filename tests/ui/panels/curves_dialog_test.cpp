// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/curves_dialog.hpp"

#include <QComboBox>
#include <QPushButton>
#include <QTest>

#include "tests/engine/study/tuning/made_up_results.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/panels/stiffness_panel.hpp"
#include "ui/panels/study_chart.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::column;
using sonde::test::line;

/// With a recommendation, unless `none`.
TuningResults results(bool none = false) {
  TuningResults out = sonde::test::results();
  out.device.insert({{"damping", 0.5}, {"max_damping", 20}, {"delay", 1e-3}});
  out.lines = {line(1, GainAxis::object, {column(0, none ? 0 : 900)})};
  return out;
}

class CurvesDialogTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
  }
  static QStringList titles(const QWidget& dialog) {
    const auto* choice = dialog.findChild<QComboBox*>(QStringLiteral("curves_choice"));
    QStringList out;
    for (int i = 0; i < choice->count(); ++i) out << choice->itemText(i);
    return out;
  }
};

/// The reference is the study's own list of charts, which its pictures hold too.
TEST_F(CurvesDialogTest, has_every_chart_that_the_study_writes) {
  CurvesDialog dialog(nullptr);
  const TuningResults found = results();
  const std::vector<DeviceCurves> curves = device_curves(found);
  dialog.show_curves(QStringLiteral("omega.7"), curves);
  QStringList wanted;
  for (const DeviceCurves& each : curves)
    for (const ChartPanel& panel : each.chart.panels) wanted << QString::fromStdString(panel.title);
  EXPECT_EQ(titles(dialog), wanted);
  for (const char* words : {"stable and passive below the lines", "limit by delay", "impedance at",
                            "rate-hardness", "rise of the force"})
    EXPECT_FALSE(wanted.filter(QLatin1String(words)).isEmpty()) << words;
  EXPECT_EQ(dialog.windowTitle(), QStringLiteral("omega.7 alone"));
}

TEST_F(CurvesDialogTest, the_chosen_chart_is_shown_and_stays) {
  CurvesDialog dialog(nullptr);
  dialog.show_curves(QStringLiteral("one"), device_curves(results()));
  auto* choice = dialog.findChild<QComboBox*>(QStringLiteral("curves_choice"));
  auto* chart = dialog.findChild<StudyChart*>(QStringLiteral("study_chart"));
  ASSERT_TRUE(choice && chart);
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  const QImage first = chart->picture();
  choice->setCurrentIndex(2);
  EXPECT_NE(chart->picture(), first);
  const QString chosen = choice->currentText();
  dialog.show_curves(QStringLiteral("two"), device_curves(results()));
  EXPECT_EQ(choice->currentText(), chosen);
  dialog.show_curves(QStringLiteral("three"), {});
  EXPECT_EQ(choice->count(), 0);
  EXPECT_FALSE(chart->isVisible());
}

/// Without a recommendation there is no impedance of it; the rest does not need one.
TEST_F(CurvesDialogTest, without_a_recommendation_the_device_alone_is_still_there) {
  CurvesDialog dialog(nullptr);
  dialog.show_curves(QStringLiteral("omega.7"), device_curves(results(true)));
  EXPECT_FALSE(titles(dialog).isEmpty());
  EXPECT_TRUE(titles(dialog).filter(QStringLiteral("impedance")).isEmpty());
}

TEST_F(CurvesDialogTest, opens_from_the_dock_and_closes_with_its_study) {
  StiffnessPanel panel({"omega.7"});
  panel.show();
  panel.show_tuning(Tuning{.folder = {}, .results = results()});
  auto* button = panel.findChild<QPushButton*>(QStringLiteral("device_curves"));
  ASSERT_TRUE(button);
  button->click();
  auto* dialog = panel.findChild<CurvesDialog*>(QStringLiteral("curves_dialog"));
  ASSERT_TRUE(dialog);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_FALSE(titles(*dialog).filter(QStringLiteral("impedance")).isEmpty());
  panel.show_tuning(Tuning{.folder = {}, .results = results(true)});
  EXPECT_TRUE(dialog->isVisible()) << "the next study's";
  EXPECT_TRUE(titles(*dialog).filter(QStringLiteral("impedance")).isEmpty());
  panel.show_tuning({});
  EXPECT_FALSE(dialog->isVisible());
}

}  // namespace
}  // namespace sonde::ui::test
