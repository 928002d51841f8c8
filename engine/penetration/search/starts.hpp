// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/search_worker.hpp"
#include "engine/penetration/search/sketch_search.hpp"

namespace sonde {

/// The goal and limits of one start.
struct Aim {
  Method method = Method::pdg;
  double beat = 0;                     ///< m: the best depth so far; infinite if there is none
  int steps = 0;                       ///< steps that it may take
  const LocalOptima* known = nullptr;  ///< optima that need not be reached again
};

/// An overlap to push apart, in which the bodies may fit into each other.
struct Fit {
  Vec6 y = Vec6::Zero();
  double overlap = 0;  ///< m: how deep sketch points lie in the other body; 0 without sketches
};

/// Makes the starts of a search, of several kinds, and descends from each of them. Every call runs
/// in one of two lanes, the workspaces of two threads. In a result, `starts` is 1 if the descent
/// was independent of earlier results, otherwise 0.
class Starts {
 public:
  Starts(const Pair& pair, const Chart& chart, const Deadline& before,
         const SearchTuning& tuning = search_tuning);

  SearchWorker& lane(std::size_t k) { return lanes_[k]; }
  /// One for each lane; empty if the pair has no sketches.
  std::vector<SketchDescent>& sketch_descents() { return sketch_descents_; }
  const std::vector<SketchDescent>& sketch_descents() const { return sketch_descents_; }
  int limited() const;
  /// From now on the lanes record their phase times.
  void time_phases() noexcept;
  PhaseTimes phases() const;  ///< sum of both lanes; 0 unless recorded

  /// Descends from the nearest free pose, found among random poses in growing balls.
  /// This finds short separating motions, even in a tangle that no start from outside enters.
  LocalOptimum descend_from_nearest_free(Random random, const Aim& aim, std::size_t lane);
  /// Descends from a pose at which the sketches are apart, or from a free pose near it.
  LocalOptimum descend_from_sketch_end(const SketchEnd& end, const Aim& aim, std::size_t lane);
  /// As descend_from_sketch_end(), but from the first free pose on the straight line beyond that
  /// end, without a search for a nearer one. For a search whose time is over.
  LocalOptimum descend_beyond_sketch_end(const SketchEnd& end, const Aim& aim, std::size_t lane);
  /// Pushes the overlap at y apart by its intersecting triangles, and descends from there.
  LocalOptimum push_apart_and_descend(const Vec6& y, const Aim& aim, std::size_t lane);
  /// As push_apart_and_descend(), from a random overlap within `radius`, m.
  LocalOptimum push_apart_within(double radius, Random& random, const Aim& aim, std::size_t lane);
  /// The same from a translation: of some random ones within `radius`, m, that at which the
  /// sketches overlap least. If there is a cavity, most of these lie in it or beside it: elsewhere
  /// within the best depth there is no room. Requires sketches.
  LocalOptimum push_least_overlap_apart(double radius, Random& random, const Aim& aim,
                                        std::size_t lane);
  /// An overlap in which a principal axis of the probe lies along one of the fixed body, and
  /// both centres of mass on one line along it, as in parts that are made to fit. The position
  /// along the axis is random. So is the spin about it if there are no sketches. Otherwise the spin
  /// and the position across the axis are those of the least overlap of the sketches: in a fit
  /// finer than their cells, the bodies can hardly be pushed apart from any other, and the centre
  /// of a hole is not the centre of mass of the body round it. Within `farthest`, m; no value if
  /// such poses are rare.
  std::optional<Fit> fitted(Random& random, double farthest, std::size_t lane);
  /// Descends from a random free pose in a ball of about the best depth, or in a larger one.
  LocalOptimum descend_from_ball(Random random, const Aim& aim, std::size_t lane);
  /// Descends from a random free pose near an end: if there are many ends, the better ones lie
  /// together.
  LocalOptimum descend_near_end(const Vec6& end, Random random, const Aim& aim, std::size_t lane);
  /// The k-th start of a round of random starts. Most start near the best ends, because where there
  /// are many, the better ones lie together. Of the others, in a search for PD_g with sketches, two
  /// start from a fitted() overlap. The rest start from a random free pose in a ball of 0.75 to 1.5
  /// times the best depth so far, or in a larger one; if both bodies are solids, in every other
  /// round (`turn`) from a random overlap.
  static constexpr std::size_t per_round = 8;
  LocalOptimum descend_in_round(std::size_t turn, std::size_t k, const std::vector<Vec6>& ends,
                                Random random, const Aim& aim, std::size_t lane);
  /// Moves from outside into contact by translation, along the line of the centres (k 0 and 1) and
  /// along the fixed body's axes (up to 7), and descends. This always finds a free pose.
  LocalOptimum descend_from_outside(std::size_t k, const Aim& aim, std::size_t lane);

 private:
  SearchWorker::Limits limits(const Aim& aim, double beat) const {
    return {aim.steps, beat, before_};
  }
  SearchWorker::Limits limits(const Aim& aim) const { return limits(aim, aim.beat); }
  /// A pose at which the sketches overlap little, among those that `placed` returns for a spin
  /// about an axis and two shifts across it (each in m; the spin as the displacement of a point at
  /// the probe's radius). It is the best spin without a shift, improved one coordinate at a time,
  /// with steps down to half a cell of the sketches. `placed` returns no value for a pose that is
  /// too far away.
  std::optional<Fit> least_overlap(const std::function<std::optional<Vec6>(const Vec3&)>& placed,
                                   std::size_t lane);
  std::optional<Vec6> first_free_beyond(const Vec6& end, Method method, std::size_t lane) const;
  std::optional<Vec6> freed(const Vec6& end, Method method, std::size_t lane);
  std::optional<Vec6> free_sample(Random& random, const Vec6& center, double radius, Method method,
                                  std::size_t lane);

  const Body& probe_;
  const Body& fixed_;
  const Chart& chart_;
  Deadline before_;
  const SearchTuning& tuned_;
  std::array<PhaseTimes, 2> times_;  // of each lane
  std::array<SearchWorker, 2> lanes_;
  std::vector<SketchDescent> sketch_descents_;
};

}  // namespace sonde
