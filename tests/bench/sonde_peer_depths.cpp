// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-peer-depths: what FCL and Bullet call the depth of penetration at given poses of a scene,
// as series for `sonde trade --series`.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "engine/platform/processor_time.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"
#include "engine/text/number_text.hpp"
#include "tests/bench/peer.hpp"

namespace sonde::bench {
namespace {

/// The least of a few: what else the machine does only adds.
constexpr int repeats = 3;

void print_depths(const Peer& peer, const std::string& name, const std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Transform X_BA(poses[i]);
    double depth = 0, time_us = INFINITY;
    for (int k = 0; k < repeats; ++k) {
      const double begin = processor_time_us();
      depth = peer.depth(X_BA);
      time_us = std::fmin(time_us, processor_time_us() - begin);
    }
    std::printf("%s,%zu,%s,%s\n", name.c_str(), i,
                std::isfinite(depth) ? number_text(depth).c_str() : "",
                number_text(time_us, 6).c_str());
  }
}

void run(const std::string& file, const std::string& poses_file) {
  const Scene scene = read_scene(file);
  const std::vector<Pose> poses = read_poses(poses_file);
  const auto probe = load(scene.probe, scene.unit), fixed = load(scene.fixed, scene.unit);
  std::puts("series,pose,depth,time_us");
  for (const PeerLibrary& library : installed_peers()) {
    const Peer peer = library.pair(probe->soup, fixed->soup, probe->mass.com);
    if (peer.depth) print_depths(peer, library.name + " " + library.version, poses);
  }
}

}  // namespace
}  // namespace sonde::bench

int main(int argc, char** argv) {
  CLI::App app("Prints what FCL and Bullet call the depth of penetration, for sonde trade --series",
               "sonde-peer-depths");
  std::string scene, poses;
  app.add_option("SCENE", scene, "scene file, NAME.sonde.json")->required();
  app.add_option("--poses", poses, "poses.csv of a folder of sonde trade")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    sonde::bench::run(scene, poses);
    return 0;
  } catch (const std::exception& bad) {
    std::fprintf(stderr, "sonde-peer-depths: %s\n", bad.what());
    return 3;
  }
}
