// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/reached_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/quantile.hpp"

namespace sonde::ui {
namespace {

constexpr double nine_in_ten = 0.9;

double too_deep(double residual) {
  const double r = std::clamp(residual, 0.0, 1.0);
  return r * r / (1 + std::sqrt(1 - r * r));
}

}  // namespace

void ReachedAccuracy::add(const Snapshot& tick) {
  const Separation& s = tick.separation;
  if (tick.paused || s.status != Status::penetrating) return;
  if (!ticks_.empty() && tick.time < ticks_.back().time) clear();
  if (!ticks_.empty() && tick.time == ticks_.back().time) return;
  ticks_.push_back({tick.time, too_deep(tick.hand.rows.residual), tick.hand.rows.refresh_us,
                    tick.tick_us, s.converged, tick.hand.rows.phases});
  ticks_.back().phases[Phase::couple] = tick.tick_us;
  if (ticks_.size() > most) ticks_.pop_front();
}

std::optional<Reached> ReachedAccuracy::reached() const {
  if (ticks_.size() < least) return {};
  const auto most_of = [this](double Tick::*figure) {
    std::vector<double> all;
    for (const Tick& tick : ticks_) all.push_back(tick.*figure);
    std::ranges::sort(all);
    return quantile(all, nine_in_ten);
  };
  const auto converged = std::ranges::count_if(ticks_, &Tick::converged);
  PhaseTimes mean;
  for (const Tick& tick : ticks_) mean += tick.phases;
  for (double& time : mean.us) time /= double(ticks_.size());
  return Reached{most_of(&Tick::within), most_of(&Tick::rows_us), most_of(&Tick::tick_us),
                 double(converged) / double(ticks_.size()), mean};
}

}  // namespace sonde::ui
