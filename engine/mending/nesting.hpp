// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/mending/parts.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// Which parts must be turned inside out: an outermost one whose volume is negative, and with it
/// all that is nested in it. So a cavity stays a cavity, and a mirrored half counts as the other
/// half does. A part is nested in another if all of some points on it lie inside of that one, and
/// in several together if each lies inside of one of them. `sealed` holds no parts but those that
/// bound an inside (`solid`, by part). Throws Cancelled.
std::vector<bool> parts_to_turn(const Sealed& sealed, const std::vector<PartFacts>& facts,
                                const std::vector<bool>& solid, const Progress& progress = {});

}  // namespace sonde
