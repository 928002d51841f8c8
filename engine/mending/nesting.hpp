// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/mending/parts.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// Which parts must be turned inside out: an outermost part with negative volume, together with
/// everything nested in it. So a cavity stays a cavity, and a mirrored half counts as the other
/// half does. A part is nested in another if all sample points on it lie inside that one, or, since
/// its faces may lie on the other's, all points just below its faces do; and in several together if
/// each point lies inside one of them. A part that is there both ways round is a body where its
/// faces lie on those of one that is not. Two parts in the same place are not nested. `sealed`
/// contains only parts that bound an inside (`solid`, by part). Throws Cancelled.
std::vector<bool> parts_to_turn(const Sealed& sealed, const std::vector<PartFacts>& facts,
                                const std::vector<bool>& solid, const Progress& progress = {});

}  // namespace sonde
