// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/sweeps.hpp"

#include <algorithm>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "tests/bench/meshes.hpp"
#include "tests/bench/result.hpp"

namespace sonde::bench {
namespace {

constexpr double clearance = 1e-4 * mesh_radius;
constexpr double idle = 0.01 * mesh_radius;  // stopping further than this from B is too early
constexpr int samples = 400;

/// A trip in the coordinates of the sweep.
struct Course {
  Course(const Body& probe, const Trip& trip)
      : chart(probe.mass, trip.from), motion(chart, Vec6::Zero(), chart.coordinates(trip.to)) {}
  Chart chart;
  Motion motion;
};

Answer answer_of(bool hit, double free_until) {
  Answer answer;
  answer.touch = hit;
  answer.free_until = free_until;
  return answer;
}

/// Does a sample of the part of the path that is called free meet B? The very end is left out: it
/// is as near as the library lets it come.
template <class Path>
bool passes_through(const Stage& stage, const Path& path, double free_until) {
  for (int k = 0; k < samples; ++k) {
    const double s = static_cast<double>(k) / samples;
    if (s < free_until && triangles_meet(*stage.a, *stage.b, path(s), Doubt::exact)) return true;
  }
  return false;
}

Verdict judge_ours(const Stage& stage, const Trip& trip, const Answer& answer) {
  const Course course(*stage.a, trip);
  const auto path = [&](double s) { return course.motion.at(s); };
  if (passes_through(stage, path, *answer.free_until)) return Verdict::wrong;
  const Transform end = path(*answer.free_until);
  if (triangles_meet(*stage.a, *stage.b, end, Doubt::exact)) return Verdict::wrong;
  if (!*answer.touch) return *answer.free_until < 1 ? Verdict::wrong : Verdict::agree;
  const bool stopped_early = triangle_distance(*stage.a, *stage.b, end).distance > idle;
  return stopped_early ? Verdict::wrong : Verdict::agree;
}

Contender peer_sweep(const Stage& stage, const std::string& name,
                     const std::function<SweepAnswer(const Trip& trip)>& sweep_trip) {
  return {name, [s = &stage, sweep_trip](std::size_t i) {
            const SweepAnswer swept = sweep_trip(s->poses.trips[i]);
            return answer_of(swept.hit, swept.free_until);
          }};
}

}  // namespace

std::vector<Contender> sweep_contenders(const Stage& stage, Place /*place*/) {
  std::vector<Contender> out;
  out.push_back({ours, [s = &stage](std::size_t i) {
                   const Course course(*s->a, s->poses.trips[i]);
                   const Sweep swept = sweep(*s->a, *s->b, course.motion, clearance);
                   return answer_of(swept.hit, swept.free_until);
                 }});
  for (const Peer& peer : stage.peers) {
    if (peer.sweep) out.push_back(peer_sweep(stage, peer.name, peer.sweep));
    if (peer.sweep_oriented)
      out.push_back(peer_sweep(stage, peer.name + " oriented", peer.sweep_oriented));
  }
  return out;
}

Verdict judge_sweep(const Stage& stage, Place /*place*/, std::size_t trip, const Answer& /*ours*/,
                    const Contender& contender, const Answer& theirs) {
  const Trip& way = stage.poses.trips[trip];
  if (contender.library == ours) return judge_ours(stage, way, theirs);
  const auto peer = std::find_if(stage.peers.begin(), stage.peers.end(), [&](const Peer& p) {
    return contender.library.rfind(p.name, 0) == 0;
  });
  const auto path = [&](double s) { return peer->on_path(way, s); };
  return passes_through(stage, path, *theirs.free_until) ? Verdict::missed : Verdict::agree;
}

}  // namespace sonde::bench
