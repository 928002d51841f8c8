// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_study.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "engine/base/elementary.hpp"
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
            // The results of an axis alone, or with another damper, are only for the map, and
            // nothing is recommended from them.
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

/// A coarse part in a light hand.
PartOf first_look_at(std::size_t situation, GainAxis axis, double share) {
  PartOf part{situation, &hand_grips[0], axis, {share}};
  part.first_look = true;
  return part;
}

Study study_of(const std::shared_ptr<const TuningPlan>& plan, const std::vector<PartOf>& parts) {
  Study study{"tune", tuning_facts(*plan), {}};
  for (const PartOf& part : parts) study.parts.push_back(study_part(plan, part));
  return study;
}

/// A first look at one contact, at one damping.
struct Look {
  GainAxis axis = GainAxis::object;
  double share = 0;    ///< of the largest damping
  StudyFolder result;  ///< of one part
  double allowed = 0;  ///< N/m
};

/// Looks at the hardest situation at each damping. The one that allows most comes first, among
/// equal ones the least damping, and both dampers before each alone. Theory alone would choose
/// dampings at which the real loop chatters.
std::vector<Look> looks_at_hardest(const std::shared_ptr<const TuningPlan>& plan, unsigned threads,
                                   const Stop& stop) {
  const std::size_t where = hardest(*plan);
  const TuningSetup setup = tuning_setup(*plan, where, hand_grips[0]);
  std::vector<Look> looks;
  for (const GainAxis axis : main_axes(plan->request))
    for (const double share : damping_shares(setup, axis))
      looks.push_back({.axis = axis, .share = share, .result = {}});
  run_parallel(looks.size(), threads, [&](std::size_t i) {
    Look& look = looks[i];
    const Study study = study_of(plan, {first_look_at(where, look.axis, look.share)});
    look.result = compute_at_once(study, 1, stop);
    look.allowed = recommend(read_tuning("", look.result), look.axis)->stiffness;
  });
  std::ranges::stable_sort(looks, std::greater{}, &Look::allowed);
  return looks;
}

/// The look at the hardest situation, and those at the other situations at its damping.
StudyFolder first_look(const std::shared_ptr<const TuningPlan>& plan, const Look& at_hardest,
                       unsigned threads, const Stop& stop) {
  std::vector<PartOf> others;
  for (std::size_t i = 0; i < plan->contacts.situations.size(); ++i)
    if (i != hardest(*plan)) others.push_back(first_look_at(i, at_hardest.axis, at_hardest.share));
  StudyFolder out = compute_at_once(study_of(plan, others), threads, stop);
  out.names.push_back(at_hardest.result.names.front());
  out.results.push_back(at_hardest.result.results.front());
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
  const auto plan = std::make_shared<TuningPlan>(tuning_plan(request, stop, part(0, 0.5)));
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
    plan->first_look = std::move(all);
  }
  return plan;
}

Study plan_tuning(const std::shared_ptr<const TuningPlan>& plan) {
  Study study = study_of(plan, parts_of(*plan));
  // The longest part, so it begins first.
  if (plan->held_stiffness > 0)
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
