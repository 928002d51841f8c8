// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/pulse_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace sonde {
namespace {

constexpr int pulses_an_axis = 16;
constexpr double least_share = 0.4;  // of the largest amplitude
constexpr std::array<double, 4> signs{1, -1, -1, 1};
constexpr double rest_time = 0.25;                      // s, for the handle to stop
constexpr std::size_t least_part = 8, most_part = 200;  // samples

struct KindOfAxis {
  double amplitude, inertia, travel;
};

/// The largest excursion of a pulse without friction is amplitude · part² / inertia.
std::size_t part_of(const KindOfAxis& kind, double sample_time) {
  const double time = std::sqrt(kind.travel * kind.inertia / kind.amplitude);
  const double samples = std::clamp(time / sample_time, double(least_part), double(most_part));
  return static_cast<std::size_t>(std::llround(samples));
}

void add_pulses(PulsePlan& plan, std::size_t axis, const KindOfAxis& kind) {
  const std::size_t part = part_of(kind, plan.sample_time);
  for (int i = 0; i < pulses_an_axis; ++i) {
    const double share = least_share + (1 - least_share) * i / (pulses_an_axis - 1);
    const double sign = signs[static_cast<std::size_t>(i) % signs.size()];
    plan.pulses.push_back({axis, sign * share * kind.amplitude, part});
  }
}

void set(Wrench& wrench, std::size_t axis, double amount) {
  (axis < 3 ? wrench.force : wrench.torque)[static_cast<Eigen::Index>(axis % 3)] = amount;
}

}  // namespace

PulseLimits most_allowed(const DeviceProfile& device) {
  constexpr double most_travel = 0.02, most_turn = 0.5;  // m, rad
  return {.force = device.max_force.value / 2,
          .torque = device.max_torque.value / 2,
          .travel = most_travel,
          .turn = most_turn};
}

PulsePlan plan_pulses(const DeviceProfile& device, const PulseLimits& limits, double sample_time) {
  for (const double x : {limits.force, limits.torque, limits.travel, limits.turn, sample_time})
    if (!(std::isfinite(x) && x > 0))
      throw std::invalid_argument("pulses: every limit must be above zero");
  PulsePlan plan;
  plan.sample_time = sample_time;
  plan.rest = static_cast<std::size_t>(std::ceil(rest_time / sample_time));
  const PulseLimits most = most_allowed(device);
  const KindOfAxis force{std::min(limits.force, most.force), device.mass.value, limits.travel};
  const KindOfAxis torque{std::min(limits.torque, most.torque), device.inertia.value, limits.turn};
  for (std::size_t axis = 0; axis < 3; ++axis) add_pulses(plan, axis, force);
  for (std::size_t axis = 3; axis < 6 && torque.amplitude > 0; ++axis)
    add_pulses(plan, axis, torque);
  return plan;
}

std::vector<Wrench> commands_of(const PulsePlan& plan) {
  std::vector<Wrench> out(plan.rest);
  for (const Pulse& pulse : plan.pulses) {
    for (const double sign : signs) {
      Wrench wrench;
      set(wrench, pulse.axis, sign * pulse.amplitude);
      out.insert(out.end(), pulse.part, wrench);
    }
    out.insert(out.end(), plan.rest, Wrench{});
  }
  return out;
}

double time_of(const PulsePlan& plan) {
  std::size_t samples = plan.rest;
  for (const Pulse& pulse : plan.pulses) samples += 4 * pulse.part + plan.rest;
  return static_cast<double>(samples) * plan.sample_time;
}

}  // namespace sonde
