// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde::ui {

/// The recommended gains of one axis for people: the values, their margin, what limits them, and
/// which assumed values of the profile they rest on, with what half and twice each would make of
/// them. Plain text, lines separated by '\n'; no value: says so.
QString recommendation_text(const TuningResults& results, GainAxis axis);

/// Gains of one axis beside what was measured: "0.68 of the boundary, 1210 N/m". Empty where the
/// study found no boundary.
QString margin_text(const AxisGains& recommended, double stiffness);

}  // namespace sonde::ui
