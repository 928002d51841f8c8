// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenuBar;

namespace sonde::ui {

class MainWindow;
class SeeingControl;

/// The Look menu: seeing inside, measuring, and where from one looks. Object names of actions:
/// xray_fixed, xray_probe, wire_fixed, wire_probe, hide_fixed, hide_probe, cut, cut_flip_now,
/// cut_snap_now, cut_face_now, measure, gap_colours, follow_contact, from_right, from_left,
/// from_back, from_front, from_above, from_below, save_view.
void add_seeing_menu(MainWindow& window, QMenuBar& bar, SeeingControl& seeing);

}  // namespace sonde::ui
