// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/search/search_tuning.hpp"

namespace sonde {

/// The end of a descent of a search.
struct LocalOptimum {
  Vec6 y = Vec6::Zero();
  double depth = std::numeric_limits<double>::infinity();  ///< |y|, m; infinite: none was found
  int iterations = 0;                                      ///< iterations of the descent
  int starts = 1;  ///< starts that led there independently of earlier results, which confirm it
};

/// The local optima found so far, and how many starts agree on the best of them.
class LocalOptima {
 public:
  /// `same`, a share of the depth: depths that differ by less count as equal, and end poses no
  /// further apart count as one local optimum.
  explicit LocalOptima(double same = search_tuning.same) : same_(same) {}

  void add(const LocalOptimum& place);

  bool empty() const { return optima_.empty(); }
  double best() const { return best_; }  ///< m; infinite if there is none
  /// Number of independent starts that ended at the best depth.
  int agreeing() const;
  bool is_best(double depth) const { return depth < (1 + same_) * best_; }
  /// Whether y is so near the best local optimum (within `share` times its depth) that a descent
  /// from y probably ends there.
  bool is_known(const Vec6& y, double share) const;
  /// The `count` nearest local optima, the best first, no two of them close together.
  std::vector<Vec6> nearest(std::size_t count) const;

 private:
  double same_;
  std::vector<LocalOptimum> optima_;  // the nearest first
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace sonde
