// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/gain_sweep.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "engine/base/elementary.hpp"
#include "engine/study/stability/contact_stability.hpp"
#include "engine/text/json_numbers.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double jolt_share = 0.25;  // of the largest torque

/// Factor below the theoretical limit beyond which no sweep goes: gains that hold only there are of
/// no use, and a probe that sinks in so deep takes most of a study's time. In 1498 sweeps of
/// bundled scenes that went eight times as far, nothing good began below a sixteenth of the limit.
/// The cost: a lower limit counts as 0.
constexpr double useful_range = 32;

/// The range of an axis in its own unit.
struct Range {
  double low, high, most_damping;
};
Range range_of(const TuningSetup& setup, GainAxis axis) {
  if (axis == GainAxis::rotation) {
    const double per = setup.rotation_per_translation;
    return {setup.low * per, setup.high * per, setup.most_rotational_damping};
  }
  if (axis == GainAxis::object) return {setup.low, setup.high, 0};
  if (axis == GainAxis::damped) return {setup.low, setup.high, setup.most_object_damping};
  return {setup.low, setup.high,
          damps_turns(axis) ? setup.most_rotational_damping : setup.most_damping};
}

/// Halved into the range, as a walk goes down: what it runs is the same with a wider one.
double start_within(double start, const Range& range) {
  while (start > range.high) start /= 2;
  return std::max(start, range.low);
}

/// The linear contact at one damping: `stiffness` at one N/m (N·m/rad) of the axis.
SampledContact linear_contact(const TuningSetup& setup, GainAxis axis, double damping) {
  const FeltStiffness& felt = setup.situation.contact.stiffness;
  Coupling own = setup.loop.coupling, others = setup.loop.coupling;
  if (axis == GainAxis::damped) own.mode = others.mode = Coupling::Mode::damped;
  own.k = own.k_t = own.k_r = 0;
  set_gains(own, axis, 1, 0, setup.joint);
  set_gains(others, axis, 0, damping, setup.joint);
  return {setup.loop.device,    setup.loop.sample_time,
          felt.stiffness(own),  felt.stiffness(others),
          felt.damping(others), in_object_norm(axis) && setup.loop.method == Method::pdg};
}

Json json_of(const SweepPoint& point, GainAxis axis) {
  const HoldReport& r = point.report;
  return {{"stiffness", point.stiffness},
          {"stable", r.stable},
          {"chattering", r.chattering},
          {"saturated", r.saturated},
          {"fault", name_of(fault_of(r, axis))},
          {"growth", number_or_null(r.growth)},
          {"work", number_or_null(r.work)},
          {"chatter", r.chatter},
          {"saturation", r.saturation},
          {"force_error", number_or_null(r.force_error)},
          {"torque_error", number_or_null(r.torque_error)},
          {"depth", r.depth},
          {"contact", r.contact},
          {"force", r.force},
          {"torque", r.torque},
          {"jumps", r.jumps},
          {"pop_throughs", r.pop_throughs},
          {"failures", r.failures}};
}

Json json_of(double damping, const TheoryLimits& theory, const StiffnessSweep& sweep,
             GainAxis axis) {
  Json runs = Json::array();
  for (const SweepPoint& point : sweep.points) runs.push_back(json_of(point, axis));
  return {{"damping", damping},
          {"theory_stable", number_or_null(theory.stable)},
          {"theory_released", number_or_null(theory.released)},
          {"theory_released_any_swing", number_or_null(theory.released_any_swing)},
          {"theory_passive", number_or_null(theory.passive)},
          {"theory_passive_in_translation", number_or_null(theory.passive_in_translation)},
          {"cycle_lever", theory.cycle_lever},
          {"stable", sweep.stable.stiffness},
          {"stable_ends_by", name_of(sweep.stable.fault)},
          {"good", sweep.good.stiffness},
          {"good_ends_by", name_of(sweep.good.fault)},
          {"runs", runs}};
}

ClosedLoop closed_loop(const TuningSetup& setup, GainAxis axis, double stiffness, double damping) {
  ClosedLoopSetup loop = setup.loop;
  set_gains(loop.coupling, axis, stiffness, damping, setup.joint);
  return ClosedLoop(loop);
}

Press press_of(const TuningSetup& setup, GainAxis axis, double knock) {
  Press press = press_of(setup, axis);
  press.knock *= knock;
  press.jolt.force *= knock;
  press.jolt.torque *= knock;
  return press;
}

/// One hold of a sweep.
HoldReport hold(const TuningSetup& setup, GainAxis axis, double stiffness, double damping) {
  ClosedLoop closed = closed_loop(setup, axis, stiffness, damping);
  return press_and_hold(closed, press_of(setup, axis, 1));
}

