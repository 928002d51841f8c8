// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/gain_recommendation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/base/numbers.hpp"
#include "engine/settings/settings.hpp"
#include "engine/study/tuning/profile_limits.hpp"

namespace sonde {
namespace {

using Lines = std::vector<const TuningLine*>;
using Profile = std::map<std::string, double>;

Lines lines_where(const TuningResults& results,
                  const std::function<bool(const TuningLine&)>& wanted) {
  Lines out;
  for (const TuningLine& line : results.lines)
    if (wanted(line)) out.push_back(&line);
  return out;
}

const TuningColumn* column_at(const TuningLine& line, double damping) {
  const auto found = std::ranges::find(line.columns, damping, &TuningColumn::damping);
  return found == line.columns.end() ? nullptr : &*found;
}

void add_measured_limits(const TuningLine& line, const TuningColumn& column,
                         std::vector<GainLimit>& limits) {
  const auto add = [&](const char* reason, double stiffness) {
    limits.push_back({reason, stiffness, line.kind, line.hand});
  };
  if (column.stable.fault == HoldFault::none)
    add("range", column.stable.stiffness);
  else
    add("stability", column.stable.stiffness / stability_margin);
  if (column.good.fault != HoldFault::none && column.good.fault != HoldFault::unstable)
    add(name_of(column.good.fault), column.good.stiffness);
}

/// Adds the conditions beyond the normal hold: without friction, unless that is trusted, and at
/// harder knocks.
void add_hard_conditions(const TuningLine& line, const TuningColumn& column, bool trusts_friction,
                         std::vector<GainLimit>& limits) {
  const auto add = [&](const char* reason, const std::optional<SweepLimit>& limit) {
    if (limit && limit->fault != HoldFault::none)
      limits.push_back({reason, limit->stiffness / stability_margin, line.kind, line.hand});
  };
  if (!trusts_friction) add("friction", column.without_friction);
  // If the knocks change nothing, stability is the reason.
  if (column.harder_knocks && column.harder_knocks->stiffness < column.stable.stiffness)
    add("knocks", column.harder_knocks);
}

/// Lowers the boundary to a limit. Returns whether it did.
bool lower(double& boundary, const std::optional<SweepLimit>& limit) {
  if (!limit || limit->fault == HoldFault::none || limit->stiffness >= boundary) return false;
  boundary = limit->stiffness;
  return true;
}

/// Unknown if one of them is.
void lower(std::optional<double>& limit, const std::optional<double>& other) {
  if (!limit || !other)
    limit.reset();
  else
    limit = std::min(*limit, *other);
}

void add_long_hold(const TuningLine& line, const TuningColumn& column, AxisGains& out) {
  const auto add = [&](const char* reason, std::vector<GainLimit>& places) {
    places.push_back({reason, column.theory_stable, line.kind, line.hand});
  };
  out.held_at = column.long_hold->stiffness;
  if (column.long_hold->swings_without_friction) add("friction", out.swings_without_friction);
  if (column.long_hold->swings_at_harder_knocks) add("knocks", out.swings_at_harder_knocks);
}

/// The least limit for each reason, lowest first.
std::vector<GainLimit> least_of_each(std::vector<GainLimit> limits) {
  std::ranges::stable_sort(limits, {}, &GainLimit::stiffness);
  std::vector<GainLimit> out;
  for (const GainLimit& limit : limits)
    if (std::ranges::find(out, limit.reason, &GainLimit::reason) == out.end()) out.push_back(limit);
  return out;
}

/// What caps a recommendation once the hand lets go: a buzz. In the object norm a slower swing too,
/// since there only the loop can make one grow; classic gains have some at a few N/m.
double released_limit(const TuningColumn& column, GainAxis axis) {
  const double slow = column.theory_released_any_swing.value_or(infinity);
  return in_object_norm(axis) ? std::min(column.theory_released, slow) : column.theory_released;
}

AxisGains gains_at(const TuningResults& results, const Lines& lines, const Profile& device,
                   GainAxis axis, double damping) {
  AxisGains out{.axis = axis,
                .damping = damping,
                .boundary = infinity,
                .without_friction = infinity,
                .harder_knocks = infinity,
                .swings_without_friction = {},
                .swings_at_harder_knocks = {},
                .passive = infinity,
                .passive_in_translation = infinity,
                .released = infinity,
                .released_any_swing = infinity,
                .swings = {},
                .theory = infinity,
                .limit = {},
                .limits = {}};
  std::vector<GainLimit> limits;
  for (const TuningLine* line : lines) {
    const TuningColumn& column = *column_at(*line, damping);
    add_measured_limits(*line, column, limits);
    add_hard_conditions(*line, column, results.trusts_friction, limits);
    if (column.long_hold) add_long_hold(*line, column, out);
    lower(out.boundary, column.stable);
    if (lower(out.without_friction, column.without_friction))
      out.without_friction_by_theory = column.without_friction_by_theory;
    lower(out.harder_knocks, column.harder_knocks);
    out.passive = std::min(out.passive, column.theory_passive);
    out.passive_in_translation =
        std::min(out.passive_in_translation, column.theory_passive_in_translation);
    out.cycle_lever = std::max(out.cycle_lever, column.cycle_lever);
    out.released = std::min(out.released, column.theory_released);
    lower(out.released_any_swing, column.theory_released_any_swing);
    const double released = released_limit(column, axis);
    if (!results.always_held && std::isfinite(released))
      limits.push_back({"released", released / stability_margin, line->kind, std::string()});
    out.theory = std::min(out.theory, column.theory_stable);
  }
  add_profile_limits(results, lines, device, axis, damping, limits);
  out.limits = least_of_each(limits);
  out.limit = out.limits.front();
  out.stiffness = out.limit.stiffness;
  return out;
}

/// The damping that allows the largest stiffness; among equal ones the least. Every line of an axis
/// is swept at the same dampings.
std::optional<AxisGains> best(const TuningResults& results, const Lines& lines,
                              const Profile& device, GainAxis axis) {
  std::optional<AxisGains> out;
  if (lines.empty()) return out;
  for (const TuningColumn& column : lines.front()->columns) {
    const AxisGains gains = gains_at(results, lines, device, axis, column.damping);
    if (!out || gains.stiffness > out->stiffness) out = gains;
  }
  return out;
}

/// A line that varies an assumed value; all of them have the same situation, hand and damping.
const TuningLine* varied(const TuningResults& results, GainAxis axis) {
  for (const TuningLine& line : results.lines)
    if (line.axis == axis && !line.assumed.empty()) return &line;
  return nullptr;
}

/// Reduces the gains to the rung of the ladder that the limits allow.
AxisGains on_ladder(AxisGains gains, const RestLadder& ladder) {
  gains.tried = true;
  const Rung* held = ladder.held(gains.stiffness);
  const double stiffness = held ? held->stiffness : 0;
  const Rung* failed = ladder.failed(stiffness, gains.stiffness);
  if (held) gains.longest_to_rest = held->longest;
  if (failed) {
    gains.swings = failed->swing;
    gains.limit = {"rest", stiffness, failed->swing->kind, failed->swing->hand};
    gains.limits.insert(gains.limits.begin(), gains.limit);
  }
  gains.held_at = gains.stiffness = gains.limit.stiffness = stiffness;
  gains.swings_without_friction.clear();
  gains.swings_at_harder_knocks.clear();
  if (held || !gains.swings) return gains;
  const Swing& s = *gains.swings;
  const GainLimit place{s.friction == 0 ? "friction" : "knocks", s.theory_stable, s.kind, s.hand};
  (s.friction == 0 ? gains.swings_without_friction : gains.swings_at_harder_knocks)
      .push_back(place);
  return gains;
}

bool has_column(const Lines& lines, double damping) {
  return std::ranges::all_of(lines,
                             [&](const TuningLine* line) { return column_at(*line, damping); });
}

}  // namespace

LetGo if_let_go(const AxisGains& gains) {
  if (!(gains.stiffness > 0)) return LetGo::unknown;
  if (gains.stiffness > gains.released) return LetGo::buzz;
  if (!gains.released_any_swing)
    return std::isfinite(gains.released) ? LetGo::no_buzz : LetGo::unknown;
  return gains.stiffness > *gains.released_any_swing ? LetGo::slow_swing : LetGo::stable;
}

double largest_if_let_go(const AxisGains& gains) {
  return std::min(gains.released, gains.released_any_swing.value_or(infinity));
}

Coupling coupling_of(const AxisGains& gains, const JointGains& joint) {
  Coupling out;
  out.k = out.k_t = out.k_r = out.b_t = out.b_r = 0;
  set_gains(out, gains.axis, gains.stiffness, gains.damping, joint);
  return out;
}

DampingRatios damping_ratios(const TuningResults& results, const AxisGains& gains) {
  const Coupling c = coupling_of(gains, results.joint);
  const auto ratio = [&](const char* own, const char* inertia, double stiffness, double damping) {
    const auto found = results.device.find(own);
    if (found == results.device.end() || !(stiffness > 0)) return std::optional<double>();
    return std::optional((found->second + damping) /
                         (2 * std::sqrt(stiffness * results.device.at(inertia))));
  };
  return {ratio("damping", "mass", in_object_norm(gains.axis) ? c.k : c.k_t, c.b_t),
          ratio("rotational_damping", "inertia", c.k_r, c.b_r)};
}

std::optional<AxisGains> recommend(const TuningResults& results, GainAxis axis,
                                   const std::string& assumed, double times) {
  const Lines lines = lines_where(results, [&](const TuningLine& line) {
    return line.axis == axis && line.assumed == assumed && line.times == times;
  });
  Profile device = results.device;
  if (!assumed.empty()) device[assumed] *= times;
  const auto& ladder = results.ladder;
  const bool climbed = assumed.empty() && ladder && ladder->axis == axis;
  if (climbed && !lines.empty() && has_column(lines, ladder->damping))
    return on_ladder(gains_at(results, lines, device, axis, ladder->damping), *ladder);
  return best(results, lines, device, axis);
}

std::vector<AxisGains> recommend_at_each_damping(const TuningResults& results, GainAxis axis,
                                                 const std::string& kind) {
  const Lines lines = lines_where(results, [&](const TuningLine& line) {
    return line.axis == axis && line.assumed.empty() && (kind.empty() || line.kind == kind);
  });
  std::vector<AxisGains> out;
  if (lines.empty()) return out;
  for (const TuningColumn& column : lines.front()->columns)
    out.push_back(gains_at(results, lines, results.device, axis, column.damping));
  return out;
}

std::optional<GainLimit> allowed_at(const TuningResults& results, GainAxis axis, double damping,
                                    const std::string& kind) {
  const std::vector<AxisGains> each = recommend_at_each_damping(results, axis, kind);
  const auto recommended = recommend(results, axis);
  if (each.empty() || !recommended) return std::nullopt;
  const AxisGains& nearest = *std::ranges::min_element(
      each, {}, [&](const AxisGains& gains) { return std::abs(gains.damping - damping); });
  return recommended->stiffness < nearest.stiffness ? recommended->limit : nearest.limit;
}

std::optional<AxisGains> best_damped(const TuningResults& results, const AxisGains& best) {
  std::vector<GainAxis> axes{best.axis};
  if (is_joint(best.axis)) axes = joint_axes(results);
  std::optional<AxisGains> out;
  for (const GainAxis axis : axes)
    for (const AxisGains& each : recommend_at_each_damping(results, axis))
      if (each.damping > 0 && (!out || each.stiffness > out->stiffness)) out = each;
  return out;
}

std::optional<AxisGains> recommend_as_varied(const TuningResults& results, GainAxis axis) {
  const TuningLine* beside = varied(results, axis);
  if (!beside) return std::nullopt;
  const Lines lines = lines_where(results, [&](const TuningLine& line) {
    return line.axis == axis && line.assumed.empty() && line.situation == beside->situation &&
           line.hand == beside->hand;
  });
  if (lines.empty()) return std::nullopt;
  return gains_at(results, lines, results.device, axis, beside->columns.front().damping);
}

std::map<std::string, AxisGains> recommend_by_hand(const TuningResults& results, GainAxis axis,
                                                   double damping) {
  std::map<std::string, AxisGains> out;
  for (const TuningLine& any : results.lines) {
    if (any.axis != axis || !any.assumed.empty() || out.contains(any.hand)) continue;
    const Lines lines = lines_where(results, [&](const TuningLine& line) {
      return line.axis == axis && line.assumed.empty() && line.hand == any.hand;
    });
    out.emplace(any.hand, gains_at(results, lines, results.device, axis, damping));
  }
  return out;
}

bool held_elsewhere(const AxisGains& gains) {
  constexpr double near = 1.5;
  const double ratio = gains.held_at > 0 ? gains.stiffness / gains.held_at : 1;
  return ratio > near || ratio < 1 / near;
}

bool trusts_friction(const TuningResults& results) {
  return results.trusts_friction && has_friction(results);
}

std::vector<GainAxis> axes_of(const TuningResults& results) {
  std::vector<GainAxis> out;
  for (const TuningLine& line : results.lines)
    if (std::ranges::find(out, line.axis) == out.end()) out.push_back(line.axis);
  return out;
}

std::vector<GainAxis> joint_axes(const TuningResults& results) {
  std::vector<GainAxis> out = axes_of(results);
  std::erase_if(out, [](GainAxis axis) { return !is_joint(axis); });
  return out;
}

std::vector<GainAxis> recommended_axes(const TuningResults& results) {
  const std::vector<GainAxis> joint = joint_axes(results);
  return joint.empty() ? axes_of(results) : std::vector{joint.front()};
}

bool has_recommendation(const TuningResults& results) {
  return std::ranges::all_of(recommended_axes(results), [&](GainAxis axis) {
    const auto gains = recommend(results, axis);
    return gains && gains->stiffness > 0;
  });
}

Coupling recommended_coupling(const TuningResults& results) {
  Coupling wanted, out;
  out.mode = results.mode;
  for (const GainAxis axis : recommended_axes(results))
    if (const auto gains = recommend(results, axis))
      set_gains(wanted, axis, gains->stiffness, gains->damping, results.joint);
  wanted.max_force = results.max_force;
  wanted.max_torque = results.max_torque;
  for (const Setting& setting : coupling_settings())
    set(out, setting.key, get(wanted, setting.key));
  return out;
}

}  // namespace sonde
