// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/stable_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/study/stability/contact_situations.hpp"
#include "engine/study/stability/contact_stability.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> end_of(double stiffness) {
  return std::isfinite(stiffness) ? std::optional(stiffness) : std::nullopt;
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
                          method == Method::pdg && setup.coupling.mode == Coupling::Mode::object};
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
  return {end_of(stable), end_of(passive), end_of(held), lever};
}

std::string to_json(const StableStiffness& stiffness) {
  const auto value = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  const Json json{{"stable", value(stiffness.stable)},
                  {"passive", value(stiffness.passive)},
                  {"passive_in_translation", value(stiffness.passive_in_translation)},
                  {"cycle_lever", stiffness.cycle_lever}};
  return json.dump() + "\n";
}

StableStiffness stable_stiffness_of(const std::string& json, const std::string& source) {
  try {
    const Json whole = Json::parse(json);
    const auto value = [&](const char* key) {
      const Json x = whole.value(key, Json());
      return x.is_null() ? std::nullopt : std::optional(x.get<double>());
    };
    return {value("stable"), value("passive"), value("passive_in_translation"),
            whole.value("cycle_lever", 0.0)};
  } catch (const Json::exception& error) {
    throw InputError::in(source, std::string("holds no stiffness: ") + error.what());
  }
}

}  // namespace sonde
