// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog alone: measure_control_test.cpp measures with it.
#include "ui/actions/measure_dialog.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

#include "tests/engine/study/identification/made_up_identification.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/resources.hpp"

namespace sonde::ui::test {
namespace {

class MeasureDialogTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    dialog = std::make_unique<MeasureDialog>(nullptr);
    subject.device = "An <b>arm</b>";
    const std::vector bundled{device_profile_folders()[1]};  // no folder of the user's
    subject.profile = find_device_profile("sigma.7", bundled);
    QObject::connect(dialog.get(), &MeasureDialog::start_asked, [this] { asked += "start "; });
    QObject::connect(dialog.get(), &MeasureDialog::cancel_asked, [this] { asked += "cancel "; });
    QObject::connect(dialog.get(), &MeasureDialog::save_asked, [this] { asked += "save "; });
    QObject::connect(dialog.get(), &MeasureDialog::use_asked, [this] { asked += "use "; });
    QObject::connect(dialog.get(), &MeasureDialog::profile_chosen,
                     [this](const QString& id) { asked += id.toStdString() + ' '; });
  }
  void consent() {
    dialog->show_consent(subject);
    dialog->show();
  }
  /// The beginning of a plan that is under way.
  void run() {
    const PulsePlan plan = plan_pulses(subject.profile, dialog->limits(), subject.sample_time);
    PulseProgress progress;
    progress.pulses = plan.pulses.size();
    progress.pulse = 1;
    progress.sample = 250;
    progress.samples = 1000;
    dialog->show_progress(plan, progress);
  }
  template <class T>
  T& field(const char* name) const {
    return *dialog->findChild<T*>(name);
  }
  bool shows(const char* name) const { return field<QWidget>(name).isVisible(); }
  void press(const char* name) { field<QPushButton>(name).click(); }
  std::unique_ptr<MeasureDialog> dialog;
  MeasureSubject subject;
  std::string asked;
};

TEST_F(MeasureDialogTest, says_what_will_happen_to_which_device_before_it_starts) {
  consent();
  const QString what = field<QLabel>("measure_what").text();
  EXPECT_TRUE(what.contains("An &lt;b&gt;arm&lt;/b&gt;")) << "a device names itself";
  EXPECT_TRUE(what.contains("pulses of at most 2.00 N")) << what.toStdString();
  EXPECT_TRUE(what.contains("Take your hand off the handle"));
  field<QDoubleSpinBox>("measure_force").setValue(1);
  EXPECT_TRUE(field<QLabel>("measure_what").text().contains("at most 1.00 N"));
  EXPECT_EQ(asked, "");
  press("measure_start");
  EXPECT_EQ(asked, "start ");
}

TEST_F(MeasureDialogTest, limits_are_those_that_are_set_and_none_beyond_what_is_allowed) {
  consent();
  field<QDoubleSpinBox>("measure_force").setValue(1.5);
  field<QDoubleSpinBox>("measure_travel").setValue(5);
  EXPECT_DOUBLE_EQ(dialog->limits().force, 1.5);
  EXPECT_DOUBLE_EQ(dialog->limits().travel, 5e-3) << "it is shown in mm";
  const PulseLimits most = most_allowed(subject.profile);
  for (const char* name : {"measure_force", "measure_torque", "measure_travel", "measure_turn"})
    field<QDoubleSpinBox>(name).setValue(1e9);
  EXPECT_NEAR(dialog->limits().force, most.force, 0.01);
  EXPECT_NEAR(dialog->limits().torque, most.torque, 0.001);
  EXPECT_NEAR(dialog->limits().travel, most.travel, 1e-4);
  EXPECT_NEAR(dialog->limits().turn, most.turn, 0.01);
}

TEST_F(MeasureDialogTest, a_device_without_torque_is_asked_for_none) {
  subject.profile.max_torque.value = 0;
  consent();
  EXPECT_TRUE(shows("measure_force"));
  EXPECT_FALSE(shows("measure_torque"));
  EXPECT_FALSE(shows("measure_turn"));
  EXPECT_EQ(dialog->limits().torque, PulseLimits{}.torque) << "as usual, which nothing plays";
}

