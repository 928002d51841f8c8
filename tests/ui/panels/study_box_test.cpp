// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_box.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "tests/ui/window_fixture.hpp"
#include "ui/tuning/tuning.hpp"

namespace sonde::ui::test {
namespace {

QPushButton& button_of(const QWidget& box, const char* name) {
  return *box.findChild<QPushButton*>(name);
}

TEST(StudyBoxTest, a_device_and_one_kind_of_contact_are_chosen_or_all) {
  need_application();
  StudyBox box({"omega.7", "sigma.7"}, nullptr);
  EXPECT_EQ(box.device_id(), "omega.7");
  EXPECT_EQ(box.kind(), "") << "all";
  box.choose_device("sigma.7");
  EXPECT_EQ(box.device_id(), "sigma.7");
  box.choose_device("");
  EXPECT_EQ(box.device_id(), "sigma.7") << "none is simulated: the choice stays";
  auto* devices = box.findChild<QComboBox*>("tuning_device");
  for (int i = 0; i < 2; ++i) box.choose_device("own");
  EXPECT_EQ(box.device_id(), "own") << "of a file of the user's";
  EXPECT_EQ(devices->count(), 3);
  auto* kinds = box.findChild<QComboBox*>("tuning_kind");
  ASSERT_EQ(std::size_t(kinds->count()), 1 + situation_kinds().size());
  kinds->setCurrentIndex(2);
  EXPECT_EQ(box.kind(), situation_kinds()[1]);
}

TEST(StudyBoxTest, each_button_asks_for_its_own_and_what_cannot_be_is_off) {
  need_application();
  StudyBox box({"omega.7"}, nullptr);
  std::string asked;
  QObject::connect(&box, &StudyBox::load_asked, [&] { asked += "load "; });
  QObject::connect(&box, &StudyBox::compute_asked, [&] { asked += "compute "; });
  QObject::connect(&box, &StudyBox::save_asked, [&] { asked += "save "; });
  box.set_unsaved(false);
  for (const char* name : {"save_tuning", "compute_tuning", "load_tuning"})
    button_of(box, name).click();
  EXPECT_EQ(asked, "compute load ") << "there is nothing to save";
  box.set_unsaved(true);
  button_of(box, "save_tuning").click();
  EXPECT_EQ(asked, "compute load save ");
  const StudyBox without({}, nullptr);
  EXPECT_FALSE(button_of(without, "compute_tuning").isEnabled()) << "there is no device";
  EXPECT_TRUE(button_of(without, "load_tuning").isEnabled());
}

TEST(StudyBoxTest, says_where_the_map_is_from_as_plain_text) {
  need_application();
  StudyBox box({"omega.7"}, nullptr);
  box.set_source("<b>study</b>, for omega.7.", "/studies/<b>study</b>");
  auto* source = box.findChild<QLabel*>("tuning_source");
  EXPECT_EQ(source->text(), "<b>study</b>, for omega.7.");
  EXPECT_EQ(source->textFormat(), Qt::PlainText) << "a folder may have any name";
  EXPECT_EQ(source->toolTip(), "/studies/<b>study</b>");
}

TEST(StudyBoxTest, the_line_of_a_study_at_work_is_there_as_long_as_it_is) {
  need_application();
  QWidget window;
  StudyProgressRow row(&window);
  int stopped = 0;
  QObject::connect(&row, &StudyProgressRow::stop_asked, [&] { ++stopped; });
  EXPECT_FALSE(row.isVisibleTo(&window));
  row.show_progress(StudyProgress{.fraction = 0.25, .words = "3 of 12 rows"});
  EXPECT_TRUE(row.isVisibleTo(&window));
  EXPECT_EQ(row.findChild<QLabel*>("study_progress_words")->text(), "3 of 12 rows");
  auto* bar = row.findChild<QProgressBar*>();
  EXPECT_EQ(bar->value(), bar->maximum() / 4);
  button_of(row, "stop_tuning").click();
  EXPECT_EQ(stopped, 1);
  row.show_progress({});
  EXPECT_FALSE(row.isVisibleTo(&window));
}

}  // namespace
}  // namespace sonde::ui::test
