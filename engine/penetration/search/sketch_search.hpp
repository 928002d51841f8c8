// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/deadline.hpp"
#include "engine/base/thread_pair.hpp"
#include "engine/penetration/descent/sketch_descent.hpp"

namespace sonde {

/// Where descents on the sketches ended.
struct SketchEnd {
  Vec6 y;
  double depth = 0;  ///< |y|, m
  int starts = 1;    ///< how many came there
  double from = 0;   ///< |y| of where the first began, m
};

struct SketchSearch {
  Method method = Method::pdg;
  int fewest = 32;  ///< starts
  int most = 96;    ///< until as many as a quarter of the fewest have ended at the same depth
  std::uint64_t seed = 1;
  Deadline deadline = {};
  /// Along which random displacements are drawn: those of the fixed body, where the search is not
  /// to depend on how the world is turned.
  Mat3 axes = Mat3::Identity();
};

/// Looks for the places nearest to the origin at which the sketches are apart, from random starts,
/// one descent for each lane of the threads at a time. The nearest first, each once. The same on
/// any number of threads, but for the deadline.
std::vector<SketchEnd> search_sketches(const Chart& chart, const SketchSearch& search,
                                       std::span<SketchDescent> lanes, ThreadPair& threads);

}  // namespace sonde
