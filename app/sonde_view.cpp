// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-view, the desktop program.

#include <iostream>

#include "engine/base/error.hpp"
#include "engine/simd/instruction_set.hpp"
#include "ui/shell/program.hpp"

int main(int argc, char** argv) {
  try {
    sonde::check_instruction_set();
  } catch (const sonde::InputError& error) {
    std::cerr << "sonde-view: " << error.what() << '\n';
    return 3;
  }
  return sonde::ui::run(argc, argv);
}
