// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/compare.hpp"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double trembling_from = 50;  // Hz: no hand moves so fast
constexpr std::size_t analytic_ticks = 24;

Json about(const CompareSetup& setup) {
  const Coupling& c = setup.render.coupling;
  const bool object = c.mode == Coupling::Mode::object;
  return {{"scene", setup.scene},
          {"inputs", Json::parse(setup.inputs)},
          {"coupling",
           {{"mode", object ? "object" : "classic"},
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

/// Whether less is found of PD_g than of PD_t.
Verdict less(double pdg, double pdt) {
  if (pdg == pdt || std::abs(pdg - pdt) <= 0.02 * std::max(pdg, pdt)) return Verdict::same;
  return pdg < pdt ? Verdict::holds : Verdict::fails;
}

Verdict both(Verdict a, Verdict b) {
  if (a == b || b == Verdict::same || b == Verdict::none) return a;
  if (a == Verdict::same || a == Verdict::none) return b;
  return Verdict::mixed;
}

Verdict less(const std::optional<double>& pdg, const std::optional<double>& pdt) {
  if (!pdg && !pdt) return Verdict::none;
  return less(pdg.value_or(0), pdt.value_or(0));  // no share: nothing at all was felt
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

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::fails:
      return "fails";
    case Verdict::same:
      return "same";
    case Verdict::mixed:
      return "mixed";
    case Verdict::none:
      break;
  }
  return "none";
}

Verdict smoother_force(const Comparison& c) {
  return both(less(c.of_pdg.force_above_50, c.of_pdt.force_above_50),
              less(c.of_pdg.force_variation, c.of_pdt.force_variation));
}

Verdict smoother_torque(const Comparison& c) {
  return both(less(c.of_pdg.torque_above_50, c.of_pdt.torque_above_50),
              less(c.of_pdg.torque_variation, c.of_pdt.torque_variation));
}

Verdict fewer_steps(const Comparison& c) {
  const auto steps = [](const MethodMeasures& m) {
    return m.discontinuities.force_steps + m.discontinuities.torque_steps;
  };
  return less(steps(c.of_pdg), steps(c.of_pdt));
}

Verdict better_torque(const Comparison& c) {
  if (c.of_pdg.realism.ticks == 0) return Verdict::none;
  return less(c.of_pdg.realism.torque_error, c.of_pdt.realism.torque_error);
}

Verdict fewer_pop_throughs(const Comparison& c) {
  return less(c.of_pdg.discontinuities.pop_throughs, c.of_pdt.discontinuities.pop_throughs);
}

}  // namespace sonde
