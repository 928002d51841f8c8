// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/queries.hpp"

#include <malloc.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <span>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/queries/pair_queries.hpp"
#include "tests/bench/meshes.hpp"
#include "tests/bench/result.hpp"
#include "tests/bench/sweeps.hpp"

namespace sonde::bench {
namespace {

constexpr double reach = 0.02 * mesh_radius;
constexpr std::size_t most_rows = std::size_t{1} << 20;
constexpr const char* ours_cold = "Sonde cold";
/// As a program outside asks it: engine/sonde.hpp.
constexpr const char* ours_by_the_face = "Sonde by its face";

/// The pair of a stage, made before what is timed.
std::shared_ptr<const Pair> pair_of(const Stage& stage) {
  return std::make_shared<const Pair>(stage.a, stage.b);
}

std::vector<Contender> touch(const Stage& stage, Place place) {
  const Stage* s = &stage;
  std::vector<Contender> out;
  out.push_back({ours, [s, place](std::size_t i) {
                   Answer answer;
                   answer.touch =
                       triangles_meet(*s->a, *s->b, Transform(s->pose(place, i)), Doubt::exact);
                   return answer;
                 }});
  out.push_back({ours_by_the_face, [s, place, pair = pair_of(stage)](std::size_t i) {
                   Answer answer;
                   answer.touch = sonde::touch(*pair, s->pose(place, i));
                   return answer;
                 }});
  for (const Peer& peer : stage.peers)
    out.push_back({peer.name,
                   [s, place, p = &peer](std::size_t i) {
                     Answer answer;
                     answer.touch = p->touch(Transform(s->pose(place, i)));
                     return answer;
                   },
                   peer.touch_doubtful_within});
  return out;
}

Answer answer_of(const Distance& d) {
  Answer answer;
  answer.distance = d.distance;
  return answer;
}

Contender cold_distance(const Stage& stage, Place place, const char* name) {
  return {name, [s = &stage, place](std::size_t i) {
            return answer_of(triangle_distance(*s->a, *s->b, Transform(s->pose(place, i))));
          }};
}

void add_peer_distances(const Stage& stage, Place place, std::vector<Contender>& out) {
  for (const Peer& peer : stage.peers) {
    if (!peer.distance) continue;
    out.push_back({peer.name, [s = &stage, place, p = &peer](std::size_t i) {
                     Answer answer;
                     answer.distance = p->distance(Transform(s->pose(place, i)));
                     return answer;
                   }});
  }
}

std::vector<Contender> distance_cold(const Stage& stage, Place place) {
  std::vector<Contender> out = {cold_distance(stage, place, ours)};
  out.push_back({ours_by_the_face, [s = &stage, place, pair = pair_of(stage)](std::size_t i) {
                   Answer answer;
                   answer.distance = sonde::distance(*pair, s->pose(place, i)).distance;
                   return answer;
                 }});
  add_peer_distances(stage, place, out);
  return out;
}

/// For each step of the trajectory, the nearest pair of the step before.
std::vector<DistanceHint> last_pairs(const Stage& stage) {
  std::vector<DistanceHint> out;
  Pose last = stage.poses.lead_in;
  for (const Pose& pose : stage.poses.poses.at(Place::trajectory)) {
    const Distance d = triangle_distance(*stage.a, *stage.b, Transform(last));
    out.push_back({d.triangle_a, d.triangle_b});
    last = pose;
  }
  return out;
}

std::vector<Contender> distance_warm(const Stage& stage, Place place) {
  std::vector<Contender> out;
  out.push_back({ours, [s = &stage, place, hints = last_pairs(stage)](std::size_t i) {
                   return answer_of(
                       triangle_distance(*s->a, *s->b, Transform(s->pose(place, i)), hints[i]));
                 }});
  out.push_back(cold_distance(stage, place, ours_cold));
  add_peer_distances(stage, place, out);
  return out;
}

/// The gap of the nearest row, to be compared with the distance: looked for before the timing only.
Answer with_least_gap(Answer answer, std::span<const NearPair> rows) {
  double least = std::numeric_limits<double>::infinity();
  for (const NearPair& row : rows) least = std::min(least, row.gap);
  answer.distance = least;
  return answer;
}

/// A contender that fills rows. `fill(X_BA, out)` returns how many.
template <class Fill>
Contender row_filler(const Stage& stage, Place place, const Fill& fill) {
  const auto rows = std::make_shared<std::vector<NearPair>>(most_rows);
  const auto ask = [s = &stage, place, rows, fill](std::size_t i) {
    Answer answer;
    answer.amount =
        static_cast<double>(fill(*s->a, *s->b, Transform(s->pose(place, i)), std::span(*rows)));
    return answer;
  };
  const auto examine = [ask, rows](std::size_t i) {
    const Answer answer = ask(i);
    return with_least_gap(answer, std::span(*rows).first(static_cast<std::size_t>(*answer.amount)));
  };
  return {ours, ask, 0, examine};
}

template <class Fill>
std::vector<Contender> rows_by(const Stage& stage, Place place, const Fill& fill) {
  std::vector<Contender> out = {row_filler(stage, place, fill)};
  out.push_back(cold_distance(stage, place, ours_cold));
  add_peer_distances(stage, place, out);
  for (std::size_t i = 1; i < out.size(); ++i) out[i].timed = false;
  return out;
}

std::vector<Contender> near_rows(const Stage& stage, Place place) {
  return rows_by(stage, place,
                 [](const Body& a, const Body& b, const Transform& X_BA, std::span<NearPair> out) {
                   return near_pairs(a, b, X_BA, reach, out).count;
                 });
}

/// What is in use of the heap, bytes.
double heap_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

Contender builder(const std::string& library, std::size_t triangles,
                  const std::function<std::shared_ptr<void>()>& build) {
  const auto ask = [build](std::size_t) {
    Answer answer;
    answer.built = build();
    return answer;
  };
  const auto examine = [ask, triangles](std::size_t i) {
    const double before = heap_bytes();
    Answer answer = ask(i);
    answer.amount = (heap_bytes() - before) / static_cast<double>(triangles);
    answer.built.reset();
    return answer;
  };
  return {library, ask, 0, examine, true, true};
}

std::vector<Contender> building(const Stage& stage, Place /*place*/) {
  const std::size_t triangles = stage.soup_a.triangles.size();
  std::vector<Contender> out;
  out.push_back(builder(ours, triangles, [s = &stage]() -> std::shared_ptr<void> {
    return std::const_pointer_cast<Body>(make_body(s->polygons_a, Model::automatic, "built"));
  }));
  for (const PeerLibrary& library : stage.libraries)
    out.push_back(builder(library.name, triangles,
                          [s = &stage, l = &library] { return l->build(s->soup_a); }));
  return out;
}

}  // namespace

Verdict judge_answers(const Stage& /*stage*/, Place place, std::size_t /*pose*/, const Answer& ours,
                      const Contender& contender, const Answer& theirs) {
  return judge(ours, theirs, from_touching(place), contender.touch_doubtful_within);
}

std::vector<Query> queries() {
  using P = Place;
  return {
      {"touch",
       {P::far, P::near_5, P::near_1, P::touching, P::shallow, P::deep, P::trajectory},
       {ours_by_the_face, "FCL", "Bullet"},
       touch,
       ""},
      {"distance",
       {P::far, P::near_5, P::near_1, P::touching},
       {ours_by_the_face, "FCL"},
       distance_cold,
       ""},
      {"distance-warm", {P::trajectory}, {ours_cold, "FCL"}, distance_warm, ""},
      {"near-pairs", {P::near_1, P::touching, P::trajectory}, {}, near_rows, "rows"},
      {"sweep", {P::trip}, {"FCL", "FCL oriented"}, sweep_contenders, "", judge_sweep},
      {"build", {P::none}, {"FCL", "Bullet"}, building, "bytes per triangle"},
  };
}

}  // namespace sonde::bench
