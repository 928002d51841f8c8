// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/desk_menu.hpp"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <algorithm>
#include <vector>

#include "ui/actions/repairs_control.hpp"
#include "ui/base/theme.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

/// The first thing in there that takes the keyboard; null where nothing does.
QWidget* first_control(const QWidget& within) {
  for (QWidget* inside : within.findChildren<QWidget*>())
    if (inside->isVisible() && inside->isEnabled() && (inside->focusPolicy() & Qt::TabFocus))
      return inside;
  return nullptr;
}

/// From the view through the docks, those that are folded away too, then to the bar of what was
/// mended, or to the notice while that is folded away, and back.
void focus_next(MainWindow& window, const QList<QDockWidget*>& all) {
  const std::vector<QDockWidget*> tabs = window.docks_of_sides();
  std::vector<QDockWidget*> docks;
  for (QDockWidget* dock : all) {
    const bool below = window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
    if (!dock->isHidden() || (!below && std::ranges::count(tabs, dock) > 0)) docks.push_back(dock);
  }
  std::size_t next = 0;
  QWidget* bar = &window.repairs().bar();
  if (bar->isHidden()) bar = &window.repairs().notice();  // its button unfolds it
  const bool in_bar = bar->isAncestorOf(QApplication::focusWidget());
  if (in_bar) next = docks.size();
  for (std::size_t i = 0; i < docks.size(); ++i)
    if (docks[i]->isAncestorOf(QApplication::focusWidget())) next = i + 1;
  // A dock that goes behind another would hand the keyboard to whoever comes next in its chain.
  window.viewport().canvas()->setFocus(Qt::TabFocusReason);
  for (; next < docks.size(); ++next) {
    docks[next]->show();  // in the place of another, where it was folded away
    QApplication::processEvents(QEventLoop::ExcludeUserInputEvents);  // its tab is on show
    const QWidget* within = docks[next]->widget();
    QWidget* control = within ? first_control(*within) : nullptr;
    if (control) return control->setFocus(Qt::TabFocusReason);
  }
  if (!in_bar && bar->isVisible())
    if (QWidget* control = first_control(*bar)) control->setFocus(Qt::TabFocusReason);
}

}  // namespace

void add_desk_menu(MainWindow& window, QMenu& menu) {
  QMenu* themes = menu.addMenu(QStringLiteral("T&heme"));
  auto* group = new QActionGroup(themes);
  struct Choice {
    const char *object, *text;
    Theme theme;
  };
  for (const Choice& choice :
       {Choice{"theme_dark", "&Dark", Theme::dark}, Choice{"theme_light", "&Light", Theme::light},
        Choice{"theme_system", "The &system's", Theme::system}}) {
    QAction* action = themes->addAction(QString::fromUtf8(choice.text));
    action->setObjectName(QLatin1String(choice.object));
    action->setCheckable(true);
    action->setChecked(chosen_theme() == choice.theme);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, &window,
                     [theme = choice.theme] { choose_theme(*qApp, theme); });
  }
  QMenu* desk = menu.addMenu(QStringLiteral("Doc&ks"));
  desk->setObjectName(QStringLiteral("docks_menu"));
  QAction* fold = desk->addAction(QStringLiteral("Fol&d or unfold the docks"));
  fold->setObjectName(QStringLiteral("fold_docks"));
  fold->setShortcut(QKeySequence(Qt::Key_F9));
  QObject::connect(fold, &QAction::triggered, &window, [w = &window] { w->fold_docks(); });
  QAction* next = desk->addAction(QStringLiteral("&Keyboard to the next dock"));
  next->setObjectName(QStringLiteral("next_dock"));
  next->setShortcut(QKeySequence(Qt::Key_F6));
  MainWindow* w = &window;
  // In the order they were made: the window's own changes with each that comes to the front.
  QObject::connect(next, &QAction::triggered, w,
                   [w, docks = w->findChildren<QDockWidget*>()] { focus_next(*w, docks); });
  desk->addSeparator();
  for (const QDockWidget* dock : w->findChildren<QDockWidget*>())
    desk->addAction(dock->toggleViewAction());
}

}  // namespace sonde::ui
