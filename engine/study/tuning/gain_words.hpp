// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {

/// Three digits, or all before the decimal point.
std::string short_number(double value);
/// "345 N/m" of an axis, "0.2 N·m/rad" of a rotation.
std::string stiffness_in_words(GainAxis axis, double stiffness);
/// "b_t 2 N·s/m".
std::string damping_in_words(const AxisGains& gains);
/// "k_t 345 N/m, k_r 0.2 N·m/rad, b_t 2 N·s/m".
std::string gains_in_words(const AxisGains& gains, const JointGains& joint);
/// "limited by stability without friction (flat contact, light hand)".
std::string limit_in_words(const GainLimit& limit);

}  // namespace sonde
