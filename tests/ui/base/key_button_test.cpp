// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/key_button.hpp"

#include <gtest/gtest.h>

#include <QKeyEvent>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST(KeyButton, takes_space_and_enter_before_a_shortcut_does_and_no_other_key) {
  need_application();
  KeyButton button;
  int pressed = 0;
  QObject::connect(&button, &QToolButton::clicked, [&] { ++pressed; });
  for (const int key : {int(Qt::Key_Space), int(Qt::Key_Return), int(Qt::Key_S)}) {
    QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::NoModifier);
    asked.ignore();
    QApplication::sendEvent(&button, &asked);
    EXPECT_EQ(asked.isAccepted(), key != Qt::Key_S);
    QTest::keyClick(&button, Qt::Key(key));
  }
  EXPECT_EQ(pressed, 2);
}

}  // namespace
}  // namespace sonde::ui::test
