// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stiffness_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/error.hpp"

namespace sonde {
namespace {

class Sweep {
 public:
  Sweep(const std::function<HoldReport(double)>& run, const SweepOptions& options, const Stop& stop)
      : run_(run), options_(options), stop_(stop) {}

  template <class Holds>
  SweepLimit limit(const Holds& holds) {
    double low = clamped(options_.start), high = 0;  // 0: not known yet
    while (!holds(at(low))) {
      high = low;
      if (low == options_.low) return {0, fault_of(at(low))};
      low = clamped(low / 2);
    }
    while (high == 0) {
      if (low == options_.high) return {low, HoldFault::none};
      const double next = clamped(2 * low);
      (holds(at(next)) ? low : high) = next;
    }
    while (high > options_.ratio * low) {
      const double middle = std::sqrt(low * high);
      (holds(at(middle)) ? low : high) = middle;
    }
    return {low, fault_of(at(high))};
  }

  void look(double stiffness) { at(clamped(stiffness)); }

  std::vector<SweepPoint> points() const {
    std::vector<SweepPoint> out;
    for (const auto& [stiffness, report] : done_) out.push_back({stiffness, report});
    return out;
  }

 private:
  double clamped(double stiffness) const {
    return std::clamp(stiffness, options_.low, options_.high);
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

}  // namespace

const char* name_of(HoldFault fault) {
  constexpr std::array names{"none", "stability", "saturation", "chatter", "fidelity"};
  return names[static_cast<std::size_t>(fault)];
}

HoldFault fault_of(const HoldReport& report) {
  if (!report.stable) return HoldFault::unstable;
  if (report.saturated) return HoldFault::saturated;
  if (report.chattering) return HoldFault::chattering;
  return report.force_error > fidelity_limit ? HoldFault::unfaithful : HoldFault::none;
}

StiffnessSweep sweep_stiffness(const std::function<HoldReport(double)>& run,
                               const SweepOptions& options, const Stop& stop) {
  Sweep sweep(run, options, stop);
  StiffnessSweep out;
  out.stable = sweep.limit([](const HoldReport& r) { return r.stable; });
  out.good = sweep.limit([](const HoldReport& r) { return fault_of(r) == HoldFault::none; });
  if (options.surroundings) {
    for (const double part : {0.25, 0.5}) sweep.look(part * options.start);
    if (out.stable.stiffness > 0)
      for (const double times : {1.3, 4.0}) sweep.look(times * out.stable.stiffness);
  }
  out.points = sweep.points();
  return out;
}

}  // namespace sonde
