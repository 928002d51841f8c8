// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_study.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"
#include "engine/base/threads.hpp"
#include "engine/settings/settings.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

/// A part of the study, as identified by its file name.
struct PartOf {
  std::size_t situation;
  const HandGrip* grip;
  GainAxis axis;
  std::vector<double> shares;     ///< of the largest damping
  const char* assumed = nullptr;  ///< a key of the profile whose value is varied
  double times = 1;
  const char* end = "";  ///< the varied end in the file's name
  bool first_look = false;
  double most = infinity;  ///< N/m: nothing above that could be recommended, so it is not looked at
};

std::string part_name(const TuningPlan& plan, const PartOf& part) {
  std::string name = name_of(plan.contacts.situations[part.situation].contact.kind);
  name += std::string(".") + part.grip->name + "." + name_of(part.axis);
  if (part.assumed) name += std::string(".") + part.assumed + part.end;
  return name;
}

DeviceProfile changed(DeviceProfile device, const PartOf& part) {
  for (const ProfileKey& key : profile_keys())
    if (part.assumed && std::string_view(key.key) == part.assumed)
      (device.*key.value).value *= part.times;
  return device;
}

/// No sweep goes further above what the driver takes than by this: nothing there can be rendered,
/// so nothing is recommended. More than stability_margin, so that a boundary that decides is found,
/// and that of a value half or twice as large too. Lost: how far above that a boundary lies.
constexpr double beyond_driver = 4;

/// N/m, also of a rotation, as TuningSetup has it.
double most_of_use(const TuningPlan& plan, const PartOf& part, const TuningSetup& setup,
                   const DeviceProfile& device) {
  const double per = part.axis == GainAxis::rotation ? setup.rotation_per_translation : 1;
  const double driver = driver_limit(plan, part.situation, part.axis, device) / per;
  return std::min(beyond_driver * driver, stability_margin * part.most);
}

double coarser(double ratio, int times) { return std::min(2.0, elementary::pow(ratio, times)); }
/// Accuracy of the limits where a value of the profile is varied: its ends are no more accurate.
double varied_ratio(double ratio) { return coarser(ratio, 2); }

/// An end of the range of a profile value, as a multiple of it.
struct VariedEnd {
  double times;
  const char* name;
};
/// An assumed value is varied to half and twice its value, a measured one to the ends of its
/// interval. None if these are nearer than `resolved`: the searches would not distinguish them.
std::vector<VariedEnd> varied_ends(const ProfileValue& value, double resolved) {
  if (value.value == 0) return {};
  if (value.assumed) return {{0.5, ".half"}, {2, ".twice"}};
  if (!value.interval || !(value.interval->high > resolved * value.interval->low)) return {};
  return {{value.interval->low / value.value, ".low"},
          {value.interval->high / value.value, ".high"}};
}

bool has_friction(const DeviceProfile& device) {
  return device.friction.value > 0 || device.rotational_friction.value > 0;
}

bool is_alone(const TuningPlan& plan, GainAxis axis) {
  const std::vector<GainAxis> main = main_axes(plan.request);
  return std::ranges::find(main, axis) == main.end();
}

StudyPart study_part(const std::shared_ptr<const TuningPlan>& plan, const PartOf& part) {
  return {part_name(*plan, part), [plan, part](const Stop& stop) {
            const DeviceProfile device = changed(plan->request.device, part);
            const TuningSituation& situation = plan->contacts.situations[part.situation];
            const bool nominal = part.assumed == nullptr;
            TuningSetup setup = tuning_setup(*plan, part.situation, *part.grip, device);
            if (part.first_look) setup.ratio = std::max(setup.ratio, first_look_ratio);
            setup.high = std::clamp(most_of_use(*plan, part, setup, device), setup.low, setup.high);
            // What an axis could do alone, or with another damper, is for the map, and nothing is
            // recommended by it.
            const bool alone = is_alone(*plan, part.axis);
            const bool aside = !part.first_look && part.axis != plan->axis;
            if (aside) setup.ratio = coarser(setup.ratio, 16);
            if (!nominal) setup.ratio = varied_ratio(setup.ratio);
            // Parts that vary a friction use the frictionless limit of the unchanged profile.
            const bool varies_friction = !nominal && is_friction(part.assumed);
            const bool rubs = !alone && has_friction(device);
            const bool in_full = nominal && !aside && !part.first_look;
            SweepExtent extent{.beyond = in_full,
                               .without_friction = rubs && !varies_friction,
                               .harder_knocks = nominal && !alone};
            if (in_full) {
              extent.in_full = plan->damping_share;
              extent.long_hold = plan->held_stiffness;
            }
            Json json{{"situation", part.situation},
                      {"kind", name_of(situation.contact.kind)},
                      {"hand", part.grip->name},
                      {"axis", name_of(part.axis)},
                      {"assumed", nominal ? Json(nullptr) : Json(part.assumed)},
                      {"times", part.times}};
            json.update(Json::parse(sweep_gains(setup, part.axis, part.shares, extent, stop)));
            return json.dump(1) + "\n";
          }};
}

