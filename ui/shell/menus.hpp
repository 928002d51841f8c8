// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::ui {

class MainWindow;

/// Fills the menu bar and the tool bar. Object names of actions: new, open_scene, open_meshes,
/// save, save_as, screenshot, quit, undo, redo, copy_pose, paste_pose, start_from_here,
/// swap_bodies, bodies, reset, pause, force, show_ghost, show_screw, show_contacts, show_wrench,
/// show_nearest, show_straight, show_defects, show_handles, local_handles, show_hint, trail, swing,
/// fit, manual, keys, about.
void add_menus(MainWindow& window);

}  // namespace sonde::ui
