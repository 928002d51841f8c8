// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/safety/borne_gains.hpp"
#include "engine/settings/settings.hpp"
#include "engine/study/stability/contact_stability.hpp"
#include "engine/text/json_numbers.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

/// Number of situations of a kind that are tried until one holds still under pressure.
constexpr int tried_of_kind = 6;

double inertia_per_mass(const DeviceProfile& device) {
  return device.inertia.value / device.mass.value;
}

/// The gains at which theory compares contacts: one N/m.
Coupling unit_gains(const TuningRequest& request) {
  Coupling c = request.coupling;
  c.k = c.k_t = 1;
  c.k_r = inertia_per_mass(request.device);
  c.b_t = c.b_r = 0;
  return c;
}

/// The translational or the rotational block alone, for comparison with the driver's limits.
double largest_block(const Mat6& stiffness, Eigen::Index first) {
  const Mat3 block = stiffness.block<3, 3>(first, first);
  return Eigen::SelfAdjointEigenSolver<Mat3>((block + block.transpose()) / 2)
      .eigenvalues()
      .maxCoeff();
}

SimulatedDeviceParameters held_by(const DeviceProfile& device, const HandGrip& grip) {
  SimulatedDeviceParameters p = simulated(device);
  const double per = inertia_per_mass(device);
  p.translation.hand_stiffness = grip.stiffness;
  p.translation.hand_damping = grip.damping;
  p.rotation.hand_stiffness = grip.stiffness * per;
  p.rotation.hand_damping = grip.damping * per;
  return p;
}

/// The push of the hand: opposite to the contact's own wrench, with a quarter of the device's force
/// and half of its torque.
Wrench push_into(const TuningRequest& request, const Separation& s) {
  const Wrench spring = spring_wrench(request.pair.probe().mass, s, unit_gains(request));
  const double force = spring.force.norm(), torque = spring.torque.norm();
  double scale = INFINITY;
  if (force > 0) scale = 0.25 * request.device.max_force.value / force;
  if (torque > 0 && request.device.max_torque.value > 0)
    scale = std::min(scale, 0.5 * request.device.max_torque.value / torque);
  if (!std::isfinite(scale)) return {};
  // If no motors resist a turn, a torque of the hand would only spin the handle.
  const bool turns = request.device.max_torque.value > 0;
  return {-scale * spring.force, turns ? Vec3(-scale * spring.torque) : Vec3::Zero()};
}

double theory_factor(const TuningRequest& request, const FeltStiffness& felt) {
  return largest_stable_factor({.device = held_by(request.device, hand_grips[0]),
                                .sample_time = request.sample_time,
                                .stiffness = felt.stiffness(unit_gains(request))});
}

TuningSetup setup_of(const TuningRequest& request, const DeviceProfile& device,
                     const TuningSituation& situation, const HandGrip& grip,
                     const JointGains& joint = {}) {
  TuningSetup out{.loop = {.pair = request.pair,
                           .method = request.method,
                           .coupling = request.coupling,
                           .device = held_by(device, grip),
                           .sample_time = request.sample_time,
                           .budget = request.budget},
                  .situation = situation};
  // Hands are those of the profile as it is, whatever is assumed about the device.
  const SimulatedDeviceParameters hand = held_by(request.device, grip);
  out.loop.device.rotation.hand_stiffness = hand.rotation.hand_stiffness;
  out.loop.device.rotation.hand_damping = hand.rotation.hand_damping;
  out.loop.coupling.max_force = std::min(request.coupling.max_force, device.max_force.value);
  if (device.max_torque.value > 0)
    out.loop.coupling.max_torque = std::min(request.coupling.max_torque, device.max_torque.value);
  else  // torque for which the device has no motors is not limited
    out.loop.coupling.max_torque = INFINITY;
  out.low = request.low;
  out.high = request.high;
  out.ratio = request.ratio;
  out.rotation_per_translation = inertia_per_mass(request.device);
  out.joint = joint;
  // With the profile's own dampings, whatever is assumed, so that results are comparable.
  out.most_damping = request.device.max_damping.value;
  out.most_rotational_damping = request.device.max_rotational_damping.value;
  out.most_object_damping = most_object_damping(
      {.damping = out.most_damping, .rotational_damping = out.most_rotational_damping},
      request.pair.probe().mass);
  set_base_gains(out);
  return out;
}

