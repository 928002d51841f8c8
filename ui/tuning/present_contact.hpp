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

/// A boundary of stability as a study has it: what it is for and what it takes for granted.
struct StudiedBoundary {
  double stiffness = 0;  ///< N/m or N·m/rad, by the axis; infinite where nothing studied fails
  std::string hand;      ///< the simulated hand that holds the device: "light", "firm"
  enum class Basis { as_is, without_friction, harder_knocks } basis = Basis::as_is;
};
/// The boundary that counts (boundary_that_counts) in contacts of one kind, the least of all
/// situations and hands, at the swept damping nearest to `damping`; no value where the study has no
/// such contact.
std::optional<StudiedBoundary> boundary_in(const TuningResults& results, GainAxis axis,
                                           const std::string& kind, double damping);

/// "a light hand", "a light hand, without friction".
QString words_of(const StudiedBoundary& boundary);

/// Where a stiffness lies, seen from its boundary, so that it cannot be read the other way round:
/// "could be 1.80 times as stiff", "70.3 times too stiff". Empty where there is no boundary.
QString distance_text(double stiffness, double boundary);

}  // namespace sonde::ui