/// Whether such a hold dies down.
HoldReport outcome(const TuningSetup& setup, GainAxis axis, double stiffness, double damping,
                   double knock) {
  ClosedLoop closed = closed_loop(setup, axis, stiffness, damping);
  return press_and_hold(closed, press_of(setup, axis, knock), HoldQuestion::outcome);
}

void add_limit(Json& json, const std::string& name, const SweepLimit& limit) {
  json[name] = limit.stiffness;
  json[name + "_ends_by"] = name_of(limit.fault);
}

TuningSetup without_friction(TuningSetup setup) {
  setup.loop.device.translation.friction = setup.loop.device.rotation.friction = 0;
  return setup;
}

/// Theory ignores friction, so the walk to the limit begins slightly below the theoretical limit.
/// If a probe without friction holds still at no stiffness, only theory gives a limit: the probe
/// slides away to a place of rest, or keeps oscillating everywhere.
void add_without_friction(Json& json, const TuningSetup& setup, SweepOptions options,
                          double damping, const TheoryLimits& theory, const Stop& stop) {
  const TuningSetup smooth = without_friction(setup);
  options.start = std::clamp(0.8 * options.start, options.low, options.high);
  const auto run = [&](double stiffness) {
    return outcome(smooth, options.axis, stiffness, damping, 1);
  };
  const auto holds = [](const HoldReport& report) { return report.stable; };
  SweepLimit limit = search_limit(run, holds, options, stop);
  const bool by_theory = limit.stiffness == 0 && std::isfinite(theory.stable);
  if (by_theory) limit = {theory.stable, HoldFault::unstable};
  add_limit(json, "without_friction", limit);
  json["without_friction_by_theory"] = by_theory;
}

/// With the hardest knock that does not come to rest. `stable` is the limit with the usual knock.
SweepLimit at_harder_knocks(const TuningSetup& setup, SweepOptions options, double damping,
                            const SweepLimit& stable, const Stop& stop) {
  const auto run = [&](double stiffness) {
    HoldReport slowest;
    // The hardest first: if it fails, the others are not needed.
    for (auto knock = std::rbegin(harder_knocks); knock != std::rend(harder_knocks); ++knock) {
      const HoldReport report = outcome(setup, options.axis, stiffness, damping, *knock);
      if (!comes_to_rest(report)) return report;
      if (report.growth >= slowest.growth) slowest = report;
    }
    return slowest;
  };
  // The usual knock fails there, so nothing above counts.
  if (stable.stiffness == 0 || comes_to_rest(run(stable.stiffness))) return stable;
  options.high = stable.stiffness;
  options.start = std::min(options.start, options.high);
  return search_limit(run, comes_to_rest, options, stop);
}

/// The results of holds of seconds.
Json long_hold(const TuningSetup& setup, GainAxis axis, double stiffness, double damping) {
  const auto swings_on = [&](const TuningSetup& held, double knock) {
    return !hold_until_rest(held, axis, stiffness, damping, knock).at_rest;
  };
  return {{"stiffness", stiffness},
          {"swings_without_friction", swings_on(without_friction(setup), 1)},
          {"swings_at_harder_knocks", swings_on(setup, std::ranges::max(harder_knocks))}};
}

Json column(const TuningSetup& setup, GainAxis axis, double share, const SweepExtent& extent,
            const Stop& stop) {
  const Range range = range_of(setup, axis);
  const double damping = share * range.most_damping;
  const TheoryLimits theory = theory_limits(setup, axis, share);
  const bool known = std::isfinite(theory.stable) && theory.stable > 0;
  const double start = known ? theory.stable : std::sqrt(range.low * range.high);
  const double low = known ? std::clamp(start / useful_range, range.low, range.high) : range.low;
  const bool in_full = !extent.in_full || share == *extent.in_full;
  const SweepOptions options{.axis = axis,
                             .start = start_within(start, range),
                             .low = low,
                             .high = range.high,
                             .ratio = setup.ratio,
                             .known_to = in_full ? setup.ratio : coarse_ratio(setup.ratio),
                             .beyond = extent.beyond && in_full};
  const auto run = [&](double stiffness) { return hold(setup, axis, stiffness, damping); };
  const StiffnessSweep sweep = sweep_stiffness(run, options, stop);
  Json out = json_of(damping, theory, sweep, axis);
  // Without a recommendation there is nothing to limit.
  if (sweep.good.stiffness == 0 && (!extent.in_full || !in_full)) return out;
  if (extent.without_friction) add_without_friction(out, setup, options, damping, theory, stop);
  if (extent.harder_knocks)
    add_limit(out, "harder_knocks", at_harder_knocks(setup, options, damping, sweep.stable, stop));
  if (in_full && extent.long_hold > 0)
    out["long_hold"] = long_hold(setup, axis, extent.long_hold, damping);
  return out;
}

}  // namespace

