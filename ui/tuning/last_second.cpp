// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/last_second.hpp"

#include <cmath>
#include <vector>

namespace sonde::ui {
namespace {

constexpr double span = 1;           // s
constexpr double nearly = 0.9;       // of it: the oldest tick is just out of it
constexpr double longest_gap = 0.1;  // s: a pause

}  // namespace

void LastSecond::take(const MassProperties& probe) {
  length_ = std::sqrt(probe.inertia.maxCoeff());
  com_ = probe.com;
  ticks_.clear();
}

void LastSecond::add(const Snapshot& tick) {
  if (!ticks_.empty()) {
    const double since = tick.time - ticks_.back().time;
    if (since <= 0 || since > longest_gap) ticks_.clear();
  }
  const Pose& X_FM = tick.separation.device;
  const auto& device = tick.hand.device;
  capped_ = tick.hand.capped;
  waiting_ = tick.hand.waiting;
  rendered_ = tick.hand.gains;
  device_ = device && device->force ? device : std::nullopt;
  ticks_.push_back({tick.time, {X_FM.q, X_FM * com_}, tick.wrench, tick.hand.energy.given});
  while (ticks_.front().time < tick.time - span) ticks_.pop_front();
}

std::optional<Buzz> LastSecond::buzz() const {
  if (ticks_.size() < 2) return {};
  const double lasted = ticks_.back().time - ticks_.front().time;
  if (lasted < nearly * span) return {};
  Buzz out{.loop = device_.has_value(),
           .chatter = {},
           .energy = ticks_.back().given - ticks_.front().given,
           .capped = capped_,
           .waiting = waiting_,
           .rendered = rendered_};
  if (!out.loop) return out;
  std::vector<FeltTick> felt;
  felt.reserve(ticks_.size());
  for (const Tick& tick : ticks_)
    felt.push_back(felt_tick({.X_WD = tick.com}, tick.wrench, ticks_.front().com));
  const double sample_time = lasted / static_cast<double>(ticks_.size() - 1);
  out.chatter = chatter(felt, sample_time, felt_handle(*device_, sample_time), length_);
  return out;
}

std::vector<double> LastSecond::forces(double seconds) const {
  std::vector<double> out;
  for (const Tick& tick : ticks_)
    if (tick.time >= ticks_.back().time - seconds) out.push_back(tick.wrench.force.norm());
  return out;
}

}  // namespace sonde::ui
