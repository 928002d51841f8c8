// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QUndoStack;

namespace sonde::ui {

class MainWindow;

/// Fills the menu bar and the tool bar. Object names of actions: open_scene, open_meshes,
/// screenshot, quit, undo, redo, reset, pause, force, show_ghost, show_screw, show_contacts,
/// show_wrench, show_nearest, show_straight, show_hint, trail, swing, fit, manual, keys, about.
void add_menus(MainWindow& window, QUndoStack& undo);

}  // namespace sonde::ui
