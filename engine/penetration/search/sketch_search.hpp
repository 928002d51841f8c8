// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/deadline.hpp"
#include "engine/base/thread_pair.hpp"
#include "engine/geometry/random.hpp"
#include "engine/penetration/descent/sketch_descent.hpp"
#include "engine/penetration/search/search_tuning.hpp"

namespace sonde {

/// Where descents on the sketches ended.
struct SketchEnd {
  Vec6 y;
  double depth = 0;  ///< |y|, m
  int starts = 1;    ///< number of starts that ended there
  double from = 0;   ///< |y| where the first of them began, m
  /// The depth that a descent of the bodies from here reached, m; the caller sets it. Negative:
  /// there was none.
  double came_to = -1;
};

/// What a search on sketches looks for.
struct SketchGoal {
  Method method = Method::pdg;
  std::uint64_t seed = 1;
  Deadline deadline = {};
  /// Axes of the random displacements: those of the fixed body make the search independent of how
  /// the world is turned.
  Mat3 axes = Mat3::Identity();
  /// m: the search gives up descents that would end above this.
  double beat = std::numeric_limits<double>::infinity();
};

/// Looks for the places nearest to the origin at which the sketches are apart, from random starts,
/// one descent for each lane of the threads at a time. The same on any number of threads, but for
/// the deadline; and the same whether it is made at once or goes on.
class SketchSearch {
 public:
  SketchSearch(const Chart& chart, const SketchGoal& goal, std::span<SketchDescent> lanes,
               ThreadPair& threads, const SearchTuning& tuning = search_tuning);

  /// More of them, until `most` are made, or `fewest` and it is clear what is the least depth.
  void make_starts(int fewest, int most, int agreeing);

  std::vector<SketchEnd>& ends() { return ends_; }  ///< the nearest first, each once
  /// As many starts as `agreeing` have ended at the least depth, to 2 %, each by itself; or some,
  /// where no other end is near it.
  bool is_clear(int agreeing) const;
  int made() const { return made_; }  ///< starts

 private:
  using Balls = SearchTuning::Balls;
  double best() const;
  void round();
  std::optional<SketchEnd> start(int number, SketchDescent& descent) const;
  std::optional<SketchEnd> start_about(const Vec6& center, double ball, const Balls& balls,
                                       Random& random, SketchDescent& descent) const;
  std::optional<SketchEnd> descend(const Vec6& y, SketchDescent& descent) const;
  Vec6 sample(Random& random, double ball) const;
  Random stream(std::uint64_t number) const;
  void add(const SketchEnd& end);

  const Chart& chart_;
  SketchGoal goal_;
  std::span<SketchDescent> lanes_;
  ThreadPair& threads_;
  const SearchTuning& tuned_;
  std::vector<SketchEnd> ends_;
  int made_ = 0;
  double nearest_free_ = std::numeric_limits<double>::infinity();  // m, where a start began
};

}  // namespace sonde
