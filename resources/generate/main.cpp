// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-generate FOLDER: writes the example models, scenes and device paths under FOLDER.
#include <cstdio>
#include <exception>

#include "resources/generate/output.hpp"

int main(int argc, char** argv) {
  using namespace sonde::generate;
  if (argc != 2 || argv[1][0] == '-') {
    std::fputs("usage: sonde-generate FOLDER   (gets FOLDER/models and FOLDER/scenes)\n", stderr);
    return 2;
  }
  try {
    const Output out(argv[1]);
    write_spoon_in_cup(out);
    write_torus_knots(out);
    write_linked_tori(out);
    write_peg_in_hole(out);
    write_nut_on_bolt(out);
    write_crumpled_soup(out);
    write_terrain(out);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-generate: %s\n", error.what());
    return 4;
  }
}
