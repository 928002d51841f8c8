// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/last_second.hpp"

#include <cmath>
#include <vector>

#include "engine/study/stability/chatter.hpp"

namespace sonde::ui {
namespace {

constexpr double span = 1;           // s
constexpr double nearly = 0.9;       // of it: the oldest tick is just out of it
constexpr double longest_gap = 0.1;  // s: a pause

}  // namespace

void LastSecond::take(const MassProperties& probe) {
  length_ = std::sqrt(probe.inertia.maxCoeff());
  ticks_.clear();
}

void LastSecond::add(const Snapshot& tick) {
  if (!ticks_.empty()) {
    const double since = tick.time - ticks_.back().time;
    if (since <= 0 || since > longest_gap) ticks_.clear();
  }
  Tick& last = ticks_.emplace_back();
  last.time = tick.time;
  last.wrench << tick.wrench.force, tick.wrench.torque;
  last.given = tick.hand.energy.given;
  while (ticks_.front().time < tick.time - span) ticks_.pop_front();
}

std::optional<Buzz> LastSecond::buzz() const {
  if (ticks_.size() < 2) return {};
  const double lasted = ticks_.back().time - ticks_.front().time;
  if (lasted < nearly * span) return {};
  std::vector<Vec6> wrenches;
  wrenches.reserve(ticks_.size());
  for (const Tick& tick : ticks_) wrenches.push_back(tick.wrench);
  const double sample_time = lasted / static_cast<double>(ticks_.size() - 1);
  return Buzz{chatter_index(wrenches, sample_time, length_),
              ticks_.back().given - ticks_.front().given};
}

std::vector<double> LastSecond::forces(double seconds) const {
  std::vector<double> out;
  for (const Tick& tick : ticks_)
    if (tick.time >= ticks_.back().time - seconds) out.push_back(tick.wrench.head<3>().norm());
  return out;
}

}  // namespace sonde::ui
