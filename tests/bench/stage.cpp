// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/stage.hpp"

#include "tests/bench/meshes.hpp"

namespace sonde::bench {
namespace {

std::vector<PairSpec> scale_specs(bool quick) {
  const auto spec = [](const char* size, PoseCounts counts) {
    const std::string mesh = std::string("trefoil-") + size;
    return PairSpec{mesh, mesh, mesh, counts, false, true};
  };
  if (quick) return {spec("1k", {10, 50, 0}), spec("10k", {10, 50, 0})};
  return {spec("1k", {60, 100, 0}), spec("10k", {60, 100, 0}), spec("100k", {20, 100, 0}),
          spec("1M", {8, 100, 0})};
}

}  // namespace

std::vector<PairSpec> pair_specs(bool quick) {
  const PoseCounts counts = quick ? PoseCounts{15, 100, 3} : PoseCounts{60, 300, 10};
  std::vector<PairSpec> out = {
      {"ring-ring", "ring-32k", "ring-32k", counts},
      {"linked-rings", "ring-32k", "ring-32k", counts, true},
      {"dragon-dragon", "dragon", "dragon", counts},
  };
  if (!quick) {
    out.push_back({"sphere-sphere", "sphere-32k", "sphere-32k", counts});
    out.push_back({"trefoil-trefoil", "trefoil-32k", "trefoil-32k", counts});
    out.push_back({"bunny-armadillo", "bunny", "armadillo", counts});
    out.push_back({"elephant-knot", "elephant", "knot", counts});
    out.push_back({"glmark2-bunnies", "glmark2-bunny", "glmark2-bunny", counts});
  }
  for (const PairSpec& spec : scale_specs(quick)) out.push_back(spec);
  return out;
}

int count_of(const PairSpec& spec, Place place) {
  if (place == Place::none) return spec.scale ? 1 : 0;
  if (place == Place::trip) return spec.counts.trips;
  if (place == Place::trajectory) return spec.counts.steps;
  return spec.linked && place == Place::far ? 0 : spec.counts.poses;
}

std::unique_ptr<Stage> set_stage(const PairSpec& spec, std::uint64_t seed) {
  auto stage = std::make_unique<Stage>();
  const bool same = spec.mesh_a == spec.mesh_b;
  stage->spec = spec;
  stage->polygons_a = mesh(spec.mesh_a);
  stage->soup_a = triangulate(stage->polygons_a).soup;
  stage->a = make_body(stage->polygons_a, Model::automatic, spec.mesh_a);
  stage->b = stage->a;
  if (!same) {
    const PolygonSoup polygons_b = mesh(spec.mesh_b);
    stage->soup_b = triangulate(polygons_b).soup;
    stage->b = make_body(polygons_b, Model::automatic, spec.mesh_b);
  }
  stage->poses = make_poses(*stage->a, *stage->b, spec.linked, spec.counts, seed);
  stage->libraries = installed_peers();
  for (const PeerLibrary& library : stage->libraries)
    stage->peers.push_back(
        library.pair(stage->soup_a, same ? stage->soup_a : stage->soup_b, stage->a->mass.com));
  return stage;
}

}  // namespace sonde::bench
