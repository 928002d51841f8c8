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
    return SampledContact{device, sample_time, felt.stiffness(setup.coupling),
                          felt.damping(setup.coupling)};
  };
  SituationOptions options;
  options.method = method;
  options.seed = setup.search.seed;
  options.hardness = [&](const FeltStiffness& felt) {
    return 1 / std::max(largest_stable_factor(contact(felt)), 1e-12);
  };
  double stable = std::numeric_limits<double>::infinity(), passive = stable;
  for (const ContactSituation& s : situations_along(setup.pair, path, 1, options, stop)) {
    stable = std::min(stable, asked * largest_stable_factor(contact(s.stiffness)));
    passive = std::min(passive, asked * largest_passive_factor(contact(s.stiffness)));
  }
  return {end_of(stable), end_of(passive)};
}

std::string to_json(const StableStiffness& stiffness) {
  const auto value = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  const Json json{{"stable", value(stiffness.stable)}, {"passive", value(stiffness.passive)}};
  return json.dump() + "\n";
}

StableStiffness stable_stiffness_of(const std::string& json, const std::string& source) {
  try {
    const Json whole = Json::parse(json);
    const auto value = [&](const char* key) {
      const Json& x = whole.at(key);
      return x.is_null() ? std::nullopt : std::optional(x.get<double>());
    };
    return {value("stable"), value("passive")};
  } catch (const Json::exception& error) {
    throw InputError::in(source, std::string("holds no stiffness: ") + error.what());
  }
}

}  // namespace sonde
