// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/stiffness_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "engine/base/elementary.hpp"
#include "engine/base/error.hpp"

namespace sonde {
namespace {

struct NamedAxis {
  const char* name;
  const char* stiffness;  // keys of settings
  const char* damping;
};
// In the order of GainAxis.
constexpr NamedAxis gain_axes[] = {
    {"object", "k", ""},        {"together", "k_t", "b_t"},     {"translation", "k_t", "b_t"},
    {"rotation", "k_r", "b_r"}, {"together_b_t", "k_t", "b_t"}, {"together_b_r", "k_t", "b_r"},
    {"damped", "k", "b_t"},
};
const NamedAxis& named(GainAxis axis) { return gain_axes[static_cast<std::size_t>(axis)]; }

using Fits = std::function<bool(const HoldReport&)>;

/// An oscillation that keeps this share of its energy from window to window may soon keep all of
/// it.
constexpr double slow_to_die = 0.1;

double known_to(const SweepOptions& options) { return options.known_to.value_or(options.ratio); }

class StiffnessSearch {
 public:
  StiffnessSearch(const std::function<HoldReport(double)>& run, const SweepOptions& options,
                  const Stop& stop)
      : run_(run), options_(options), stop_(stop) {}

  /// Runs from `first`, or from below if that does not fit, to the first stiffness that does not
  /// fit.
  void walk(double first, const Fits& fits) {
    double k = down_from(clamped(first), fits);
    while (fits(at(k)) && k < options_.high) k = clamped(k * step_after(at(k)));
  }

  /// Halves until something fits; returns the low end of the range if nothing does.
  double down_from(double k, const Fits& fits) {
    while (!fits(at(k)) && k > options_.low) k = clamped(k / 2);
    return k;
  }

  /// Between the first stiffness that is too soft to be faithful and the next one with another
  /// fault there may be a good one: bisects there, until one is good or the two are within the
  /// ratio.
  void look_above_too_soft(const Fits& good) {
    const auto unfaithful = [&](double k) { return fault_of(at(k)) == HoldFault::unfaithful; };
    double low = 0, high = 0;
    for (auto it = done_.begin(); it != done_.end() && high == 0; ++it)
      if (unfaithful(it->first))
        low = it->first;
      else if (low > 0)
        high = it->first;
    while (high > options_.ratio * low && !any(good)) {
      const double middle = std::sqrt(low * high);
      (unfaithful(middle) ? low : high) = middle;
    }
  }

  /// Bisects below the first failure above `from`, until the limit is known closely enough.
  SweepLimit limit(const Fits& fits, double from) { return limit(fits, from, known_to(options_)); }
  SweepLimit limit(const Fits& fits, double from, double ratio) {
    for (;;) {
      double low = 0, high = 0;
      for (auto it = done_.lower_bound(from); it != done_.end() && high == 0; ++it)
        (fits(it->second) ? low : high) = it->first;
      if (high == 0) return {low, HoldFault::none};
      if (low == 0 || high <= ratio * low) return {low, fault_of(at(high))};
      at(std::sqrt(low * high));
    }
  }

  /// The softest that fits; the low end of the range if nothing does.
  double softest(const Fits& fits) const {
    for (const auto& [stiffness, report] : done_)
      if (fits(report)) return stiffness;
    return options_.low;
  }

  bool any(const Fits& fits) const {
    return std::ranges::any_of(done_, [&](const auto& run) { return fits(run.second); });
  }
  double softest_done() const { return done_.begin()->first; }
  std::size_t size() const { return done_.size(); }
  void look(double stiffness) { at(clamped(stiffness)); }
  HoldFault fault_of(const HoldReport& report) const {
    return sonde::fault_of(report, options_.axis);
  }

  std::vector<SweepPoint> points() const {
    std::vector<SweepPoint> out;
    for (const auto& [stiffness, report] : done_) out.push_back({stiffness, report});
    return out;
  }

