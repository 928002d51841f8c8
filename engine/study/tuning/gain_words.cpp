// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/gain_words.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

/// Words for a reason whose name is not self-explanatory.
std::string words_of(const std::string& reason) {
  constexpr std::pair<std::string_view, const char*> words[] = {
      {"friction", "stability without friction"},
      {"knocks", "stability at harder knocks"},
      {"driver", "the driver's largest stiffness"},
      {"rendered", "what is rendered on this device at most"},
      {"resolution", "the encoder's steps"},
      {"rest", "what comes to rest"},
      {"released", "what the handle bears once no hand holds it, in theory"},
      {"range", "the range studied"}};
  for (const auto& [name, meaning] : words)
    if (reason == name) return meaning;
  return reason;
}

std::string where(const GainLimit& limit) {
  if (limit.kind.empty()) return {};
  return " (" + limit.kind + " contact" + (limit.hand.empty() ? "" : ", " + limit.hand + " hand") +
         ")";
}

}  // namespace

std::string short_number(double value) {
  return value >= 1000 && value < 1e9 ? number_text(std::round(value)) : number_text(value, 3);
}

std::string stiffness_in_words(GainAxis axis, double stiffness) {
  return short_number(stiffness) + (axis == GainAxis::rotation ? " N·m/rad" : " N/m");
}

std::string damping_in_words(const AxisGains& gains) {
  const bool turns = damps_turns(gains.axis);
  return (turns ? "b_r " : "b_t ") + short_number(gains.damping) +
         (turns ? " N·m·s/rad" : " N·s/m");
}

std::string gains_in_words(const AxisGains& gains, const JointGains& joint) {
  const std::string stiffness = stiffness_in_words(gains.axis, gains.stiffness);
  if (gains.axis == GainAxis::object) return "k " + stiffness;
  std::string out = stiffness_key(gains.axis) + (" " + stiffness);
  const Coupling c = coupling_of(gains, joint);
  if (is_joint(gains.axis)) out += ", k_r " + short_number(c.k_r) + " N·m/rad";
  if (gains.damping == 0) return out + ", no damping";
  out += ", " + damping_in_words(gains);
  if (gains.axis == GainAxis::together) out += ", b_r " + short_number(c.b_r) + " N·m·s/rad";
  return out;
}

std::string limit_in_words(const GainLimit& limit) {
  return "limited by " + words_of(limit.reason) + where(limit);
}

}  // namespace sonde
