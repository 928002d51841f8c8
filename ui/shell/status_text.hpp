// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/base/format.hpp"
#include "ui/document/instant.hpp"

namespace sonde::ui {

/// The model of both bodies, and the reason.
QString natures(const Body& probe, const Body& fixed);

/// The state of the probe, its clearance, and the reason why there is no force, if any.
QString happening(const Instant& now, const LengthUnit& unit);

}  // namespace sonde::ui
