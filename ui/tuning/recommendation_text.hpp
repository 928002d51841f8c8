// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde::ui {

/// The gains of one axis in the terminal's words and order (axis_in_words), a sentence on each
/// line. Plain text, lines separated by '\n'; states where there is no recommendation.
QString recommendation_text(const TuningResults& results, GainAxis axis);

/// Gains of one axis relative to what the study allows at that damping (allowed_text). Empty where
/// it has no line of that axis.
QString margin_text(const TuningResults& results, GainAxis axis, double stiffness, double damping);

}  // namespace sonde::ui