 private:
  double clamped(double stiffness) const {
    return std::clamp(stiffness, options_.low, options_.high);
  }
  double step_after(const HoldReport& report) const {
    const double step = std::clamp(elementary::pow(options_.ratio, 16), 1.1, 2.0);
    return report.growth > slow_to_die ? elementary::pow(step, 0.25) : step;
  }
  const HoldReport& at(double stiffness) {
    const auto known = done_.find(stiffness);
    if (known != done_.end()) return known->second;
    if (stop_()) throw Cancelled();
    return done_.emplace(stiffness, run_(stiffness)).first->second;
  }

  const std::function<HoldReport(double)>& run_;
  const SweepOptions& options_;
  const Stop& stop_;
  std::map<double, HoldReport> done_;
};

/// A single axis is judged by its own error.
double error_of(const HoldReport& report, GainAxis axis) {
  switch (axis) {
    case GainAxis::rotation:
      return report.torque_error;
    case GainAxis::together:
    case GainAxis::together_b_t:
    case GainAxis::together_b_r:
      return std::max(report.force_error, report.torque_error);
    case GainAxis::object:
    case GainAxis::translation:
    case GainAxis::damped:
      break;
  }
  return report.force_error;
}

}  // namespace

const char* name_of(HoldFault fault) {
  constexpr std::array names{"none", "stability", "saturation", "chatter", "fidelity"};
  return names[static_cast<std::size_t>(fault)];
}

const char* name_of(GainAxis axis) { return named(axis).name; }
const char* stiffness_key(GainAxis axis) { return named(axis).stiffness; }
const char* damping_key(GainAxis axis) { return named(axis).damping; }

GainAxis gain_axis_named(std::string_view name) {
  const auto* const found =
      std::ranges::find_if(gain_axes, [&](const NamedAxis& each) { return name == each.name; });
  if (found == std::end(gain_axes))
    throw std::invalid_argument("unknown name " + std::string(name));
  return static_cast<GainAxis>(found - std::begin(gain_axes));
}

bool in_object_norm(GainAxis axis) { return axis == GainAxis::object || axis == GainAxis::damped; }

bool is_joint(GainAxis axis) {
  return axis == GainAxis::together || axis == GainAxis::together_b_t ||
         axis == GainAxis::together_b_r;
}

bool damps_turns(GainAxis axis) {
  return axis == GainAxis::rotation || axis == GainAxis::together_b_r;
}

HoldFault fault_of(const HoldReport& report, GainAxis axis) {
  if (!report.stable) return HoldFault::unstable;
  if (report.saturated) return HoldFault::saturated;
  if (report.chattering) return HoldFault::chattering;
  return error_of(report, axis) > fidelity_limit ? HoldFault::unfaithful : HoldFault::none;
}

StiffnessSweep sweep_stiffness(const std::function<HoldReport(double)>& run,
                               const SweepOptions& options, const Stop& stop) {
  StiffnessSearch sweep(run, options, stop);
  const Fits stable = [](const HoldReport& r) { return r.stable; };
  const Fits good = [&](const HoldReport& r) { return sweep.fault_of(r) == HoldFault::none; };
  sweep.walk(options.start / 4, stable);
  if (!sweep.any(good)) sweep.look_above_too_soft(good);
  if (!sweep.any(good)) sweep.down_from(sweep.softest_done(), good);
  StiffnessSweep out;
  // Nothing is recommended from a sweep without a good stiffness, so its map may be coarse.
  const double finest = sweep.any(good) ? known_to(options) : std::max(known_to(options), 1.1);
  for (std::size_t before = 0; before != sweep.size();) {  // bisecting one limit may move the other
    before = sweep.size();
    out.stable = sweep.limit(stable, options.low, finest);
    out.good = sweep.limit(good, sweep.softest(good));
  }
  if (options.beyond && out.stable.stiffness > 0)
    for (const double times : {1.3, 4.0}) sweep.look(times * out.stable.stiffness);
  out.points = sweep.points();
  return out;
}

bool comes_to_rest(const HoldReport& report) {
  return report.growth < Press{}.decay && report.failures == 0;
}

SweepLimit search_limit(const std::function<HoldReport(double)>& run,
                        const std::function<bool(const HoldReport&)>& holds,
                        const SweepOptions& options, const Stop& stop) {
  StiffnessSearch sweep(run, options, stop);
  sweep.walk(options.start, holds);
  return sweep.limit(holds, options.low);
}

}  // namespace sonde