/// The reason why a light hand that presses the probe into the contact, at half of the theoretical
/// stiffness limit, cannot hold it there; empty if it can.
std::string why_not_held(const TuningRequest& request, const TuningSituation& situation) {
  ClosedLoop loop(setup_of(request, request.device, situation, hand_grips[0]).loop);
  const HoldReport report = press_and_hold(loop, press_of(situation));
  if (report.failures > 0) return "the solver gave no answer";
  if (report.jumps > 0) return "the contact jumped to another place";
  if (report.contact <= 0.95) return "the probe left the contact";
  return report.stable ? "" : "the probe did not come to rest";
}

/// Of those of one kind, the hardest first: the first that holds still, and those before it.
TuningContacts choose_of_kind(const TuningRequest& request, std::span<const ContactSituation> found,
                              const Stop& stop) {
  TuningContacts out;
  for (const ContactSituation& each : found) {
    if (stop()) throw Cancelled();
    const TuningSituation situation{each, push_into(request, each.separation),
                                    theory_factor(request, each.stiffness)};
    const std::string reason = why_not_held(request, situation);
    if (reason.empty()) {
      out.situations.push_back(situation);
      break;
    }
    out.skipped.push_back({each.kind, reason});
  }
  return out;
}

/// The hardest situation of each kind that holds still.
TuningContacts choose(const TuningRequest& request, const std::vector<ContactSituation>& found,
                      const Stop& stop, unsigned threads) {
  std::array<TuningContacts, std::size(all_contact_kinds)> of_kind;
  run_parallel(of_kind.size(), threads, [&](std::size_t i) {
    const ContactKind kind = all_contact_kinds[i];
    const auto first = std::ranges::lower_bound(found, kind, {}, &ContactSituation::kind);
    const auto last = std::ranges::upper_bound(found, kind, {}, &ContactSituation::kind);
    of_kind[i] = choose_of_kind(request, {first, last}, stop);
  });
  TuningContacts out;
  for (const TuningContacts& each : of_kind) {
    out.situations.insert(out.situations.end(), each.situations.begin(), each.situations.end());
    out.skipped.insert(out.skipped.end(), each.skipped.begin(), each.skipped.end());
  }
  const std::string& only = request.kind;
  for (const ContactKind kind : all_contact_kinds)
    if (std::ranges::find(found, kind, &ContactSituation::kind) == found.end())
      out.skipped.push_back({kind, only.empty() || only == name_of(kind)
                                       ? "no such contact was found"
                                       : "only the contact \"" + only + "\" was asked for"});
  return out;
}

/// The least stiffness limit of one axis over the contacts in a light hand: that of theory or of
/// the driver. Without damping; the other axis at half of its theoretical limit.
double allowed_alone(const TuningRequest& request, const std::vector<TuningSituation>& situations,
                     GainAxis axis) {
  const bool turns = axis == GainAxis::rotation;
  double least = INFINITY;
  for (const TuningSituation& each : situations) {
    const TuningSetup setup = setup_of(request, request.device, each, hand_grips[0]);
    least = std::min(least, theory_limits(setup, axis, 0).stable);
    const double felt = largest_block(each.contact.stiffness.classic, turns ? 3 : 0);
    const double driver =
        turns ? request.device.max_rotational_stiffness.value : request.device.max_stiffness.value;
    if (felt > 0 && driver > 0) least = std::min(least, driver / felt);
  }
  return least;
}

/// In the ratio of the limits of each axis alone, and of the driver's largest dampings; none if the
/// gains are not swept together.
JointGains joint_gains(const TuningRequest& request,
                       const std::vector<TuningSituation>& situations) {
  if (axes_of(request).front() != GainAxis::together) return {};
  const DeviceProfile& device = request.device;
  const double ratio = allowed_alone(request, situations, GainAxis::rotation) /
                       allowed_alone(request, situations, GainAxis::translation);
  const double most = device.max_damping.value;
  return {std::isfinite(ratio) && ratio > 0 ? ratio : inertia_per_mass(device),
          most > 0 ? device.max_rotational_damping.value / most : 0};
}

