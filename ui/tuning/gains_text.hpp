// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/haptics/coupling/coupling.hpp"

namespace sonde::ui {

/// The stiffness of gains with its unit, and the damping where the mode has it; one on a line.
QString gains_text(const Coupling& gains);

}  // namespace sonde::ui
