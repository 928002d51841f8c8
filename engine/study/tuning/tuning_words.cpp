// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_words.hpp"

#include <algorithm>
#include <cmath>

#include "engine/study/stability/contact_stability.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "engine/study/tuning/gain_words.hpp"
#include "engine/study/tuning/sureness_words.hpp"
#include "engine/study/tuning/tuning.hpp"
#include "engine/study/tuning/wall_hardness.hpp"

namespace sonde {
namespace {

/// Empty if nothing is recommended.
std::string damping_ratio_text(const TuningResults& results, const AxisGains& gains) {
  const DampingRatios ratio = damping_ratios(results, gains);
  std::string out;
  const auto add = [&](const std::optional<double>& zeta, const char* what) {
    if (zeta) out += (out.empty() ? "" : ", ") + short_number(*zeta) + what;
  };
  add(ratio.translation, " of the translation");
  if (results.device.at("max_torque") > 0) add(ratio.rotation, " of the rotation");
  return out.empty()
             ? out
             : "damping ratio of the handle on these springs, its own damping included: " + out;
}

/// For translation, on the device alone. Empty if nothing is recommended.
std::string hardness_text(const TuningResults& results, const AxisGains& gains) {
  const auto& device = results.device;
  const bool known = device.contains("damping") && device.contains("delay");
  const Coupling c = coupling_of(gains, results.joint);
  const double stiffness = in_object_norm(gains.axis) ? c.k : c.k_t;
  if (!known || !(stiffness > 0)) return {};
  const SampledAxis axis{device.at("mass"), device.at("damping"), c.b_t, results.sample_time,
                         device.at("delay")};
  const HandGrip& light = hand_grips[0];
  const double rise = rise_time(axis, stiffness, {light.stiffness, light.damping});
  const std::string rises = std::isfinite(rise)
                                ? "rises in " + short_number(1e3 * rise) + " ms"
                                : std::string("does not come to what it should within 10 s");
  return "a wall at these gains feels as hard as " + short_number(rate_hardness(axis, stiffness)) +
         " N/m to a handle that runs into it (rate-hardness over 10 ms), and its force " + rises +
         " (10 to 90 %, light hand)";
}

/// Empty if the gains have damping, or cannot have any.
std::string why_no_damping(const TuningResults& results, const AxisGains& best) {
  const auto next = best_damped(results, best);
  if (best.damping > 0 || best.stiffness <= 0 || !next) return {};
  const bool by_itself = is_joint(next->axis) && next->axis != GainAxis::together;
  return "no virtual damping is best: at " + damping_in_words(*next) +
         (by_itself ? " by itself" : "") + " the stiffness may be " +
         stiffness_in_words(next->axis, next->stiffness) + ", " + limit_in_words(next->limit);
}

/// Where a sweep found what does not hold. Empty if it found nothing.
std::string measured_text(const AxisGains& gains) {
  if (!(gains.stiffness > 0)) return {};
  std::string out;
  const auto add = [&](bool known, const char* what, double limit) {
    if (!known || !(limit > 0) || !std::isfinite(limit)) return;
    out += (out.empty() ? "" : ", ") + std::string(what) + stiffness_in_words(gains.axis, limit);
  };
  add(true, "measured to be stable up to ", gains.boundary);
  if (!out.empty()) out += " (a margin of " + short_number(gains.margin()) + ")";
  // Where nothing was unstable with the profile's friction, one of these begins the sentence.
  const auto less = [&](bool known, const std::string& what, double limit) {
    add(known, ((out.empty() ? "measured to be stable " : "") + what).c_str(), limit);
  };
  less(!gains.without_friction_by_theory, "without friction up to ", gains.without_friction);
  add(gains.without_friction_by_theory,
      out.empty() ? "stable without friction, in theory, up to "
                  : "without friction, in theory, up to ",
      gains.without_friction);
  less(gains.harder_knocks < gains.boundary, "at harder knocks up to ", gains.harder_knocks);
  add(true, "passive in theory up to ", gains.passive);
  return out;
}

/// What came to rest without friction did so in the engine's contact, which bends and ends.
std::string beyond_theory(const AxisGains& gains) {
  if (!(gains.stiffness > gains.theory)) return {};
  const std::string limit = stiffness_in_words(gains.axis, gains.theory);
  const std::string theory = "that is above the limit in theory, which has no friction";
  if (!gains.tried) return theory + ": " + limit;
  return theory + " and takes the contact as linear: " + limit +
         "; in the contact as it is, the probe came to rest";
}

std::string contacts_text(const std::vector<GainLimit>& places) {
  std::string out;
  for (const GainLimit& each : places)
    out += (out.empty() ? "the " : ", the ") + each.kind + " contact (" + each.hand + " hand)";
  return out;
}

std::string times_text(double times, const char* what) {
  if (times == 0) return std::string("without ") + what;
  return "with " + short_number(times) + " times the " + what;
}

/// "swings on at 0.4 mm, 31 Hz, in the flat contact ...".
std::string swing_text(const Swing& swing) {
  const std::string place = "in the " + swing.kind + " contact (" + swing.hand + " hand), " +
                            times_text(swing.friction, "friction") + ", after a knock of " +
                            short_number(swing.knock) + " times the strength";
  if (swing.amplitude == 0) return "the solver gave no answer " + place;
  return "the probe swings on at " + short_number(1e3 * swing.amplitude) + " mm, " +
         short_number(swing.frequency) + " Hz, " + place;
}

/// What would help, if nothing comes to rest.
std::string what_would_help(const TuningResults& results, const Swing& swing) {
  std::string out;
  const auto add = [&](const std::string& each) { out += (out.empty() ? "" : "; ") + each; };
  if (results.mode == Coupling::Mode::classic)
    add("the object norm, whose spring gives back no more than it takes");
  if (swing.friction == 0 && has_friction(results) && !results.trusts_friction)
    add("gains that rely on the device's friction, once it is measured (trust friction)");
  if (swing.hand != "firm") add("a firmer hand, or more damping in the device");
  add("less delay");
  return "what would help: " + out;
}

}  // namespace

std::vector<std::string> rest_in_words(const TuningResults& results, const AxisGains& gains) {
  std::vector<std::string> out;
  if (!gains.tried) return out;
  if (gains.stiffness > 0) {
    const bool frictionless = !has_friction(results);
    const std::string frictions = frictionless               ? "without friction"
                                  : trusts_friction(results) ? "with the profile's friction"
                                                             : "with the profile's friction and "
                                                               "without any";
    const std::string contacts =
        results.only_kind.empty() ? "every contact"
                                  : "the " + results.only_kind + " contact, the only one studied";
    out.push_back("at these gains the probe came to rest in " + contacts +
                  ", in a firm, a light and a limp hand, " + frictions +
                  ", after knocks of 1, 2 and 4 times the strength: within " +
                  short_number(gains.longest_to_rest) + " s");
    if (gains.swings) out.push_back("stiffer, " + swing_text(*gains.swings));
  } else if (gains.swings) {
    out.push_back("at no stiffness tried did it come to rest everywhere: at the softest, " +
                  swing_text(*gains.swings));
    out.push_back(what_would_help(results, *gains.swings));
  } else if (!gains.limits.empty() && gains.limits.front().stiffness > 0) {
    out.push_back("its limits allow " +
                  stiffness_in_words(gains.axis, gains.limits.front().stiffness) +
                  ", but nothing so soft was held until it rests, so it is not recommended");
  }
  return out;
}

namespace {

std::string let_go_text(const TuningResults& results, const AxisGains& gains) {
  const auto stiffness = [&](double value) { return stiffness_in_words(gains.axis, value); };
  const auto up_to = [&](double limit) {
    return std::isfinite(limit) ? ": in theory it may be up to " + stiffness(limit)
                                : std::string(" in theory");
  };
  const std::string hertz = short_number(slowest_buzz) + " Hz";
  const std::string then = "if the hand lets go, ";
  switch (if_let_go(gains)) {
    case LetGo::unknown:
      return {};
    case LetGo::no_buzz:
      return then + "no swing of " + hertz + " or faster grows" + up_to(gains.released) +
             "; slower ones were not looked at";
    case LetGo::stable:
      return then + "no swing of the handle grows" + up_to(*gains.released_any_swing);
    case LetGo::slow_swing:
      return then + "the handle is unstable: in theory a swing slower than " + hertz + " grows" +
             (*gains.released_any_swing > 0
                  ? " from " + stiffness(*gains.released_any_swing) + " on"
                  : " at any stiffness") +
             ", until a hand comes back" +
             (std::isfinite(gains.released) ? "; a faster one from " + stiffness(gains.released)
                                            : "");
    case LetGo::buzz:
      return then + "the handle is unstable, and buzzes" + up_to(largest_if_let_go(gains)) +
             (results.always_held ? "; a hand that always holds was asked for" : "");
  }
  return {};
}

/// If the wrench is a gradient: only the damping can be what leaves no stiffness passive.
std::string damping_not_passive(const AxisGains& gains) {
  return gains.damping > 0
             ? "no stiffness is passive at this damping, which is more than the device's own: what "
               "is stable in these hands may shake in another"
             : "no stiffness is passive: the device has no damping of its own";
}

}  // namespace

/// If the wrench is no gradient: for a cycle of 1 mm and 0.1 rad, each from end to end.
std::string passivity_in_words(const TuningResults& results, const AxisGains& gains) {
  if (!(gains.stiffness > 0) || gains.passive > 0) return {};
  if (!(gains.cycle_lever > 0)) return damping_not_passive(gains);
  const double energy = gains.stiffness * gains.cycle_lever * 0.05 * 2e-3;
  std::string out = "no stiffness is passive: ";
  out += results.device.at("max_torque") > 0
             ? "force and torque of these springs are no gradient of an energy"
             : "a force without its torque is no gradient of an energy";
  out += ". A slow cycle of 1 mm and 0.1 rad may give the hand up to " +
         short_number(1e3 * energy) + " mJ";
  if (!(gains.passive_in_translation > 0)) return out + "; nor is any with the turn held";
  if (std::isfinite(gains.passive_in_translation))
    out += "; with the turn held it is passive up to " +
           stiffness_in_words(gains.axis, gains.passive_in_translation);
  return out;
}

namespace {

/// If a damper may allow much more than the object norm by itself does.
std::string damper_text(const TuningResults& results, const AxisGains& gains) {
  constexpr double much = 1.2;
  if (!results.damper || results.damper->stiffness < much * gains.stiffness) return {};
  return "with a damper (the coupling damped), theory and the driver allow k " +
         short_number(results.damper->stiffness) + " N/m, b_t " +
         short_number(results.damper->damping) +
         " N·s/m: a study of that coupling tells what holds";
}

/// The results of the holds of seconds.
std::vector<std::string> lasting_swings(const TuningResults& results, const AxisGains& gains) {
  if (gains.tried) return rest_in_words(results, gains);
  if (gains.stiffness <= 0) return {};
  if (gains.held_at == 0)
    return {
        "whether the probe swings on for seconds, without friction or after a hard knock, was "
        "not looked at"};
  const std::string at = "at " + stiffness_in_words(gains.axis, gains.held_at) +
                         (held_elsewhere(gains) ? ", far from these gains," : ",");
  const std::string knock =
      "after a knock of " + short_number(std::ranges::max(harder_knocks)) + " times the strength";
  const bool trusts = trusts_friction(results);
  std::vector<std::string> out;
  if (!trusts && !gains.swings_without_friction.empty())
    out.push_back((has_friction(results) ? "these gains may rely on friction: without it, "
                                         : "the device has no friction: ") +
                  at + " the probe swings on in " + contacts_text(gains.swings_without_friction));
  if (!gains.swings_at_harder_knocks.empty())
    out.push_back(knock + ", " + at + " the probe swings on in " +
                  contacts_text(gains.swings_at_harder_knocks));
  if (out.empty())
    out.push_back("held for seconds " + at + (trusts ? " " : " once without friction and once ") +
                  knock + ", the probe comes to rest");
  return out;
}

/// Empty if only one hand was studied.
std::string hands_text(const TuningResults& results, const AxisGains& gains) {
  const auto by_hand = recommend_by_hand(results, gains.axis, gains.damping);
  if (by_hand.size() < 2) return {};
  const auto stiffness = [](const auto& each) { return each.second.stiffness; };
  const auto [weakest, stiffest] = std::ranges::minmax_element(by_hand, {}, stiffness);
  const std::string tried =
      gains.limit.reason == "rest" ? ", before what comes to rest is tried" : "";
  if (stiffness(*stiffest) <= resolved * stiffness(*weakest))
    return "how the hand holds is assumed too, and does not change the gains: " +
           stiffness_in_words(gains.axis, stiffness(*weakest)) + " by the limits of each alone" +
           tried;
  std::string out = "how the hand holds is assumed too: by the limits of each alone";
  for (const auto& [hand, alone] : by_hand)
    out += ", the " + hand + " one allows " + stiffness_in_words(gains.axis, alone.stiffness);
  return out + tried;
}

std::string first_sentence(const TuningResults& results, const AxisGains& gains) {
  return (gains.stiffness > 0 ? gains_in_words(gains, results.joint) : "no stiffness is good") +
         ", " + limit_in_words(gains.limit);
}

}  // namespace

std::optional<TuningResults> tuning_so_far(const std::string& folder, const StudyFolder& study,
                                           GainAxis axis) {
  const StudyFolder finished = study.finished();
  if (finished.names.empty()) return std::nullopt;
  TuningResults results = read_tuning(folder, finished);
  std::erase_if(results.lines,
                [&](const TuningLine& line) { return line.axis != axis || !line.assumed.empty(); });
  return results.lines.empty() ? std::nullopt : std::optional(std::move(results));
}

std::string gains_in_words(const TuningResults& results) {
  std::string out;
  for (const GainAxis axis : recommended_axes(results))
    if (const auto gains = recommend(results, axis))
      out += (out.empty() ? "" : "; ") + first_sentence(results, *gains);
  return out;
}

std::vector<std::string> axis_in_words(const TuningResults& results, GainAxis axis) {
  const auto gains = recommend(results, axis);
  if (!gains) return {"the study has no gains to recommend"};
  const std::vector<GainAxis> recommended = recommended_axes(results);
  const bool alone = std::ranges::find(recommended, axis) == recommended.end();
  std::vector<std::string> out{(alone ? "alone, with the rest soft: " : "") +
                               first_sentence(results, *gains)};
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) out.push_back(sentence);
  };
  if (!alone) {
    for (const std::string& sentence : lasting_swings(results, *gains)) add(sentence);
    add(hands_text(results, *gains));
  }
  add(measured_text(*gains));
  add(beyond_theory(*gains));
  add(passivity_in_words(results, *gains));
  if (!alone) add(damper_text(results, *gains));
  add(why_no_damping(results, *gains));
  add(let_go_text(results, *gains));
  if (alone) return out;
  for (const std::string& sentence : sureness_in_words(results, axis)) add(sentence);
  add(damping_ratio_text(results, *gains));
  add(hardness_text(results, *gains));
  return out;
}

std::vector<std::string> recommendation_in_words(const TuningResults& results) {
  std::vector<std::string> out{gains_in_words(results)};
  for (const GainAxis axis : recommended_axes(results)) {
    const std::vector<std::string> words = axis_in_words(results, axis);
    out.insert(out.end(), words.begin() + 1, words.end());
  }
  return out;
}

}  // namespace sonde
