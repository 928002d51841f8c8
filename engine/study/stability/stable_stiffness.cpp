// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/stable_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/study/stability/closed_loop.hpp"
#include "engine/study/stability/contact_situations.hpp"
#include "engine/study/stability/contact_stability.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> end_of(double stiffness) {
  return std::isfinite(stiffness) ? std::optional(stiffness) : std::nullopt;
}

using ContactOf = std::function<SampledContact(const FeltStiffness&)>;

std::vector<StableStiffness::ForceAtLimit> limits_along(const RenderSetup& setup, Method method,
                                                        std::span<const TimedPose> path,
                                                        const ContactOf& contact,
                                                        const Stop& stop) {
  constexpr Budget budget{.steps = 60};
  constexpr double step = 0.03;  // of the depth, as for the situations
  const MassProperties& mass = setup.pair.probe().mass;
  std::vector<StableStiffness::ForceAtLimit> out;
  CoherentSolver solver(setup.pair, method);
  const std::size_t every = path.size() / limits_looked_at + 1;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (stop()) throw Cancelled();
    const Separation& s = i == 0 ? solver.reset(path[i].pose) : solver.tick(path[i].pose, budget);
    if (i % every != 0 || s.status != Status::penetrating || !s.converged || s.contacts.size == 0)
      continue;
    const auto felt = felt_stiffness(setup.pair, method, s.device, s.separated, step * s.depth);
    if (!felt) continue;
    const double factor = largest_stable_factor(contact(*felt));
    const double force = spring_wrench(mass, s, setup.coupling).force.norm();
    if (std::isfinite(factor) && force > 0) out.push_back({i, factor * force});
  }
  return out;
}

}  // namespace

StableStiffness stable_stiffness(const RenderSetup& setup, Method method,
                                 std::span<const TimedPose> path,
                                 const SimulatedDeviceParameters& device, double sample_time,
                                 const Stop& stop) {
  const double asked = stiffness_of(setup.coupling);
  const auto contact = [&](const FeltStiffness& felt) {
    return SampledContact{device,
                          sample_time,
                          felt.stiffness(setup.coupling),
                          Mat6::Zero(),
                          felt.damping(setup.coupling),
                          method == Method::pdg && in_object_norm(setup.coupling.mode)};
  };
  SituationOptions options;
  options.method = method;
  options.seed = setup.search.seed;
  options.hardness = [&](const FeltStiffness& felt) {
    return 1 / std::max(largest_stable_factor(contact(felt)), 1e-12);
  };
  double stable = std::numeric_limits<double>::infinity(), passive = stable, held = stable;
  double lever = 0;
  for (const ContactSituation& s : situations_along(setup.pair, path, 1, options, stop)) {
    stable = std::min(stable, asked * largest_stable_factor(contact(s.stiffness)));
    passive = std::min(passive, asked * largest_passive_factor(contact(s.stiffness)));
    held = std::min(held, asked * largest_passive_factor_in_translation(contact(s.stiffness)));
    lever = std::max(lever, cycle_lever(contact(s.stiffness)));
  }
  return {end_of(stable), end_of(passive), end_of(held), lever,
          limits_along(setup, method, path, contact, stop)};
}

std::string to_json(const StableStiffness& stiffness) {
  const auto value = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  Json limits = Json::array();
  for (const auto& limit : stiffness.limits) limits.push_back({limit.tick, limit.force});
  const Json json{{"stable", value(stiffness.stable)},
                  {"passive", value(stiffness.passive)},
                  {"passive_in_translation", value(stiffness.passive_in_translation)},
                  {"cycle_lever", stiffness.cycle_lever},
                  {"limits", limits}};
  return json.dump() + "\n";
}

StableStiffness stable_stiffness_of(const std::string& json, const std::string& source) {
  try {
    const Json whole = Json::parse(json);
    const auto value = [&](const char* key) {
      const Json x = whole.value(key, Json());
      return x.is_null() ? std::nullopt : std::optional(x.get<double>());
    };
    StableStiffness out{value("stable"), value("passive"), value("passive_in_translation"),
                        whole.value("cycle_lever", 0.0)};
    for (const Json& limit : whole.value("limits", Json::array()))
      out.limits.push_back({limit.at(0).get<std::size_t>(), limit.at(1).get<double>()});
    return out;
  } catch (const Json::exception& error) {
    throw InputError::in(source, std::string("holds no stiffness: ") + error.what());
  }
}

}  // namespace sonde
