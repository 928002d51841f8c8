// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/lines.hpp"

namespace sonde {

/// Calls `use` for the hits of a line at one place, which make one step of the winding number.
template <class Use>
void each_step(std::span<const LineHit> hits, double rounding, Use use) {
  int winding = 0;
  for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
    int next = winding;
    for (j = i; j < hits.size() && hits[j].along - hits[i].along <= rounding; ++j)
      next -= hits[j].sign;
    use(hits.subspan(i, j - i), winding, next);
    winding = next;
  }
}

/// Calls use(from, to, missing) where a line's winding number is neither 0 nor 1; missing: how much
/// it is less than the number of times that the place counts.
template <class Use>
void each_missing(std::span<const LineHit> hits, double rounding, Use use) {
  int total = 0;
  for (const LineHit& hit : hits) total += hit.sign;
  if (total != 0) return;
  int missing = 0;
  double from = 0;
  each_step(hits, rounding, [&](std::span<const LineHit> at, int, int after) {
    if (missing != 0) use(from, at[0].along, missing);
    missing = (after != 0) - after;
    from = at.back().along;
  });
}

/// What the lines of three directions found, a third each, and how much of it each of them did.
struct LineSums {
  MassMoments sum;
  std::array<double, 3> of = {};

  /// Adds a piece of a line of direction k.
  void add(const Lines& lines, int k, std::size_t line, double from, double to, int missing) {
    const Vec3 way = line_frame(k).row(2).transpose();
    const double section = lines.pixel() * lines.pixel() / 3, length = to - from;
    const Vec3 middle = lines.point(line, from + length / 2) - sum.origin;
    const double m = missing * section * length;
    sum.measure += m;
    sum.first += m * middle;
    sum.second += m * (middle * middle.transpose() + length * length / 12 * way * way.transpose());
    of[static_cast<std::size_t>(k)] += m;
  }
};

/// How far the finer of two sums may be off: twice as far as the coarser one is from it, or as the
/// lines of any one direction are. The sums are as good as random where edges are thinner than the
/// lines lie apart, so either may agree by chance; the mean of three directions is off by more than
/// twice the furthest of them about once in thousands.
inline double error_of(const LineSums& coarse, const LineSums& fine) {
  double furthest = std::abs(fine.sum.measure - coarse.sum.measure);
  for (const double own : fine.of)
    furthest = std::max(furthest, std::abs(3 * own - fine.sum.measure));
  return 2 * furthest;
}

}  // namespace sonde
