// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/numbers.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/scene/poses.hpp"
#include "engine/settings/device_profile.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/tuning/gain_sweep.hpp"

namespace sonde {

/// The budget of a servo's tick as counted work, since a study must not depend on a clock. A µs is
/// 100 units of Effort. A tick that takes longer than the servo's limit would come too late, and is
/// not studied: it ends early, with a separation larger than necessary. If the servo has no time
/// limit, or uses an accuracy, the budget is that of a tick after a jump, some 30 ms: otherwise one
/// tick of an unstable loop that throws the probe about could take many seconds. Steps: 60 if the
/// servo has no limit.
Budget counted_budget(const ServoSettings& servo);

/// The input of a study of a coupling's gains.
struct TuningRequest {
  Pair pair;
  Pose X_FM = {};          ///< from the scene: contacts are searched for near this rotation
  Coupling coupling = {};  ///< from the scene: the mode to study, and its limits
  Method method = Method::pdg;
  double sample_time = 1e-3;                        ///< s
  Budget budget = counted_budget(ServoSettings{});  ///< of a tick
  DeviceProfile device = {};
  std::vector<TimedPose> path = {};  ///< contacts are taken from it; empty: they are searched for
  std::string kind = {};  ///< only contacts of this kind are studied; empty: those of every kind
  std::uint64_t seed = 1;
  double ratio = 1.02;         ///< accuracy of the limits
  double low = 1, high = 1e5;  ///< range of the stiffness studied, N/m; of a rotational one the
                               ///< same times inertia over mass of the device
  /// Recommends gains that are stable only thanks to the profile's friction.
  bool trusts_friction = false;
  /// Recommends gains at which the handle may buzz, and so is unstable, when the hand releases it.
  bool always_held = false;
  std::string inputs = "{}";  ///< JSON that identifies the files: names, fingerprints
};

/// The grip of a hand on the device: a spring and a damper; for rotations, the same times inertia /
/// mass.
struct HandGrip {
  const char* name;
  double stiffness;  ///< N/m
  double damping;    ///< N·s/m
};
/// A loose and a firm hand, of the order of measured hands (Hogan, 1989; Hajian and Howe, 1997),
/// without their mass, which would help.
constexpr HandGrip hand_grips[] = {{"light", 200, 1}, {"firm", 1000, 10}};

/// A contact, or a kind of contact, that the study leaves out.
struct SkippedContact {
  ContactKind kind;
  std::string reason;  ///< in words
};
struct TuningContacts {
  std::vector<TuningSituation> situations;
  /// Harder ones than those studied, and kinds without a contact.
  std::vector<SkippedContact> skipped;
};

/// The contacts to study: of each kind the hardest in which a light hand can hold the probe still.
/// Takes seconds; the same at any number of threads; `progress` gets the fraction done, 0 to 1.
/// Throws InputError where there is none (of the kind asked for), Cancelled.
TuningContacts tuning_contacts(const TuningRequest& request, const Stop& stop,
                               const std::function<void(double)>& progress = {},
                               unsigned threads = 1);

/// A situation with a hand and the request's device, with gains well within the theoretical limit.
TuningSetup tuning_setup(const TuningRequest& request, const TuningSituation& situation,
                         const HandGrip& grip);

/// A damping at which nothing is known yet, as a share of the largest.
struct DampingToTry {
  double share = 0;
  double unmeasured = infinity;  ///< as TuningPlan has it
};

/// The starting point of the gain studies.
struct TuningPlan {
  TuningRequest request;
  TuningContacts contacts;
  JointGains joint = {};  ///< if all gains of the classic coupling are changed together
  /// The recommended axis: the one of main_axes that allows most.
  GainAxis axis = GainAxis::object;
  /// Share of the largest damping: searched in full, used where assumed values are varied, and for
  /// the first look.
  double damping_share = 0;
  /// A first, coarse result: only the recommended axis, in each situation in a light hand, at that
  /// damping.
  StudyFolder first_look = {};
  /// Its recommendation, N/m; 0: none. At this stiffness the study holds the probe for seconds
  /// (LongHold).
  double held_stiffness = 0;
  /// What theory of a handle that no hand holds, the driver and the encoder allow there, N/m: no
  /// run can raise it.
  double unmeasured = infinity;
  /// If no first look allowed anything: every damping of that axis, the least first. All are tried.
  std::vector<DampingToTry> dampings = {};
  /// What they would allow with a damper, if the coupling studied is the object norm without one.
  std::optional<DamperInTheory> damper = {};
};
/// Searches for the situations. Errors as for tuning_contacts.
TuningPlan tuning_plan(const TuningRequest& request, const Stop& stop,
                       const std::function<void(double)>& progress = {}, unsigned threads = 1);
/// What a study of these gains sweeps, main_axes first.
std::vector<GainAxis> axes_of(const TuningRequest& request);
/// The gains that may be recommended: of the object norm, of the classic coupling together (with
/// both dampers, and with each alone), or of its translation if the device has no torque.
std::vector<GainAxis> main_axes(const TuningRequest& request);
GainAxis main_axis(const TuningRequest& request);  ///< the first of them
/// The situation with the lowest theoretical limit.
std::size_t hardest(const TuningPlan& plan);
TuningSetup tuning_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& grip);
/// The same with another device than the plan's; hand, range and push stay those of the plan.
TuningSetup tuning_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& grip,
                         const DeviceProfile& device);
/// The stiffness of an axis that is felt in a situation as the largest that the driver of the
/// device takes, N/m | N·m/rad; infinite where the profile says none.
double driver_limit(const TuningPlan& plan, std::size_t situation, GainAxis axis,
                    const DeviceProfile& device);
/// All that a study of this plan depends on, as JSON (Study::about).
std::string tuning_facts(const TuningPlan& plan);

}  // namespace sonde
