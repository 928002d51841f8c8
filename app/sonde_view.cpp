// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-view, the desktop program.

#include "ui/shell/program.hpp"

int main(int argc, char** argv) { return sonde::ui::run(argc, argv); }
