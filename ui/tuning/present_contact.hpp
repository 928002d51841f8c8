// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "engine/penetration/contact/separation.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde::ui {

/// The kind of the contact that holds the probe, as a study names it: "flat", "edge", ...; empty
/// where there is none.
std::string kind_of_contact(const Separation& separation);

/// Where a stiffness lies, seen from the one that a study allows, so that it cannot be read the
/// other way round: "could be 1.80 times as stiff", "70.3 times too stiff", "as stiff as it may
/// be". Empty where nothing limits.
QString distance_text(double stiffness, double allowed);

/// The same with the limit (allowed_at): "the study allows 600 N/m, limited by stability (edge
/// contact, light hand): could be 2.00 times as stiff".
QString allowed_text(const GainLimit& allowed, GainAxis axis, double stiffness);

}  // namespace sonde::ui
