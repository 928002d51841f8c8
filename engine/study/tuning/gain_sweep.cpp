// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/gain_sweep.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/study/stability/contact_stability.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double jolt_share = 0.25;  // of the largest torque

/// The range of an axis in its own unit.
struct Range {
  double low, high, most_damping;
};
Range range_of(const TuningSetup& setup, GainAxis axis) {
  if (axis == GainAxis::rotation) {
    const double per = setup.rotation_per_translation;
    return {setup.low * per, setup.high * per, setup.most_rotational_damping};
  }
  return {setup.low, setup.high, axis == GainAxis::object ? 0 : setup.most_damping};
}

/// The linear contact at one damping: `stiffness` at one N/m (N·m/rad) of the axis.
SampledContact linear_contact(const TuningSetup& setup, GainAxis axis, double damping) {
  const FeltStiffness& felt = setup.situation.contact.stiffness;
  Coupling own = setup.loop.coupling, others = setup.loop.coupling;
  own.k = own.k_t = own.k_r = 0;
  set_gains(own, axis, 1, 0, setup.joint);
  set_gains(others, axis, 0, damping, setup.joint);
  return {setup.loop.device, setup.loop.sample_time, felt.stiffness(own), felt.stiffness(others),
          felt.damping(others)};
}

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json json_of(const SweepPoint& point, GainAxis axis) {
  const HoldReport& r = point.report;
  return {{"stiffness", point.stiffness},
          {"stable", r.stable},
          {"chattering", r.chattering},
          {"saturated", r.saturated},
          {"fault", name_of(fault_of(r, axis))},
          {"growth", number(r.growth)},
          {"work", number(r.work)},
          {"chatter", r.chatter},
          {"saturation", r.saturation},
          {"force_error", number(r.force_error)},
          {"torque_error", number(r.torque_error)},
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
          {"theory_stable", number(theory.stable)},
          {"theory_passive", number(theory.passive)},
          {"stable", sweep.stable.stiffness},
          {"stable_ends_by", name_of(sweep.stable.fault)},
          {"good", sweep.good.stiffness},
          {"good_ends_by", name_of(sweep.good.fault)},
          {"runs", runs}};
}

Json column(const TuningSetup& setup, GainAxis axis, double share, bool beyond, const Stop& stop) {
  const Range range = range_of(setup, axis);
  const double damping = share * range.most_damping;
  const TheoryLimits theory = theory_limits(setup, axis, share);
  const bool known = std::isfinite(theory.stable) && theory.stable > 0;
  const double start = known ? theory.stable : std::sqrt(range.low * range.high);
  const SweepOptions options{
      axis, std::clamp(start, range.low, range.high), range.low, range.high, setup.ratio, beyond};
  const auto run = [&](double stiffness) {
    ClosedLoopSetup loop = setup.loop;
    set_gains(loop.coupling, axis, stiffness, damping, setup.joint);
    ClosedLoop closed(loop);
    return press_and_hold(closed, press_of(setup, axis));
  };
  return json_of(damping, theory, sweep_stiffness(run, options, stop), axis);
}

}  // namespace

Press press_of(const TuningSituation& situation) {
  return {.X_FM = situation.contact.separation.separated, .push = situation.push};
}

Press press_of(const TuningSetup& setup, GainAxis axis) {
  Press out = press_of(setup.situation);
  if (axis != GainAxis::rotation && axis != GainAxis::together) return out;
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
    case GainAxis::together:
      c.k_r = stiffness * joint.stiffness;
      c.b_r = damping * joint.damping;
      [[fallthrough]];
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
  return {largest_stable_factor(contact), largest_passive_factor(contact)};
}

std::vector<double> damping_shares(const TuningSetup& setup, GainAxis axis) {
  if (range_of(setup, axis).most_damping == 0) return {0};
  return {0, 0.125, 0.25, 0.5, 1};
}

std::string sweep_gains(const TuningSetup& setup, GainAxis axis, const std::vector<double>& shares,
                        bool beyond, const Stop& stop) {
  Json columns = Json::array();
  for (const double share : shares) columns.push_back(column(setup, axis, share, beyond, stop));
  return Json{{"columns", columns}}.dump();
}

}  // namespace sonde
