// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/change_rate.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr double whole_force = 1;  // s: least time for the whole of a device's force

double at_probe(double rate, double most, double ratio) {
  if (!(rate > 0)) return 0;
  return (most > 0 ? std::min(rate, most / whole_force) : rate) / (ratio > 0 ? ratio : 1);
}

double share(double change, double rate, double step) {
  return rate > 0 && change > 0 ? rate * step / change : 1;
}

}  // namespace

ChangeRate change_rate_at_probe(const ChangeRate& of_hand, double max_force, double max_torque,
                                double ratio, double turn_ratio) noexcept {
  return {at_probe(of_hand.force, max_force, ratio),
          at_probe(of_hand.torque, max_torque, turn_ratio)};
}

double share_of_change(const Wrench& change, const ChangeRate& rate, double step) noexcept {
  return std::min({1.0, share(change.force.norm(), rate.force, step),
                   share(change.torque.norm(), rate.torque, step)});
}

}  // namespace sonde
