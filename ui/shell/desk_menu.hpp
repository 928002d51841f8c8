// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenu;

namespace sonde::ui {

class MainWindow;

/// What of the View menu is about the window and not the picture: the theme and the docks, each in
/// a menu of its own. Object names of actions: theme_dark, theme_light, theme_system, fold_docks,
/// next_dock.
void add_desk_menu(MainWindow& window, QMenu& menu);

}  // namespace sonde::ui
