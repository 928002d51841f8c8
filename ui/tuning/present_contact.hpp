// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "engine/penetration/contact/separation.hpp"
#include "engine/study/tuning/tuning_results.hpp"

namespace sonde::ui {

/// The kind of the contact that holds the probe, as a study names it: "flat", "edge", ...; empty
/// where there is none.
std::string kind_of_contact(const Separation& separation);

/// The boundary of stability that counts (boundary_that_counts) in contacts of one kind, the least
/// of all situations and hands, at the swept damping nearest to `damping`: N/m or N·m/rad, by the
/// axis. Infinite where
/// nothing in the range studied fails; no value where the study has no such contact.
std::optional<double> boundary_in(const TuningResults& results, GainAxis axis,
                                  const std::string& kind, double damping);

/// Where a stiffness lies, seen from its boundary, so that it cannot be read the other way round:
/// "could be 1.80 times as stiff", "70.3 times too stiff". Empty where there is no boundary.
QString distance_text(double stiffness, double boundary);

}  // namespace sonde::ui
