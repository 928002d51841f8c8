// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/progress_dialog.hpp"

#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

class ProgressDialogTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    dialog = std::make_unique<ProgressDialog>("Reading <b>camel</b>.off", nullptr);
    QObject::connect(dialog.get(), &QDialog::rejected, [this] { ++cancelled; });
  }
  int shown_percent() const {
    const auto* bar = dialog->findChild<QProgressBar*>();
    return 100 * (bar->value() - bar->minimum()) / (bar->maximum() - bar->minimum());
  }
  std::unique_ptr<ProgressDialog> dialog;
  int cancelled = 0;
};

TEST_F(ProgressDialogTest, says_what_is_done_as_plain_text) {
  QStringList plain;
  for (const QLabel* label : dialog->findChildren<QLabel*>())
    if (label->textFormat() == Qt::PlainText) plain << label->text();
  EXPECT_TRUE(plain.contains("Reading <b>camel</b>.off")) << "a file may be called anything";
}

TEST_F(ProgressDialogTest, its_bar_follows_and_it_shows_itself_to_nobody) {
  dialog->show_progress(0.25, 1);
  EXPECT_EQ(shown_percent(), 25);
  dialog->show_progress(1, 20);
  EXPECT_EQ(shown_percent(), 100);
  EXPECT_FALSE(dialog->isVisible()) << "only its owner knows whether the work takes long";
  dialog->show();
  dialog->show_progress(1, 21);
  EXPECT_TRUE(dialog->isVisible()) << "nor does it go with the end of the work";
  EXPECT_EQ(cancelled, 0);
}

TEST_F(ProgressDialogTest, the_button_cancels) {
  dialog->show();
  QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                    Qt::LeftButton);
  EXPECT_EQ(cancelled, 1);
}

TEST_F(ProgressDialogTest, esc_and_closing_cancel_too) {
  dialog->show();
  QTest::keyClick(dialog.get(), Qt::Key_Escape);
  EXPECT_EQ(cancelled, 1);
  dialog->show();
  dialog->close();
  EXPECT_EQ(cancelled, 2);
}

}  // namespace
}  // namespace sonde::ui::test