std::vector<PartOf> parts_of(const TuningPlan& plan) {
  std::vector<PartOf> parts;
  // The recommended axis comes first.
  std::vector<GainAxis> axes = axes_of(plan.request);
  std::rotate(axes.begin(), std::ranges::find(axes, plan.axis), axes.end());
  for (const GainAxis axis : axes)
    for (std::size_t i = 0; i < plan.contacts.situations.size(); ++i)
      for (const HandGrip& grip : hand_grips) {
        // The firm hand has higher limits.
        if (axis != plan.axis && &grip != &hand_grips[0]) continue;
        std::vector<double> shares = damping_shares(tuning_setup(plan, i, grip), axis);
        if (is_alone(plan, axis) && shares.size() > 1) shares = {0, 1};
        parts.push_back({i, &grip, axis, shares});
      }
  // The recommended axis is varied, not each axis alone.
  const std::size_t where = hardest(plan);
  for (const ProfileKey& key : profile_keys())
    for (const VariedEnd& end :
         varied_ends(plan.request.device.*key.value, varied_ratio(plan.request.ratio)))
      parts.push_back(
          {where, &hand_grips[0], plan.axis, {plan.damping_share}, key.key, end.times, end.name});
  return parts;
}

/// Of the dampings that may be recommended, one; and a first look there.
struct Look {
  GainAxis axis = GainAxis::object;
  double share = 0;         ///< of the largest damping
  double unmeasured = 0;    ///< as TuningPlan has it
  StudyFolder result = {};  ///< of one part, at the hardest contact
  double allowed = 0;       ///< N/m, there; at most
};

/// Coarse, in a light hand.
PartOf first_look_at(std::size_t situation, const Look& look, double most) {
  PartOf part{situation, &hand_grips[0], look.axis, {look.share}};
  part.first_look = true;
  part.most = most;
  return part;
}

Study study_of(const std::shared_ptr<const TuningPlan>& plan, const std::vector<PartOf>& parts) {
  Study study{"tune", tuning_facts(*plan), {}};
  for (const PartOf& part : parts) study.parts.push_back(study_part(plan, part));
  return study;
}

/// What would be recommended if every run held.
double unmeasured_limit(const TuningPlan& plan, GainAxis axis, double share) {
  TuningResults results = results_without_lines(tuning_facts(plan));
  for (std::size_t i = 0; i < plan.contacts.situations.size(); ++i) {
    const TuningSetup setup = tuning_setup(plan, i, hand_grips[0]);
    TuningColumn column;
    column.damping = share * most_damping(setup, axis);
    const TheoryLimits theory = theory_limits(setup, axis, share);
    column.theory_released = theory.released;
    column.theory_released_any_swing = theory.released_any_swing;
    column.stable.stiffness = column.good.stiffness = infinity;
    TuningLine line;
    line.situation = i;
    line.axis = axis;
    line.columns.push_back(column);
    results.lines.push_back(line);
  }
  return recommend(results, axis)->stiffness;
}

/// What the linear contacts allow in a light hand, with the margin of a recommendation.
double stable_in_theory(const TuningPlan& plan, GainAxis axis, double share) {
  double out = infinity;
  for (std::size_t i = 0; i < plan.contacts.situations.size(); ++i)
    out = std::min(out, theory_limits(tuning_setup(plan, i, hand_grips[0]), axis, share).stable);
  return out / stability_margin;
}

/// The stiffest that a damper may allow; among equal ones the least damping.
std::optional<DamperInTheory> damper_in_theory(const TuningPlan& plan) {
  if (plan.request.coupling.mode != Coupling::Mode::object) return std::nullopt;
  const TuningSetup setup = tuning_setup(plan, hardest(plan), hand_grips[0]);
  std::optional<DamperInTheory> out;
  for (const double share : damping_shares(setup, GainAxis::damped)) {
    const double stiffness = std::min(unmeasured_limit(plan, GainAxis::damped, share),
                                      stable_in_theory(plan, GainAxis::damped, share));
    if (share > 0 && (!out || stiffness > out->stiffness))
      out = {stiffness, share * most_damping(setup, GainAxis::damped)};
  }
  return out;
}

