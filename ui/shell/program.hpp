// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::ui {

/// sonde-view from its command line to its exit code: 0 done; 2 wrong usage; 3 bad input on the
/// command line; 4 a fault of ours, or no display to draw on.
int run(int argc, char** argv);

}  // namespace sonde::ui
