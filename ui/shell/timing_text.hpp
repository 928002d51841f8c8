// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// How the servo keeps its deadlines, in a few lines of plain text: median, p99, p99.9 and the
/// longest of its times in µs, late ticks, and what the system granted.
QString timing_text(const ServoTiming& timing);

}  // namespace sonde::ui
