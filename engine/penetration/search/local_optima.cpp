// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/local_optima.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {

void LocalOptima::add(const LocalOptimum& place) {
  if (!std::isfinite(place.depth)) return;
  best_ = std::min(best_, place.depth);
  const auto later = std::ranges::upper_bound(optima_, place.depth, {}, &LocalOptimum::depth);
  optima_.insert(later, place);
}

int LocalOptima::agreeing() const {
  int starts = 0;
  for (const LocalOptimum& place : optima_)
    if (is_best(place.depth)) starts += place.starts;
  return starts;
}

bool LocalOptima::is_known(const Vec6& y, double share) const {
  return !empty() && (y - optima_.front().y).norm() < share * best_;
}

std::vector<Vec6> LocalOptima::nearest(std::size_t count) const {
  std::vector<Vec6> out;
  for (const LocalOptimum& place : optima_) {
    if (out.size() == count) break;
    const auto is_here = [&](const Vec6& y) { return (y - place.y).norm() < same_ * place.depth; };
    if (std::ranges::none_of(out, is_here)) out.push_back(place.y);
  }
  return out;
}

}  // namespace sonde
