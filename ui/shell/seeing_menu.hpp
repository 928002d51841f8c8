// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenu;
class QMenuBar;

namespace sonde::ui {

class MainWindow;
class SeeingControl;

/// The Bodies menu: how the bodies look, seeing inside, and measuring. Object names of actions:
/// xray_fixed, xray_probe, wire_fixed, wire_probe, hide_fixed, hide_probe, cut, cut_flip_now,
/// cut_snap_now, cut_face_now, measure, gap_colours, show_crossings.
void add_seeing_menu(MainWindow& window, QMenuBar& bar, SeeingControl& seeing);

/// What of the View menu is about where from one looks: follow_contact, from_right, from_left,
/// from_back, from_front, from_above, from_below, save_view.
void add_camera_actions(MainWindow& window, QMenu& menu, SeeingControl& seeing);

}  // namespace sonde::ui