double coarse_ratio(double ratio) { return std::min(2.0, elementary::pow(ratio, 5)); }

Press press_of(const TuningSituation& situation) {
  return {.X_FM = situation.contact.separation.separated, .push = situation.push};
}

Press press_of(const TuningSetup& setup, GainAxis axis) {
  Press out = press_of(setup.situation);
  if (axis != GainAxis::rotation && !is_joint(axis)) return out;
  const Mat3 felt = setup.situation.contact.stiffness.classic.bottomRightCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver((felt + felt.transpose()) / 2);
  out.jolt.torque = jolt_share * setup.loop.device.rotation.limit * solver.eigenvectors().col(2);
  return out;
}

void set_gains(Coupling& c, GainAxis axis, double stiffness, double damping,
               const JointGains& joint) {
  switch (axis) {
    case GainAxis::object:
      c.k = stiffness;
      break;
    case GainAxis::damped:
      c.k = stiffness;
      c.b_t = damping;
      break;
    case GainAxis::together:
    case GainAxis::together_b_t:
    case GainAxis::together_b_r:
      c.k_t = stiffness;
      c.k_r = stiffness * joint.stiffness;
      c.b_t = axis == GainAxis::together_b_r ? 0 : damping;
      c.b_r = axis == GainAxis::together_b_r   ? damping
              : axis == GainAxis::together_b_t ? 0
                                               : damping * joint.damping;
      break;
    case GainAxis::translation:
      c.k_t = stiffness;
      c.b_t = damping;
      break;
    case GainAxis::rotation:
      c.k_r = stiffness;
      c.b_r = damping;
      break;
  }
}

void set_base_gains(TuningSetup& setup) {
  const double half = setup.situation.theory / 2;
  const double stiffness = std::isfinite(half) && half > 0 ? half : Coupling{}.k;
  Coupling& c = setup.loop.coupling;
  c.k = c.k_t = stiffness;
  c.k_r = stiffness * setup.rotation_per_translation;
  c.b_t = c.b_r = 0;
}

TheoryLimits theory_limits(const TuningSetup& setup, GainAxis axis, double share) {
  const SampledContact contact =
      linear_contact(setup, axis, share * range_of(setup, axis).most_damping);
  return {.stable = largest_stable_factor(contact),
          .released = largest_released_factor(contact),
          .released_any_swing = largest_released_factor_of_any_swing(contact),
          .passive = largest_passive_factor(contact),
          .passive_in_translation = largest_passive_factor_in_translation(contact),
          .cycle_lever = cycle_lever(contact)};
}

RestReport hold_until_rest(const TuningSetup& setup, GainAxis axis, double stiffness,
                           double damping, double knock) {
  ClosedLoop closed = closed_loop(setup, axis, stiffness, damping);
  return press_until_rest(closed, press_of(setup, axis, knock));
}

double most_damping(const TuningSetup& setup, GainAxis axis) {
  return range_of(setup, axis).most_damping;
}

std::vector<double> damping_shares(const TuningSetup& setup, GainAxis axis) {
  constexpr double step = 4;
  constexpr double light_hand = 200;  // N/m: a spring softer than the hand's own is of no use
  const double most = most_damping(setup, axis);
  if (most == 0) return {0};
  const SimulatedDeviceParameters& device = setup.loop.device;
  const bool turns = damps_turns(axis);
  const double inertia = turns ? device.rotation.inertia : device.translation.inertia;
  const double soft = turns ? light_hand * setup.rotation_per_translation : light_hand;
  const double little = 0.1 * 2 * std::sqrt(soft * inertia) / most;
  std::vector<double> out{1};
  while (!(out.back() < little)) out.push_back(out.back() / step);
  if (axis != GainAxis::together_b_t && axis != GainAxis::together_b_r) out.push_back(0);
  std::ranges::reverse(out);
  return out;
}

std::string sweep_gains(const TuningSetup& setup, GainAxis axis, const std::vector<double>& shares,
                        const SweepExtent& extent, const Stop& stop) {
  Json columns = Json::array();
  for (const double share : shares) columns.push_back(column(setup, axis, share, extent, stop));
  return Json{{"columns", columns}}.dump();
}

}  // namespace sonde
