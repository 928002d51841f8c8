// SPDX-License-Identifier: GPL-3.0-or-later
// Themes, and the keyboard's way through the docks.

#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QTest>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

class DeskTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    activate();
  }
  void TearDown() override {
    darken();
    static_cast<QApplication*>(QApplication::instance())->setStyleSheet({});
    WindowTest::TearDown();
  }
};

TEST_F(DeskTest, a_theme_is_chosen_and_kept_and_labels_follow) {
  const auto window_lightness = [] {
    return QApplication::palette().color(QPalette::Window).lightness();
  };
  const auto coloured = [this] {
    QString all;
    for (const QLabel* label : window->findChildren<QLabel*>()) all += label->text();
    // On the window: a style that has a ground of its own begins with that.
    return all.count(QStringLiteral("'color:") + colour::ghost.name());
  };
  act("theme_dark");
  EXPECT_LT(window_lightness(), 80);
  EXPECT_GT(coloured(), 0);
  act("theme_light");
  EXPECT_GT(window_lightness(), 200);
  EXPECT_EQ(coloured(), 0) << "light text on a light window";
  EXPECT_EQ(chosen_theme(), Theme::light);
  act("theme_system");
  EXPECT_EQ(window_lightness() < 128, system_is_dark());
  act("theme_dark");
  EXPECT_GT(coloured(), 0);
}

/// By the Web Content Accessibility Guidelines, 3:1 is enough for lines and marks.
TEST_F(DeskTest, the_picture_and_the_plots_follow_the_theme) {
  open_cubes();
  window->set_paused(true);
  window->history().plots().show();
  window->history().plots().raise();
  const auto corner = [](const QImage& image) { return image.pixelColor(3, image.height() - 4); };
  const auto charts = [this](const char* theme) {
    const std::size_t before = window->history().plots().drawn();
    act(theme);
    wait_until([&] { return window->history().plots().drawn() > before; });
    return window->history().plots().charts().picture();
  };
  const auto yellow = [this](const QColor& like) {
    const QImage image = picture();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor at = image.pixelColor(x, y);
        count += std::abs(at.hsvHue() - like.hsvHue()) < 8 && at.hsvSaturation() > 90 &&
                 std::abs(at.value() - like.value()) < 60;
      }
    return count;
  };
  EXPECT_GT(corner(charts("theme_light")).lightness(), 200);
  EXPECT_GT(corner(picture()).lightness(), 200);
  const QColor light_contact = readable(colour::contact, QApplication::palette());
  ASSERT_LT(light_contact.value(), colour::contact.value());
  EXPECT_GT(yellow(light_contact), 20) << "the contacts are darker";
  EXPECT_LT(corner(charts("theme_dark")).lightness(), 80);
  EXPECT_LT(corner(picture()).lightness(), 80);
  EXPECT_GT(yellow(colour::contact), 20) << "and have their own colour again";
}

TEST_F(DeskTest, the_keyboard_comes_to_every_dock_and_back_to_the_view) {
  QStringList seen;
  const auto dock_of_focus = [this]() -> QString {
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
      if (dock->isAncestorOf(QApplication::focusWidget())) return dock->objectName();
    return {};
  };
  for (int i = 0; i < 20; ++i) {
    QTest::keyClick(window.get(), Qt::Key_F6);
    const QString now = dock_of_focus();
    if (now.isEmpty()) break;
    seen << now;
  }
  EXPECT_EQ(QApplication::focusWidget(), window->viewport().canvas());
  for (const char* dock : {"coupling_panel", "device_panel", "pose_panel", "seeing_panel"})
    EXPECT_TRUE(seen.contains(dock)) << dock << " of " << seen.join(' ').toStdString();
  EXPECT_EQ(seen.removeDuplicates(), 0);
}

TEST_F(DeskTest, the_theme_that_is_chosen_is_checked_alone) {
  for (const char* chosen : {"theme_light", "theme_system", "theme_dark"}) {
    act(chosen);
    for (const char* theme : {"theme_light", "theme_system", "theme_dark"})
      EXPECT_EQ(find<QAction>(theme)->isChecked(), std::string(theme) == chosen)
          << theme << " after " << chosen;
  }
}

TEST_F(DeskTest, a_key_folds_the_docks_at_the_sides_away_and_back) {
  const auto open_docks = [this] {
    int count = 0;
    for (const QDockWidget* dock : window->docks_of_sides())
      count += dock->isVisible() && !dock->isFloating() &&
               window->dockWidgetArea(const_cast<QDockWidget*>(dock)) != Qt::BottomDockWidgetArea;
    return count;
  };
  const int before = open_docks();
  ASSERT_GT(before, 0);
  QTest::keyClick(window.get(), Qt::Key_F9);
  EXPECT_EQ(open_docks(), 0);
  QTest::keyClick(window.get(), Qt::Key_F9);
  EXPECT_EQ(open_docks(), before);
}

}  // namespace
}  // namespace sonde::ui::test
