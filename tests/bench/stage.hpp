// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "tests/bench/peer.hpp"
#include "tests/bench/poses.hpp"

namespace sonde::bench {

/// A pair of meshes to measure on.
struct PairSpec {
  std::string name;
  std::string mesh_a, mesh_b;
  PoseCounts counts;
  bool linked = false;
  bool scale = false;  ///< for the curves from 1 k to 1 M triangles
};

/// All pairs, or the few of a quick run.
std::vector<PairSpec> pair_specs(bool quick);

/// How many poses (trips, for Place::trip) of a kind the pair has.
int count_of(const PairSpec& spec, Place place);

/// One pair, loaded by every library.
struct Stage {
  PairSpec spec;
  PolygonSoup polygons_a;
  Soup soup_a, soup_b;  ///< what the other libraries are given; B's is empty where it is A's
  std::shared_ptr<const Body> a, b;
  PoseSet poses;
  std::vector<PeerLibrary> libraries;
  std::vector<Peer> peers;

  const Pose& pose(Place place, std::size_t i) const { return poses.poses.at(place)[i]; }
};
std::unique_ptr<Stage> set_stage(const PairSpec& spec, std::uint64_t seed);

}  // namespace sonde::bench
