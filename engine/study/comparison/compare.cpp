// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/compare.hpp"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/settings/settings.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double trembling_from = 50;  // Hz: no hand moves this fast
constexpr std::size_t analytic_ticks = 24;

Json about(const CompareSetup& setup) {
  const Coupling& c = setup.render.coupling;
  return {{"scene", setup.scene},
          {"inputs", Json::parse(setup.inputs)},
          {"coupling",
           {{"mode", name_of(c.mode)},
            {"k", c.k},
            {"k_t", c.k_t},
            {"k_r", c.k_r},
            {"b_t", c.b_t},
            {"b_r", c.b_r},
            {"max_force", c.max_force},
            {"max_torque", c.max_torque}}},
          {"budget_steps", setup.render.budget.steps},
          {"seed", setup.render.search.seed},
          {"stiffness", stiffness_of(c)},
          {"radius", setup.render.pair.probe().mass.radius},
          {"ticks", setup.path.size()}};
}

std::vector<Vec3> forces(const Rendering& rendering) {
  std::vector<Vec3> out;
  for (const RenderedTick& tick : rendering) out.push_back(tick.force);
  return out;
}

std::vector<Vec3> torques(const Rendering& rendering) {
  std::vector<Vec3> out;
  for (const RenderedTick& tick : rendering) out.push_back(tick.torque);
  return out;
}

double peak(const std::vector<Vec3>& x) {
  double out = 0;
  for (const Vec3& v : x) out = std::max(out, v.norm());
  return out;
}

MethodMeasures measure(const Rendering& rendering, const AnalyticWrenches& analytic,
                       const Comparison& in) {
  MethodMeasures out;
  const std::vector<Vec3> force = forces(rendering), torque = torques(rendering);
  out.peak_force = peak(force);
  out.peak_torque = peak(torque);
  out.force_variation = total_variation(force);
  out.torque_variation = total_variation(torque);
  std::vector<double> times;
  for (const RenderedTick& tick : rendering) times.push_back(tick.t);
  if (const auto rate = sample_rate(times)) {
    out.force_above_50 = share_above(spectrum(force, *rate), trembling_from);
    out.torque_above_50 = share_above(spectrum(torque, *rate), trembling_from);
  }
  out.discontinuities = discontinuities(rendering, in.stiffness, in.radius);
  out.realism = torque_realism(rendering, analytic, in.radius);
  for (const RenderedTick& tick : rendering) {
    out.deepest = std::max(out.deepest, tick.depth);
    out.contact_ticks += !tick.force.isZero(0);
    out.failed_ticks += tick.failed;
    out.unconverged_ticks += !tick.converged;
    out.saturated_ticks += tick.force.norm() > in.max_force || tick.torque.norm() > in.max_torque;
  }
  return out;
}

}  // namespace

Study compare_study(const CompareSetup& setup) {
  const auto own = std::make_shared<const CompareSetup>(setup);
  const auto rendering = [own](Method method) {
    return [own, method](const Stop& stop) {
      return to_json(render(own->render, method, own->path, stop));
    };
  };
  Study study{"compare",
              about(setup).dump(),
              {{"pdt", rendering(Method::pdt)},
               {"pdg", rendering(Method::pdg)},
               {"analytic", [own](const Stop& stop) {
                  return to_json(analytic_wrenches(own->render, own->path, own->render.search.seed,
                                                   analytic_ticks, stop));
                }}}};
  if (!setup.device) return study;
  const auto stiffness = [own](Method method) {
    return [own, method](const Stop& stop) {
      return to_json(
          stable_stiffness(own->render, method, own->path, *own->device, own->sample_time, stop));
    };
  };
  study.parts.push_back({"stiffness-pdt", stiffness(Method::pdt)});
  study.parts.push_back({"stiffness-pdg", stiffness(Method::pdg)});
  return study;
}

Comparison comparison_of(const std::string& folder, const StudyFolder& study) {
  const auto part = [&](const std::string& name) {
    const auto at = std::ranges::find(study.names, name);
    const auto i = static_cast<std::size_t>(at - study.names.begin());
    if (at == study.names.end() || !study.results.at(i))
      throw InputError::in(folder, "the part " + name + " is missing");
    return *study.results[i];
  };
  Comparison out;
  try {
    const Json about = Json::parse(study.about);
    out.scene = about.at("scene");
    out.stiffness = about.at("stiffness");
    out.radius = about.at("radius");
    out.max_force = about.at("coupling").at("max_force");
    out.max_torque = about.at("coupling").at("max_torque");
  } catch (const Json::exception& error) {
    throw InputError::in(folder, std::string("is of no comparison: ") + error.what());
  }
  const AnalyticWrenches analytic =
      analytic_wrenches_of(part("analytic"), folder + "/parts/analytic.json");
  out.pdt = rendering_of(part("pdt"), folder + "/parts/pdt.json");
  out.pdg = rendering_of(part("pdg"), folder + "/parts/pdg.json");
  out.of_pdt = measure(out.pdt, analytic, out);
  out.of_pdg = measure(out.pdg, analytic, out);
  if (std::ranges::find(study.names, "stiffness-pdt") == study.names.end()) return out;
  out.of_pdt.stiffness = stable_stiffness_of(part("stiffness-pdt"), folder);
  out.of_pdg.stiffness = stable_stiffness_of(part("stiffness-pdg"), folder);
  return out;
}

}  // namespace sonde