std::vector<Look> looks_to_take(const TuningPlan& plan) {
  const TuningSetup setup = tuning_setup(plan, hardest(plan), hand_grips[0]);
  std::vector<Look> looks;
  for (const GainAxis axis : main_axes(plan.request))
    for (const double share : damping_shares(setup, axis))
      looks.push_back({.axis = axis, .share = share});
  return looks;
}

/// Looks at the hardest situation at each damping. The one that allows most comes first, among
/// equal ones the least damping, and both dampers before each alone. Theory alone would choose
/// dampings at which the real loop chatters.
std::vector<Look> looks_at_hardest(const std::shared_ptr<const TuningPlan>& plan, unsigned threads,
                                   const Stop& stop) {
  std::vector<Look> looks = looks_to_take(*plan);
  run_parallel(looks.size(), threads, [&](std::size_t i) {
    Look& look = looks[i];
    look.unmeasured = look.allowed = unmeasured_limit(*plan, look.axis, look.share);
    if (looks.size() == 1) return;  // nothing to choose from
    const Study study = study_of(plan, {first_look_at(hardest(*plan), look, look.unmeasured)});
    look.result = compute_at_once(study, 1, stop);
    const auto there = recommend(read_tuning("", look.result), look.axis);
    look.allowed = std::min(look.unmeasured, there->stiffness);
  });
  std::ranges::stable_sort(looks, std::greater{}, &Look::allowed);
  return looks;
}

/// The one at the hardest situation, and the same of the others at its damping.
StudyFolder first_look(const std::shared_ptr<const TuningPlan>& plan, const Look& look,
                       unsigned threads, const Stop& stop) {
  std::vector<PartOf> parts;
  for (std::size_t i = 0; i < plan->contacts.situations.size(); ++i)
    if (i != hardest(*plan) || look.result.names.empty())
      parts.push_back(first_look_at(i, look, look.allowed));
  StudyFolder out = compute_at_once(study_of(plan, parts), threads, stop);
  out.names.insert(out.names.end(), look.result.names.begin(), look.result.names.end());
  out.results.insert(out.results.end(), look.result.results.begin(), look.result.results.end());
  return out;
}

}  // namespace

std::shared_ptr<const TuningPlan> study_plan(const TuningRequest& request, unsigned threads,
                                             const Stop& stop,
                                             const std::function<void(double)>& progress) {
  // Contacts take half of the time or more.
  const auto part = [&](double from, double to) {
    return [&progress, from, to](double done) {
      if (progress) progress(from + (to - from) * done);
    };
  };
  const auto plan = std::make_shared<TuningPlan>(tuning_plan(request, stop, part(0, 0.5), threads));
  plan->damper = damper_in_theory(*plan);
  const std::vector<Look> looks = looks_at_hardest(plan, threads, stop);
  part(0.5, 1)(0.5);
  // The best gains in the hardest contact may fail in another, and no other contact allows more
  // there.
  for (const Look& look : looks) {
    if (&look != &looks.front() && look.allowed <= plan->held_stiffness) break;
    StudyFolder all = first_look(plan, look, threads, stop);
    const double stiffness = recommend(read_tuning("", all), look.axis)->stiffness;
    if (&look != &looks.front() && stiffness <= plan->held_stiffness) continue;
    plan->axis = look.axis;
    plan->damping_share = look.share;
    plan->held_stiffness = stiffness;
    plan->unmeasured = look.unmeasured;
    plan->first_look = std::move(all);
  }
  if (!(plan->held_stiffness > 0)) {
    for (const Look& look : looks)
      if (look.axis == plan->axis) plan->dampings.push_back({look.share, look.unmeasured});
    ordering::sort(plan->dampings, std::less<>(), &DampingToTry::share);
  }
  return plan;
}

Study plan_tuning(const std::shared_ptr<const TuningPlan>& plan) {
  Study study = study_of(plan, parts_of(*plan));
  // The longest part, so it begins first. Also where the first look allows nothing: other parts may
  // allow more, and what was never tried is not recommended.
  study.parts.insert(study.parts.begin(), {ladder_part, [plan](const Stop& stop) {
                                             return to_json(climb_down(*plan, stop));
                                           }});
  Json about = Json::parse(study.about);
  about["held_stiffness"] = plan->held_stiffness;
  study.about = about.dump();
  return study;
}

Study plan_tuning(const TuningRequest& request, unsigned threads, const Stop& stop,
                  const std::function<void(double)>& progress) {
  return plan_tuning(study_plan(request, threads, stop, progress));
}

}  // namespace sonde