TEST_F(MeasureDialogTest, a_profile_is_chosen_where_there_are_several) {
  consent();
  EXPECT_FALSE(shows("measure_profile"));
  subject.profiles = QStringList({"omega.7", "sigma.7"});
  consent();
  auto& profiles = field<QComboBox>("measure_profile");
  EXPECT_TRUE(profiles.isVisible());
  EXPECT_EQ(profiles.currentText(), "sigma.7");
  EXPECT_EQ(asked, "") << "showing it is no choice";
  profiles.setFocus();
  QTest::keyClick(&profiles, Qt::Key_Up);
  EXPECT_EQ(asked, "omega.7 ");
}

TEST_F(MeasureDialogTest, while_it_runs_to_close_is_to_cancel) {
  consent();
  run();
  EXPECT_TRUE(shows("measure_bar"));
  EXPECT_EQ(field<QProgressBar>("measure_bar").value() * 4,
            field<QProgressBar>("measure_bar").maximum());
  EXPECT_TRUE(field<QLabel>("measure_now").text().contains("Pulse 1 of "));
  EXPECT_TRUE(field<QLabel>("measure_now").text().contains("1 s left")) << "750 samples of 1 ms";
  dialog->reject();
  EXPECT_EQ(asked, "cancel ");
  EXPECT_TRUE(dialog->isVisible());
  press("measure_cancel");
  QTest::keyClick(dialog.get(), Qt::Key_Escape);
  EXPECT_EQ(asked, "cancel cancel cancel ");
  dialog->show_computing(0.5);
  dialog->reject();
  EXPECT_EQ(asked, "cancel cancel cancel cancel ");
}

TEST_F(MeasureDialogTest, the_key_that_has_ended_it_does_not_close_it_too) {
  consent();
  run();
  dialog->show_ended("the <i>handle</i> was held");
  EXPECT_TRUE(shows("measure_ended"));
  EXPECT_TRUE(
      field<QLabel>("measure_ended").text().contains("the &lt;i&gt;handle&lt;/i&gt; was held"));
  EXPECT_TRUE(shows("measure_start")) << "it can be started again";
  dialog->reject();
  EXPECT_TRUE(dialog->isVisible()) << "there is a reason to read";
  EXPECT_TRUE(wait_until([this] { return dialog->reject(), !dialog->isVisible(); }));
  EXPECT_EQ(asked, "");
}

TEST_F(MeasureDialogTest, what_did_not_run_is_closed_at_once) {
  consent();
  dialog->show_ended("there is no force");
  dialog->reject();
  EXPECT_FALSE(dialog->isVisible());
}

TEST_F(MeasureDialogTest, a_result_stands_beside_what_the_profile_said) {
  consent();
  dialog->show_result(sonde::test::made_up_identification(), subject.profile);
  const auto& table = field<QTableWidget>("measure_table");
  ASSERT_TRUE(table.isVisible());
  QStringList rows;
  for (int row = 0; row < table.rowCount(); ++row) {
    QStringList cells;
    for (int column = 0; column < 5; ++column) cells << table.item(row, column)->text();
    rows << cells.join('|');
  }
  EXPECT_TRUE(rows.join('\n').contains("mass|0.25|0.24 – 0.26|kg|"))
      << rows.join('\n').toStdString();
  EXPECT_TRUE(field<QLabel>("measure_found")
                  .text()
                  .contains("Not identified: torque about y: it did not move"))
      << field<QLabel>("measure_found").text().toStdString();
  EXPECT_FALSE(field<QPushButton>("measure_use").isEnabled()) << "it is not saved yet";
  press("measure_save");
  EXPECT_EQ(asked, "save ");
}

TEST_F(MeasureDialogTest, once_saved_it_can_be_used_where_it_suits) {
  consent();
  dialog->show_result(sonde::test::made_up_identification(), subject.profile);
  dialog->show_saved("/a/<own>.json", true);
  EXPECT_EQ(field<QLabel>("measure_saved").text(), "Saved: /a/&lt;own&gt;.json");
  press("measure_use");
  EXPECT_EQ(asked, "use ");
  dialog->show_saved("/a/own.json", false);
  EXPECT_FALSE(shows("measure_use"));
  dialog->reject();
  EXPECT_FALSE(dialog->isVisible());
}

}  // namespace
}  // namespace sonde::ui::test
