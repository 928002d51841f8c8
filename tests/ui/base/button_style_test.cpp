// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/button_style.hpp"

#include <gtest/gtest.h>

#include <QPainter>
#include <QPushButton>
#include <QStyleOptionButton>
#include <QToolButton>
#include <cstdlib>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

class ButtonStyleTest : public testing::TestWithParam<Theme> {
 protected:
  void SetUp() override {
    need_application();
    apply_theme(*qApp, GetParam());
  }
  void TearDown() override {
    qApp->setStyleSheet({});
    darken();
  }

  /// As the style of the program draws a button in that state; the colour beside its text.
  static QColor drawn(QStyle::State state, bool tool) {
    QPushButton button("Save");
    QToolButton tool_button;
    QImage image(80, 28, QImage::Format_RGB32);
    image.fill(QApplication::palette().color(QPalette::Window));
    QPainter painter(&image);
    QStyleOptionButton option;
    option.palette = QApplication::palette();
    option.rect = image.rect();
    option.state = QStyle::State_Enabled | state;
    const QWidget* widget = tool ? static_cast<QWidget*>(&tool_button) : &button;
    QApplication::style()->drawPrimitive(
        tool ? QStyle::PE_PanelButtonTool : QStyle::PE_PanelButtonCommand, &option, &painter,
        widget);
    painter.end();
    return image.pixelColor(12, 14);
  }
  static int apart(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
           std::abs(a.blue() - b.blue());
  }
};

/// 30 of 765 is what the tests of pictures call visible.
TEST_P(ButtonStyleTest, one_sees_which_is_under_the_cursor_and_which_is_pressed) {
  for (const bool tool : {false, true}) {
    const QColor rest = drawn(QStyle::State_Raised, tool);
    const QColor hovered = drawn(QStyle::State_Raised | QStyle::State_MouseOver, tool);
    const QColor pressed = drawn(QStyle::State_Sunken | QStyle::State_MouseOver, tool);
    EXPECT_GT(apart(rest, hovered), 40) << tool;
    EXPECT_GT(apart(rest, pressed), 40) << tool;
    EXPECT_GT(apart(hovered, pressed), 30) << tool;
  }
}

INSTANTIATE_TEST_SUITE_P(Themes, ButtonStyleTest, testing::Values(Theme::dark, Theme::light),
                         [](const auto& info) {
                           return std::string(info.param == Theme::dark ? "dark" : "light");
                         });

}  // namespace
}  // namespace sonde::ui::test
