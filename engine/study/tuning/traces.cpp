// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/traces.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/elementary.hpp"
#include "engine/base/error.hpp"
#include "engine/body/body.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double stiffness_shares[] = {0.25, 0.5, 1, 1.5};  // of the theoretical limit
constexpr double damping_of_largest[] = {0, 0.25, 1};

/// Rounded to three digits, for readability.
double rounded(double value) {
  const double digits = elementary::pow(10, 2 - std::floor(elementary::log10(value)));
  return std::round(value * digits) / digits;
}

std::vector<double> stiffness_of(const TracesRequest& request, const TuningSetup& setup,
                                 GainAxis axis) {
  if (!request.stiffness.empty()) return request.stiffness;
  const double theory = theory_limits(setup, axis, 0).stable;
  const bool known = std::isfinite(theory) && theory > 0;
  const double allowed = known ? theory : std::sqrt(setup.low * setup.high);
  std::vector<double> out;
  for (const double share : stiffness_shares) out.push_back(rounded(share * allowed));
  return out;
}

std::vector<double> damping_of(const TracesRequest& request, const TuningSetup& setup,
                               GainAxis axis) {
  if (axis == GainAxis::object) return {0};
  if (!request.damping.empty()) return request.damping;
  const double most = most_damping(setup, axis);
  if (!(most > 0)) return {0};
  std::vector<double> out;
  for (const double share : damping_of_largest) out.push_back(share * most);
  return out;
}

std::size_t situation_of(const TracesRequest& request, const TuningPlan& plan) {
  if (!request.kind) return hardest(plan);
  const auto& all = plan.contacts.situations;
  const auto found = std::ranges::find_if(
      all, [&](const TuningSituation& each) { return each.contact.kind == *request.kind; });
  if (found == all.end())
    throw InputError(std::string("no ") + name_of(*request.kind) +
                     " contact was found in which a hand could hold the probe still");
  return static_cast<std::size_t>(found - all.begin());
}

Json value_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const TimeTrace& trace) {
  Json samples = Json::array();
  for (const TraceSample& s : trace.samples) {
    const Vec3 &f = s.motors.force, &m = s.motors.torque;
    samples.push_back({s.t, f.x(), f.y(), f.z(), m.x(), m.y(), m.z(), s.depth});
  }
  const TraceFigures& f = trace.figures;
  return {{"force", f.force},         {"settling_time", value_or_null(f.settling_time)},
          {"overshoot", f.overshoot}, {"energy", f.energy},
          {"chatter", f.chatter},     {"jumps", f.jumps},
          {"failures", f.failures},   {"samples", samples}};
}

StudyPart part(const std::shared_ptr<const TuningSetup>& setup, GainAxis axis, HandCourse course,
               const std::string& name, double stiffness, double damping) {
  return {name, [=](const Stop&) {
            ClosedLoopSetup loop = setup->loop;
            set_gains(loop.coupling, axis, stiffness, damping, setup->joint);
            ClosedLoop closed(loop);
            const TuningSituation& situation = setup->situation;
            const CoursePlace place = course_place(situation.contact.separation.separated,
                                                   situation.push, loop.pair.probe().mass.radius);
            Json json{{"course", name_of(course)}, {"stiffness", stiffness}, {"damping", damping}};
            json.update(json_of(trace(closed, course, place)));
            return json.dump() + "\n";
          }};
}

}  // namespace

Study plan_traces(const TracesRequest& request, const Stop& stop,
                  const std::function<void(double)>& progress) {
  const TuningPlan plan = tuning_plan(request.tuning, stop, progress);
  const std::size_t situation = situation_of(request, plan);
  const auto setup =
      std::make_shared<const TuningSetup>(tuning_setup(plan, situation, request.hand));
  const GainAxis axis = main_axis(plan.request);
  const std::vector<double> stiffness = stiffness_of(request, *setup, axis);
  const std::vector<double> damping = damping_of(request, *setup, axis);
  const double theory = theory_limits(*setup, axis, 0).stable;
  Json about = Json::parse(tuning_facts(plan));
  about["situation"] = name_of(setup->situation.contact.kind);
  about["hand"] = {{"stiffness", request.hand.stiffness}, {"damping", request.hand.damping}};
  about["theory_stable"] = std::isfinite(theory) ? Json(theory) : Json(nullptr);
  about["stiffness"] = stiffness;
  about["damping"] = damping;
  Study study{"traces", about.dump(), {}};
  for (const HandCourse course : all_hand_courses)
    for (std::size_t i = 0; i < stiffness.size(); ++i)
      for (std::size_t j = 0; j < damping.size(); ++j) {
        const std::string name =
            std::string(name_of(course)) + ".k" + std::to_string(i) + ".b" + std::to_string(j);
        study.parts.push_back(part(setup, axis, course, name, stiffness[i], damping[j]));
      }
  return study;
}

}  // namespace sonde