Json numbers(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
Json numbers(const Pose& X) {
  return {X.p.x(), X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z()};
}

Json about(const TuningRequest& request, const TuningSituation& situation) {
  const Separation& s = situation.contact.separation;
  const MassProperties& mass = request.pair.probe().mass;
  const StiffnessRatio felt = stiffness_ratio(mass, s.device, situation.contact.stiffness.object);
  const StiffnessRatio summed = summed_penalty_ratio(mass, s);
  const Mat6 unit = situation.contact.stiffness.stiffness(unit_gains(request));
  return {{"kind", name_of(situation.contact.kind)},
          {"device", numbers(s.device)},
          {"separated", numbers(s.separated)},
          {"depth", s.depth},
          {"clusters", s.clusters.size},
          {"contacts", s.contacts.size},
          {"push_force", numbers(situation.push.force)},
          {"push_torque", numbers(situation.push.torque)},
          {"felt_translation", felt.translation},
          {"felt_rotation", felt.rotation},
          {"summed_translation", summed.translation},
          {"summed_rotation", summed.rotation},
          {"largest_translational_stiffness", largest_block(unit, 0)},
          {"largest_rotational_stiffness", largest_block(unit, 3)},
          {"theory_stable", number_or_null(situation.theory)}};
}

Json about(const DeviceProfile& device) {
  Json out{{"id", device.id}, {"name", device.name}};
  for (const ProfileKey& key : profile_keys()) {
    const ProfileValue& value = device.*key.value;
    Json& json = out[key.key];
    json = {{"value", value.value}, {value.assumed ? "assumed" : "source", value.origin}};
    if (value.interval) json.update({{"low", value.interval->low}, {"high", value.interval->high}});
  }
  return out;
}

Json about(const TuningPlan& plan) {
  const TuningRequest& r = plan.request;
  Json situations = Json::array(), skipped = Json::array();
  for (const TuningSituation& each : plan.contacts.situations) situations.push_back(about(r, each));
  for (const SkippedContact& each : plan.contacts.skipped)
    skipped.push_back({{"kind", name_of(each.kind)}, {"reason", each.reason}});
  Json out{{"inputs", Json::parse(r.inputs)},
           {"mode", name_of(r.coupling.mode)},
           {"method", name_of(r.method)},
           {"max_force", std::min(r.coupling.max_force, r.device.max_force.value)},
           {"max_torque", r.device.max_torque.value > 0
                              ? std::min(r.coupling.max_torque, r.device.max_torque.value)
                              : r.coupling.max_torque},
           {"sample_time", r.sample_time},
           {"budget_steps", r.budget.steps},
           {"budget_work", r.budget.work},
           {"seed", r.seed},
           {"ratio", r.ratio},
           {"low", r.low},
           {"high", r.high},
           {"trajectory", !r.path.empty()},
           {"trusts_friction", r.trusts_friction},
           {"always_held", r.always_held},
           {"device", about(r.device)},
           {"rotational_stiffness_per_translational", plan.joint.stiffness},
           {"rotational_damping_per_translational", plan.joint.damping},
           {"axis_in_full", name_of(plan.axis)},
           {"damping_share_in_full", plan.damping_share},
           {"largest_inertia", r.pair.probe().mass.inertia.maxCoeff()},
           {"damper_in_theory", plan.damper ? Json{{"stiffness", plan.damper->stiffness},
                                                   {"damping", plan.damper->damping}}
                                            : Json(nullptr)},
           {"situations", situations},
           {"skipped", skipped}};
  if (!r.kind.empty()) out["only_kind"] = r.kind;
  return out;
}

}  // namespace

Budget counted_budget(const ServoSettings& servo) {
  constexpr double units_per_us = 100;
  constexpr std::int64_t most_work = 3'000'000;
  Budget out{.steps = servo.budget.steps > 0 ? servo.budget.steps : 60, .work = most_work};
  if (servo.accuracy == 0 && servo.budget.microseconds > 0)
    out.work = std::clamp<std::int64_t>(std::llround(units_per_us * servo.budget.microseconds), 1,
                                        most_work);
  return out;
}

