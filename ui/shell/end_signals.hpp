// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

namespace sonde::ui {

/// From here on Ctrl-C and SIGTERM call a function from the event loop, once, for as long as the
/// owner lives. A second such signal ends the program at once, for a window that does not answer.
void when_told_to_end(QObject* owner, std::function<void()> told);

}  // namespace sonde::ui
