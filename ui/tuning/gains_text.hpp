// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/haptics/coupling/gain_glide.hpp"

namespace sonde::ui {

/// The stiffness of gains with its unit, and the damping where the mode has it; one on a line.
QString gains_text(const Coupling& gains);
/// The same of gains on their way, in a change of mode with the share of either mode.
QString gains_text(const GainGlide::Blend& gains);

}  // namespace sonde::ui
