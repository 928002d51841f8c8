// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/rest_ladder.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/error.hpp"
#include "engine/text/json_numbers.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double fine_step = 1.15;
// A first look knows its limits to a ratio of 1.3; its own result is a rung.
constexpr double above_first_look = fine_step * fine_step;
constexpr double coarse_step = 1.3;
// Shares of the first look: parts still to come lower it mostly no further than to the one, and
// seldom further than to the other.
constexpr double looked_below = 0.9;
constexpr double seldom_below = 0.5;
constexpr double lowest = 1.0 / 8;
constexpr double rounding = 1 + 1e-9;

/// The conditions of a hold.
struct Condition {
  double friction, knock;
};

/// The hardest first, so that a failing rung ends early.
std::vector<Condition> conditions(const TuningPlan& plan) {
  const DeviceProfile& device = plan.request.device;
  const bool rubs = device.friction.value > 0 || device.rotational_friction.value > 0;
  std::vector<Condition> out;
  for (const double friction : {0.0, 1.0}) {
    if (friction == 0 && rubs && plan.request.trusts_friction) continue;
    if (friction > 0 && !rubs) continue;
    for (const double knock : {4.0, 1.0, 2.0}) out.push_back({friction, knock});
  }
  return out;
}

std::vector<HandGrip> hands() {
  std::vector<HandGrip> out{limp_hand};
  out.insert(out.end(), std::begin(hand_grips), std::end(hand_grips));
  return out;
}

double damping_of(const TuningPlan& plan, double share) {
  const TuningSetup setup = tuning_setup(plan, 0, hand_grips[0]);
  return share * most_damping(setup, plan.axis);
}

/// Records the first swing, if any.
class Climb {
 public:
  Climb(const TuningPlan& plan, double share, const Stop& stop)
      : plan_(plan),
        stop_(stop),
        axis_(plan.axis),
        share_(share),
        damping_(damping_of(plan, share)),
        conditions_(conditions(plan)) {}

  Rung at(double stiffness) const {
    Rung rung{.stiffness = stiffness, .swing = {}};
    for (const HandGrip& hand : hands())
      for (std::size_t i = 0; i < plan_.contacts.situations.size(); ++i)
        for (const Condition& met : conditions_)
          if (!rests(rung, i, hand, met)) return rung;
    return rung;
  }

 private:
  bool rests(Rung& rung, std::size_t situation, const HandGrip& hand, const Condition& met) const {
    if (stop_()) throw Cancelled();
    TuningSetup setup = ladder_setup(plan_, situation, hand);
    setup.loop.device.translation.friction *= met.friction;
    setup.loop.device.rotation.friction *= met.friction;
    const RestReport report = hold_until_rest(setup, axis_, rung.stiffness, damping_, met.knock);
    rung.longest = std::max(rung.longest, report.time);
    if (report.at_rest) return true;
    rung.swing = Swing{name_of(setup.situation.contact.kind),
                       hand.name,
                       met.friction,
                       met.knock,
                       report.failures > 0 ? 0 : report.swing,
                       report.failures > 0 ? 0 : report.frequency,
                       theory_limits(setup, axis_, share_).stable};
    return false;
  }

  const TuningPlan& plan_;
  const Stop& stop_;
  GainAxis axis_;
  double share_, damping_;
  std::vector<Condition> conditions_;
};

/// Where the first look found nothing, any stiffness that theory and the device allow may be what
/// the parts still to come allow, so each of these is tried, whichever comes to rest. The stiffest
/// first.
std::vector<double> without_first_look(const TuningPlan& plan, const DampingToTry& at) {
  double most = std::min(at.unmeasured, plan.request.high);
  for (std::size_t i = 0; i < plan.contacts.situations.size(); ++i)
    most = std::min(
        most, theory_limits(tuning_setup(plan, i, hand_grips[0]), plan.axis, at.share).stable);
  std::vector<double> out;
  const double least = std::max(plan.request.low, lowest * most);
  for (double k = most; k >= least && k > 0; k /= coarse_step) out.push_back(k);
  return out;
}

