// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/prompts.hpp"

#include <gtest/gtest.h>

#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTimer>

#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

class PromptsTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    // What Qt's own dialog of files remembers too.
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(home.path().string()));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(home.path().string()));
    window = std::make_unique<QWidget>();
    window->show();
    prompts = dialogs(*window);
  }
  /// What answers the next question.
  void then(std::function<void(QWidget&)> answer) {
    QTimer::singleShot(0, window.get(), [this, answer = std::move(answer)] {
      QWidget* asked = QApplication::activeModalWidget();
      ASSERT_TRUE(asked);
      if (const auto* box = qobject_cast<QMessageBox*>(asked)) {
        text = box->text() + '\n' + box->informativeText();
        plain = box->textFormat() == Qt::PlainText;
        buttons.clear();
        for (const QAbstractButton* button : box->buttons()) buttons << button->text();
      }
      answer(*asked);
    });
  }
  void then_press(const QString& name) {
    then([name](QWidget& asked) {
      for (QAbstractButton* button : asked.findChildren<QAbstractButton*>())
        if (button->text() == name) return button->click();
      ADD_FAILURE() << "there is no " << name.toStdString();
      static_cast<QDialog&>(asked).reject();
    });
  }
  void then_key(Qt::Key key) {
    then([key](QWidget& asked) {
      QTest::keyClick(&asked, key);
      const bool waits = asked.isVisible();
      EXPECT_FALSE(waits);
      if (waits) static_cast<QDialog&>(asked).reject();
    });
  }
  sonde::test::TempFolder home;
  std::unique_ptr<QWidget> window;
  Prompts prompts;
  QString text;  ///< of the last question
  QStringList buttons;
  bool plain = false;
};

TEST_F(PromptsTest, an_error_is_told_as_it_is) {
  then_key(Qt::Key_Return);
  prompts.report_error("<b>cup</b>.off: it is empty");
  EXPECT_TRUE(text.startsWith("<b>cup</b>.off: it is empty"));
  EXPECT_TRUE(plain) << "a file may be called anything";
}

TEST_F(PromptsTest, who_leaves_saves_discards_or_stays) {
  then_press("Save");
  EXPECT_EQ(prompts.ask_leaving("<i>cup</i>"), Leaving::save);
  EXPECT_TRUE(text.contains("“<i>cup</i>” has changes")) << text.toStdString();
  EXPECT_TRUE(plain);
  then_press("Discard");
  EXPECT_EQ(prompts.ask_leaving("cup"), Leaving::discard);
  then_press("Cancel");
  EXPECT_EQ(prompts.ask_leaving("cup"), Leaving::stay);
  then_key(Qt::Key_Escape);
  EXPECT_EQ(prompts.ask_leaving("cup"), Leaving::stay) << "Esc loses nothing";
  then_key(Qt::Key_Return);
  EXPECT_EQ(prompts.ask_leaving("cup"), Leaving::save) << "nor does Enter";
}

TEST_F(PromptsTest, a_recovered_scene_is_opened_discarded_or_left_for_later) {
  then_press("Recover");
  EXPECT_EQ(prompts.ask_recover("cup"), Recovering::open);
  then_press("Discard");
  EXPECT_EQ(prompts.ask_recover("cup"), Recovering::discard);
  then_key(Qt::Key_Escape);
  EXPECT_EQ(prompts.ask_recover("cup"), Recovering::later);
}

TEST_F(PromptsTest, what_would_lose_something_is_done_where_one_says_so_and_esc_does_not) {
  using Ask = std::function<bool(const QString&)> Prompts::*;
  const std::pair<Ask, const char*> asked[] = {{&Prompts::ask_reload, "Read it again"},
                                               {&Prompts::ask_overwrite, "Save all the same"},
                                               {&Prompts::ask_replace, "Replace it"}};
  for (const auto& [ask, yes] : asked) {
    then_press(yes);
    EXPECT_TRUE((prompts.*ask)("/a/cup.sonde.json"));
    EXPECT_TRUE(text.contains("/a/cup.sonde.json"));
    then_key(Qt::Key_Escape);
    EXPECT_FALSE((prompts.*ask)("/a/cup.sonde.json")) << yes;
  }
}

TEST_F(PromptsTest, paths_out_of_a_scenes_folder_are_shown_without_control_characters) {
  then_press("Open");
  EXPECT_EQ(prompts.ask_paths("cup", {"/etc/passwd", "/a\x1b[31m\nb"}), Consent::kept);
  EXPECT_TRUE(text.contains("/etc/passwd\n"));
  EXPECT_TRUE(text.contains("/a\\x1b[31m\\x0ab")) << text.toStdString();
  then_key(Qt::Key_Escape);
  EXPECT_EQ(prompts.ask_paths("cup", {"/etc/passwd"}), Consent::refused);
}

TEST_F(PromptsTest, meshes_can_be_what_so_many_can_be) {
  then_press("The probe");
  EXPECT_EQ(prompts.ask_role("cup.off", 1), Role::probe);
  EXPECT_EQ(buttons.size(), 4);
  then_press("The fixed body");
  EXPECT_EQ(prompts.ask_role("cup.off", 1), Role::fixed);
  then_press("A further part");
  EXPECT_EQ(prompts.ask_role("cup.off", 1), Role::parts);
  then_press("Probe and fixed body");
  EXPECT_EQ(prompts.ask_role("2 meshes", 2), Role::pair);
  then_press("Further parts");
  EXPECT_EQ(prompts.ask_role("2 meshes", 2), Role::parts);
  then_press("Further parts");
  EXPECT_EQ(prompts.ask_role("3 meshes", 3), Role::parts);
  EXPECT_EQ(buttons.size(), 2);
  for (const int meshes : {1, 2, 3}) {
    then_key(Qt::Key_Escape);
    EXPECT_EQ(prompts.ask_role("meshes", meshes), std::nullopt) << meshes;
  }
}

TEST_F(PromptsTest, a_scene_that_is_saved_gets_its_ending) {
  const sonde::test::TempFolder folder;
  const QString first = QString::fromStdString((folder / "cup.sonde.json").string());
  then([](QWidget& asked) {
    auto* name = asked.findChild<QLineEdit*>("fileNameEdit");
    ASSERT_TRUE(name);
    EXPECT_EQ(name->text(), "cup.sonde.json");
    name->setText("copy");
    static_cast<QDialog&>(asked).accept();
    if (asked.isVisible()) static_cast<QDialog&>(asked).reject();
  });
  EXPECT_EQ(prompts.ask_save(first), QString::fromStdString((folder / "copy.sonde.json").string()));
  then_key(Qt::Key_Escape);
  EXPECT_EQ(prompts.ask_save(first), "");
}

TEST_F(PromptsTest, a_file_that_is_not_chosen_is_no_name) {
  for (const auto& ask : {prompts.ask_scene, prompts.ask_recording, prompts.ask_record,
                          prompts.ask_path, prompts.ask_picture, prompts.ask_tuning}) {
    then_key(Qt::Key_Escape);
    EXPECT_EQ(ask(), "");
  }
  then_key(Qt::Key_Escape);
  EXPECT_EQ(prompts.ask_parts(), QStringList());
  then_key(Qt::Key_Escape);
  EXPECT_EQ(prompts.ask_meshes(""), std::nullopt);
}

}  // namespace
}  // namespace sonde::ui::test