TuningContacts tuning_contacts(const TuningRequest& request, const Stop& stop,
                               const std::function<void(double)>& progress, unsigned threads) {
  SituationOptions options{.method = request.method, .seed = request.seed, .progress = progress};
  options.threads = threads;
  options.hardness = [&](const FeltStiffness& felt) { return 1 / theory_factor(request, felt); };
  auto found = request.path.empty()
                   ? find_situations(request.pair, request.X_FM, tried_of_kind, options, stop)
                   : situations_along(request.pair, request.path, tried_of_kind, options, stop);
  if (found.empty())
    throw InputError(request.path.empty() ? "no contact of the two bodies was found"
                                          : "the probe is in contact at no pose of the trajectory");
  if (!request.kind.empty()) {
    std::erase_if(found,
                  [&](const ContactSituation& each) { return name_of(each.kind) != request.kind; });
    if (found.empty())
      throw InputError("no contact of the kind \"" + request.kind + "\" was found");
  }
  auto chosen = choose(request, found, stop, threads);
  if (chosen.situations.empty())
    throw InputError(
        "no contact was found in which a hand could hold the probe still; in the hardest one, " +
        chosen.skipped.front().reason);
  return chosen;
}

TuningSetup tuning_setup(const TuningRequest& request, const TuningSituation& situation,
                         const HandGrip& grip) {
  return setup_of(request, request.device, situation, grip);
}

std::vector<GainAxis> axes_of(const TuningRequest& request) {
  if (request.coupling.mode == Coupling::Mode::object) return {GainAxis::object};
  if (request.coupling.mode == Coupling::Mode::damped) return {GainAxis::damped};
  if (!(request.device.max_torque.value > 0)) return {GainAxis::translation};
  std::vector<GainAxis> out{GainAxis::together};
  if (request.device.max_damping.value > 0 && request.device.max_rotational_damping.value > 0)
    out.insert(out.end(), {GainAxis::together_b_t, GainAxis::together_b_r});
  out.insert(out.end(), {GainAxis::translation, GainAxis::rotation});
  return out;
}

std::vector<GainAxis> main_axes(const TuningRequest& request) {
  std::vector<GainAxis> out = axes_of(request);
  if (out.size() > 1) std::erase_if(out, [](GainAxis axis) { return !is_joint(axis); });
  return out;
}

GainAxis main_axis(const TuningRequest& request) { return main_axes(request).front(); }

TuningPlan tuning_plan(const TuningRequest& request, const Stop& stop,
                       const std::function<void(double)>& progress, unsigned threads) {
  TuningContacts contacts = tuning_contacts(request, stop, progress, threads);
  const JointGains joint = joint_gains(request, contacts.situations);
  return {request, std::move(contacts), joint, main_axis(request)};
}

std::size_t hardest(const TuningPlan& plan) {
  const auto& situations = plan.contacts.situations;
  const auto least = std::ranges::min_element(situations, {}, &TuningSituation::theory);
  return static_cast<std::size_t>(least - situations.begin());
}

TuningSetup tuning_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& grip) {
  return tuning_setup(plan, situation, grip, plan.request.device);
}

TuningSetup tuning_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& grip,
                         const DeviceProfile& device) {
  return setup_of(plan.request, device, plan.contacts.situations[situation], grip, plan.joint);
}

double driver_limit(const TuningPlan& plan, std::size_t situation, GainAxis axis,
                    const DeviceProfile& device) {
  Coupling c = plan.request.coupling;
  c.k = c.k_t = c.k_r = 0;
  set_gains(c, axis, 1, 0, plan.joint);
  const Mat6 felt = plan.contacts.situations[situation].contact.stiffness.stiffness(c);
  double least = infinity;
  const auto add = [&](const ProfileValue& most, Eigen::Index first) {
    const double block = largest_block(felt, first);
    if (most.value > 0 && block > 0) least = std::min(least, most.value / block);
  };
  add(device.max_stiffness, 0);
  if (device.max_torque.value > 0) add(device.max_rotational_stiffness, 3);
  return least;
}

std::string tuning_facts(const TuningPlan& plan) { return about(plan).dump(); }

}  // namespace sonde