/// The ladder of the damping at which the stiffest came to rest; among equal ones, and where none
/// did, the least damping.
RestLadder climb_at_each_damping(const TuningPlan& plan, const Stop& stop) {
  std::vector<DampingToTry> dampings = plan.dampings;
  if (dampings.empty()) dampings.push_back({plan.damping_share, plan.unmeasured});
  std::optional<RestLadder> best;
  const auto held = [](const RestLadder& ladder) {
    const Rung* rung = ladder.held(infinity);
    return rung ? rung->stiffness : 0;
  };
  for (const DampingToTry& at : dampings) {
    const Climb climb(plan, at.share, stop);
    RestLadder ladder{plan.axis, damping_of(plan, at.share), {}};
    for (const double k : without_first_look(plan, at)) ladder.rungs.push_back(climb.at(k));
    if (!best || held(ladder) > held(*best)) best = std::move(ladder);
  }
  return *best;
}

Json json_of(const Swing& swing) {
  return {{"situation", swing.kind},
          {"hand", swing.hand},
          {"friction", swing.friction},
          {"knock", swing.knock},
          {"amplitude", number_or_null(swing.amplitude)},
          {"frequency", number_or_null(swing.frequency)},
          {"theory_stable", number_or_null(swing.theory_stable)}};
}

Swing swing_of(const Json& json) {
  const auto number = [&](const char* key) {
    const Json& value = json.at(key);
    return value.is_null() ? infinity : value.get<double>();
  };
  return {json.at("situation").get<std::string>(),
          json.at("hand").get<std::string>(),
          number("friction"),
          number("knock"),
          number("amplitude"),
          number("frequency"),
          number("theory_stable")};
}

}  // namespace

TuningSetup ladder_setup(const TuningPlan& plan, std::size_t situation, const HandGrip& hand) {
  TuningSetup setup = tuning_setup(plan, situation, hand);
  const double share = std::min(1.0, hand.stiffness / hand_grips[0].stiffness);
  setup.situation.push.force *= share;
  setup.situation.push.torque *= share;
  return setup;
}

const Rung* RestLadder::held(double stiffness) const {
  const auto holds = [&](const Rung& rung) {
    return !rung.swing && rung.stiffness <= stiffness * rounding;
  };
  const auto found = std::ranges::find_if(rungs, holds);
  return found == rungs.end() ? nullptr : &*found;
}

const Rung* RestLadder::failed(double over, double stiffness) const {
  const Rung* out = nullptr;
  for (const Rung& rung : rungs)
    if (rung.swing && rung.stiffness > over && rung.stiffness <= stiffness) out = &rung;
  return out;
}

RestLadder climb_down(const TuningPlan& plan, const Stop& stop) {
  const double first = plan.held_stiffness;
  if (!(first > 0)) return climb_at_each_damping(plan, stop);
  const Climb climb(plan, plan.damping_share, stop);
  RestLadder out{plan.axis, damping_of(plan, plan.damping_share), {}};
  for (double k = above_first_look * first; k > lowest * first;) {
    if (k <= plan.unmeasured * rounding) out.rungs.push_back(climb.at(k));
    const bool enough = k < looked_below * first && out.held(k);
    if (enough && k <= seldom_below * first) break;
    k = enough ? seldom_below * first : k > looked_below * first ? k / fine_step : k / coarse_step;
  }
  return out;
}

std::string to_json(const RestLadder& ladder) {
  Json rungs = Json::array();
  for (const Rung& rung : ladder.rungs)
    rungs.push_back({{"stiffness", rung.stiffness},
                     {"longest", rung.longest},
                     {"swing", rung.swing ? json_of(*rung.swing) : Json(nullptr)}});
  const Json out{{"axis", name_of(ladder.axis)}, {"damping", ladder.damping}, {"rungs", rungs}};
  return out.dump(1) + "\n";
}

RestLadder rest_ladder_of(const std::string& json) {
  const Json whole = Json::parse(json);
  RestLadder out{
      gain_axis_named(whole.at("axis").get<std::string>()), whole.at("damping").get<double>(), {}};
  for (const Json& each : whole.at("rungs")) {
    Rung rung{.stiffness = each.at("stiffness").get<double>(),
              .swing = {},
              .longest = each.at("longest").get<double>()};
    if (!each.at("swing").is_null()) rung.swing = swing_of(each.at("swing"));
    out.rungs.push_back(std::move(rung));
  }
  return out;
}

}  // namespace sonde
