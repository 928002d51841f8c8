// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/pace.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {

Vec6 shortened(const Vec6& step, double longest) {
  const double size = step.norm();
  return size > longest ? Vec6(step * (longest / size)) : step;
}

Vec6 Pace::damped(const Vec6& step) noexcept {
  const double size = step.norm();
  if (!(step.dot(last) < descent_tuning.turns_back * size * last.norm())) {
    returns = 0;
    damped_to *= descent_tuning.longest_growth;
  } else if (went > 0 && ++returns <= descent_tuning.most_secants) {
    const Vec6 way = last / last.norm();
    damped_to = size * went / (std::max(0.0, wanted.dot(way)) - step.dot(way));
  } else {
    damped_to = 0.5 * std::min({damped_to, size, last.norm()});
  }
  wanted = step;
  return shortened(step, damped_to);
}

double Pace::to_ceiling(const Vec6& y, const Vec6& step) const noexcept {
  const double size2 = step.squaredNorm(), along = y.dot(step) / size2;
  const double room = (ceiling * ceiling - y.squaredNorm()) / size2;
  return std::sqrt(std::max(0.0, along * along + room)) - along;
}

std::optional<Vec6> Pace::extrapolated(const Vec6& y, const Vec6& step, double most) noexcept {
  const double size = step.norm();
  const auto continues = [&](const Vec6& before) {
    return step.dot(before) > descent_tuning.same_way * size * before.norm();
  };
  // The step after an extrapolated one returns to the obstacle. Backwards: the sum was too long.
  if (extrapolates) {
    if (!(step.dot(last) > 0)) end_series();
    return std::nullopt;
  }
  if (continues(last)) {
    const double before = std::exchange(ratio, size / last.norm());
    in_series = std::abs(ratio - before) < descent_tuning.same_ratio;
    steady = step;
  } else if (!continues(steady)) {
    end_series();
  }
  const double along = y.dot(step) / (size * size);
  // Not one that regains gaps, nor a damped one.
  if (!in_series || along > -0.5 || step != wanted) return std::nullopt;
  const double factor = std::min({1 / std::abs(1 - ratio), to_ceiling(y, step), most});
  if (!(factor > descent_tuning.least_extrapolation) || !std::isfinite(factor)) return std::nullopt;
  return factor * step;
}

void Pace::learn(const Vec6& step, const Sweep& swept, double worth_while, double radius) noexcept {
  const double moved = swept.free_until * step.norm();
  last = step;
  went = moved;
  // A path that was too long to sweep says nothing about progress: the next one is shorter.
  stalled = moved > worth_while ? 0 : stalled + !swept.given_up;
  scale = std::max(moved, 0.1 * scale);
  const bool cut_short = swept.hit && !swept.given_up && swept.free_until < 0.5;
  bending =
      cut_short
          ? std::min(descent_tuning.bending_growth * bending, descent_tuning.most_bending / radius)
          : std::max(descent_tuning.bending_decay * bending, descent_tuning.least_bending / radius);
}

}  // namespace sonde
