// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/search_worker.hpp"
#include "engine/penetration/search/sketch_search.hpp"

namespace sonde {

/// What a start is made for.
struct Aim {
  Method method = Method::pdg;
  double beat = 0;                     ///< m: the best depth so far; infinite: there is none
  int steps = 0;                       ///< that it may take
  const LocalOptima* known = nullptr;  ///< where it is not worth while to come down again
};

/// The kinds of starts of a search, each made and descended in one of two lanes. The `starts` of a
/// result says whether the descent was independent of earlier results.
class Starts {
 public:
  Starts(const Pair& pair, const Chart& chart, const Deadline& before,
         const SearchTuning& tuning = search_tuning);

  SearchWorker& lane(std::size_t k) { return lanes_[k]; }
  /// One for each lane; empty where the pair has no sketches.
  std::vector<SketchDescent>& sketched() { return sketched_; }
  const std::vector<SketchDescent>& sketched() const { return sketched_; }
  int limited() const;
  /// From now on the lanes keep the times of their phases.
  void time_phases() noexcept;
  PhaseTimes phases() const;  ///< of both lanes; all 0 unless they are kept

  /// From the nearest free pose: random poses of ever larger balls, `tries` in each. This finds a
  /// way out close by, even in a tangle that no start from outside gets into.
  LocalOptimum near(Random random, int tries, const Aim& aim, std::size_t lane);
  /// From a pose where the sketches are apart, or near it.
  LocalOptimum sketched(const SketchEnd& end, const Aim& aim, std::size_t lane);
  /// The same at once: from the first free pose straight out through that end, with no look at what
  /// would be nearer. For a search whose time is over.
  LocalOptimum beyond(const SketchEnd& end, const Aim& aim, std::size_t lane);
  /// Out of the overlap at y, pushed apart by the triangles that meet there, and then down.
  LocalOptimum pushed(const Vec6& y, const Aim& aim, std::size_t lane);
  /// From a random overlap within `radius`, m.
  LocalOptimum pushed_within(double radius, Random& random, const Aim& aim, std::size_t lane);
  /// y of an overlap in which a principal axis of the probe lies along one of the fixed body, and
  /// both centres of mass on one line along it; the spin about it and the place on it are random.
  /// No further than `farthest`, m; none where few are.
  std::optional<Vec6> along_axes(Random& random, double farthest) const;
  /// From a random free pose of a ball of `width` times the best depth, or of a larger one.
  LocalOptimum far(double width, Random random, const Aim& aim, std::size_t lane);
  /// From a random free pose about an end: where there are many ends, the better ones lie together.
  LocalOptimum about(const Vec6& end, Random random, const Aim& aim, std::size_t lane);
  /// The k-th start of a round of random starts. Most start near the best ends, because where there
  /// are many, the better ones lie together. Others start from a random free pose of a ball
  /// somewhat larger than the best depth so far; every other turn, where there is an inside to come
  /// out of, they start from an overlap instead.
  static constexpr std::size_t per_round = 8;
  LocalOptimum random(std::size_t turn, std::size_t k, const std::vector<Vec6>& ends, Random random,
                      const Aim& aim, std::size_t lane);
  /// From outside to contact by translation, along the line of the middles (k 0 and 1) and along
  /// the fixed body's axes (up to 7). This always finds a free pose.
  LocalOptimum outside(std::size_t k, const Aim& aim, std::size_t lane);

 private:
  SearchWorker::Limits limits(const Aim& aim, double beat) const {
    return {aim.steps, beat, before_};
  }
  SearchWorker::Limits limits(const Aim& aim) const { return limits(aim, aim.beat); }
  std::optional<Vec6> first_free_beyond(const Vec6& end, Method method, std::size_t lane) const;
  std::optional<Vec6> freed(const Vec6& end, Method method, std::size_t lane);
  std::optional<Vec6> free_sample(Random& random, const Vec6& center, double radius, int tries,
                                  Method method, std::size_t lane);

  const Body& probe_;
  const Body& fixed_;
  const Chart& chart_;
  Deadline before_;
  const SearchTuning& tuned_;
  std::array<PhaseTimes, 2> times_;  // of each lane
  std::array<SearchWorker, 2> lanes_;
  std::vector<SketchDescent> sketched_;
};

}  // namespace sonde
