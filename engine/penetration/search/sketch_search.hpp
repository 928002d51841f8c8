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

/// The end of descents on the sketches.
struct SketchEnd {
  Vec6 y;
  double depth = 0;  ///< |y|, m
  int starts = 1;    ///< number of far starts that ended there
  double from = 0;   ///< |y| where the first of them began, m
  /// The depth that a descent of the bodies from here reached, m; the caller sets it. Negative:
  /// there was none.
  double came_to = -1;
};

/// The goal and limits of a search on sketches.
struct SketchGoal {
  Method method = Method::pdg;
  std::uint64_t seed = 1;
  Deadline deadline = {};
  /// Axes of the random displacements: those of the fixed body make the search independent of the
  /// orientation of the world frame.
  Mat3 axes = Mat3::Identity();
  /// m: the search gives up descents that would end above this.
  double beat = std::numeric_limits<double>::infinity();
};

/// Searches for the poses nearest to the origin at which the sketches are apart, from random
/// starts, with one descent at a time in each thread lane. The results do not depend on the number
/// of threads, except for the deadline, nor on whether the starts are made in one call or several.
class SketchSearch {
 public:
  SketchSearch(const Chart& chart, const SketchGoal& goal, std::span<SketchDescent> lanes,
               ThreadPair& threads, const SearchTuning& tuning = search_tuning);

  /// Makes more starts, a round at a time, until `most` are made or is_clear(agreeing).
  void make_starts(int most, int agreeing = std::numeric_limits<int>::max());

  std::vector<SketchEnd>& ends() { return ends_; }  ///< sorted by depth, each optimum once
  /// `agreeing` starts about as far away as the best depth have ended at the least depth, to 2 %.
  bool is_clear(int agreeing) const;
  int made() const { return made_; }  ///< number of starts

 private:
  double best() const;
  void round();
  std::optional<SketchEnd> start(int number, SketchDescent& descent) const;
  std::optional<SketchEnd> start_about(const Vec6& center, double ball, Random& random,
                                       SketchDescent& descent) const;
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
  double nearest_free_ = std::numeric_limits<double>::infinity();  // m, |y| of the nearest start
};

}  // namespace sonde
