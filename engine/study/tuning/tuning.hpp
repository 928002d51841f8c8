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

/// What a servo's tick may take, as counted work: a study may not depend on a clock. A µs is 100
/// units of Effort. What takes a tick longer than the servo gives it does not come in time, and is
/// not studied: it ends early, with a separation that is larger than it need be. Without a limit of
/// time, or where the servo goes by an accuracy, it is what a tick after a jump may take, some 30
/// ms: where a loop that is wild throws the probe about, one tick could otherwise take many
/// seconds. Steps: 60 where the servo has no limit.
Budget counted_budget(const ServoSettings& servo);

/// The input of a study of a coupling's gains.
struct TuningRequest {
  Pair pair;
  Pose X_FM = {};          ///< of the scene: contacts are looked for near this turn of the probe
  Coupling coupling = {};  ///< of the scene: which mode to study, and its limits
  Method method = Method::pdg;
  double sample_time = 1e-3;                        ///< s
  Budget budget = counted_budget(ServoSettings{});  ///< of a tick
  DeviceProfile device = {};
  std::vector<TimedPose> path = {};  ///< contacts are taken from it; empty: they are looked for
  std::uint64_t seed = 1;
  double ratio = 1.02;         ///< to which limits are known
  double low = 1, high = 1e5;  ///< range of the stiffness studied, N/m; of a rotational one the
                               ///< same times inertia over mass of the device
  /// Recommends gains that are stable only thanks to the profile's friction.
  bool trusts_friction = false;
  /// Recommends gains at which the handle may buzz once the hand lets go of it.
  bool always_held = false;
  std::string inputs = "{}";  ///< JSON that tells the files apart: names, fingerprints
};

/// How a hand holds the device: a spring and a damper; for rotations, the same times inertia over
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
  std::vector<SkippedContact> skipped;  ///< harder ones than those studied, and kinds without any
};

/// The contacts to study: of each kind the hardest in which a light hand can hold the probe still.
/// Takes seconds; the same at any number of threads; `progress` gets the fraction done, 0 to 1.
/// Throws InputError where there is none, Cancelled.
TuningContacts tuning_contacts(const TuningRequest& request, const Stop& stop,
                               const std::function<void(double)>& progress = {},
                               unsigned threads = 1);

/// A situation with a hand and the request's device, at gains well within what theory allows.
TuningSetup tuning_setup(const TuningRequest& request, const TuningSituation& situation,
                         const HandGrip& grip);

/// What the studies of gains begin with.
struct TuningPlan {
  TuningRequest request;
  TuningContacts contacts;
  JointGains joint = {};  ///< where all gains of the classic coupling are changed together
  GainAxis axis = GainAxis::object;  ///< what is recommended: of main_axes, what allows most
  /// Of the largest damping: what is searched in full, where assumed values are varied, and where
  /// the first look is taken.
  double damping_share = 0;
  /// A first result: what is recommended alone, coarsely, in each situation in a light hand, at the
  /// one damping.
  StudyFolder first_look = {};
  /// What it recommends, N/m; 0: nothing. There the study holds the probe for seconds (LongHold).
  double held_stiffness = 0;
  /// What theory of a handle that no hand holds, the driver and the encoder allow there, N/m: no
  /// run can raise it.
  double unmeasured = infinity;
};
/// Looks for the situations. Errors as tuning_contacts.
TuningPlan tuning_plan(const TuningRequest& request, const Stop& stop,
                       const std::function<void(double)>& progress = {}, unsigned threads = 1);
/// What a study of these gains sweeps, main_axes first.
std::vector<GainAxis> axes_of(const TuningRequest& request);
/// The gains that may be recommended: of the object norm, of the classic coupling together (with
/// both dampers, and with each by itself), or of its translation where the device has no torque.
std::vector<GainAxis> main_axes(const TuningRequest& request);
GainAxis main_axis(const TuningRequest& request);  ///< the first of them
/// The situation whose stiffness theory limits most.
std::size_t hardest(const TuningPlan& plan);
TuningSetup tuning_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& grip);
/// The same on another device than the plan's; hand, range and push stay those of the plan.
TuningSetup tuning_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& grip,
                         const DeviceProfile& device);
/// The stiffness of an axis that is felt in a situation as the largest that the driver of the
/// device takes, N/m | N·m/rad; infinite where the profile says none.
double driver_limit(const TuningPlan& plan, std::size_t situation, GainAxis axis,
                    const DeviceProfile& device);
/// All that a study of this plan depends on, as JSON (Study::about).
std::string tuning_facts(const TuningPlan& plan);

}  // namespace sonde
