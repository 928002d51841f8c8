// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sonde::ui {

/// "about 40 s left", "about 5 min left".
QString time_left_text(double seconds);

/// The same of work that has taken `elapsed` s and has done that part of itself. Empty in the first
/// seconds, which tell little. Where no part is known to be done it says how long it has taken, so
/// that nobody waits before a bar that says nothing.
QString time_left_text(double elapsed, double part);

}  // namespace sonde::ui
