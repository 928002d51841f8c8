// SPDX-License-Identifier: GPL-3.0-or-later
// How deep two meshes are in each other, as their files place them: resources/docs/use/library.md.
#include <cstdio>
#include <sonde/sonde.hpp>
#include <stdexcept>

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("give two meshes: the probe and the fixed body");
  const sonde::Pair pair(sonde::read_body(argv[1]), sonde::read_body(argv[2]));
  const sonde::Separation s = sonde::separate(pair, sonde::Pose());
  if (s.status == sonde::Status::failed) throw std::runtime_error(s.reason);
  std::printf("%.17g\n", s.depth);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
