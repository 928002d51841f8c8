// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/chart_rim.hpp"

#include <algorithm>
#include <cmath>

#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {
namespace {

/// The fraction of the straight line from one turn to another, both as v, where |v| is `limit`.
double part_to_rim(const Vec3& from, const Vec3& to, double limit) {
  const Vec3 along = to - from;
  const double a = along.squaredNorm(), b = from.dot(along);
  const double c = from.squaredNorm() - limit * limit;
  return a > 0 ? (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a : 0;
}

}  // namespace

Vec6 within_chart(const Chart& chart, const Vec6& y, const Vec6& step) {
  const double turn = chart.v(step).norm();
  Vec6 bounded = std::min(1.0, descent_tuning.largest_turn / std::max(turn, 1e-30)) * step;
  Vec6 target = y + bounded;
  const Vec3 from = chart.v(y), to = chart.v(target);
  const double limit = std::max(Chart::largest_v, from.norm());
  if (to.norm() <= limit) return bounded;
  const double part = part_to_rim(from, to, limit);
  if (part > descent_tuning.least_way_to_rim) return part * bounded;
  target.head<3>() *= limit / to.norm();
  return target - y;
}

bool at_rim(const Chart& chart, const Vec6& y) {
  return chart.v(y).norm() > (1 - 1e-6) * Chart::largest_v;
}

}  // namespace sonde
