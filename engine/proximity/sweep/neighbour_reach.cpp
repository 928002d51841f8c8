// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/neighbour_reach.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {
namespace {

/// Share of the probe's radius: for longer paths no list is made, since traversing the trees is
/// quicker. (The p99.9 of a tick in contact on fandisk-diplodocus and on terrain was 1497 and 5222
/// µs with 0.02, 1067 and 4074 µs with 0.04, 1247 and 7505 µs with 0.07; the other scenes did not
/// change.)
constexpr double farthest_listed = 0.04;
/// Shorter paths always get a list: in flat contact the trees do not help with them.
constexpr double nearest_listed = 0.001;
/// Factor on the reach wanted: a list of less reach would not outlast the step that it is made for.
constexpr double least_ample = 1.5;
constexpr double most_ample = 32;
/// From one list to the next.
constexpr double growth = 1.2;

/// A slightly larger reach may contain ten times as many pairs. A list that takes more than
/// `dearest` times the work of the cheapest recent list is abandoned, unless its work is below
/// `cheap_enough`, some 80 µs.
constexpr double dearest = 1.6, cheap_enough = 8000;

/// The cost of a list. One expensive list disturbs a tick more than many cheap ones, so the power
/// of the work is above 1. (In units of work, the p99 of a tick with the powers 1.5 and 2:
/// nut-on-bolt 1933, 1844; peg-in-hole 521, 475; linked-tori 340, 312; the medians are alike.)
double cost(std::int64_t work, double travel) {
  const auto w = static_cast<double>(work);
  return w * w / travel;
}

}  // namespace

NeighbourReach::NeighbourReach(double radius)
    : radius_(radius),
      limit_(radius),
      reach_(0),
      too_far_(farthest_listed * radius),
      factor_(growth) {}

bool NeighbourReach::is_too_far(double wanted) noexcept {
  if (wanted < too_far_) return false;
  too_far_ *= 1.01;
  return true;
}

double NeighbourReach::least(double wanted) noexcept { return least_ample * wanted; }

std::int64_t NeighbourReach::most_work() const noexcept {
  return static_cast<std::int64_t>(std::max(dearest * cheapest_, cheap_enough));
}

double NeighbourReach::choose(double wanted) const noexcept {
  return std::max(least_ample * wanted, std::min({most_ample * wanted, limit_, reach_}));
}

void NeighbourReach::learn(double wanted, double chosen, bool fits, std::int64_t work,
                           std::int64_t affordable) noexcept {
  // Where surfaces lie close over a wide area, the list overflows; the next one has a smaller
  // reach.
  if (!fits) {
    limit_ = 2 * wanted;
    reach_ = 0.5 * chosen;
    cost_ = 0;
    if (chosen < 2 * wanted) too_far_ = std::max(0.7 * wanted, nearest_listed * radius_);
    return;
  }
  limit_ = std::min(1.5 * limit_, radius_);
  too_far_ = std::min(1.02 * too_far_, farthest_listed * radius_);
  const auto took = static_cast<double>(work);
  // A list of the least reach cannot become cheaper.
  cheapest_ = chosen <= least(wanted) ? took : std::min(took, 1.1 * cheapest_);
  const double last = cost_;
  cost_ = cost(work, chosen - wanted);
  if (work > affordable || chosen >= most_ample * wanted)
    factor_ = 1 / growth;
  else if (chosen <= least(wanted))
    factor_ = growth;
  else if (chosen == reach_ && last > 0 && cost_ > last)
    factor_ = 1 / factor_;
  reach_ = std::max(least_ample * wanted, std::min(factor_ * chosen, radius_));
}

}  // namespace sonde
