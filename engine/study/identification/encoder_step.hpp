// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "engine/study/identification/estimate.hpp"

namespace sonde {

/// The step of an encoder, from a sequence of its positions (m | rad): the largest length of which
/// nearly every change is a whole multiple. The interval is the spread of these changes. None if
/// there is no such length: the positions are exact, or noise or the mechanism's geometry has
/// blurred the steps.
std::optional<Estimate> encoder_step(std::span<const double> positions);

}  // namespace sonde
