// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/chart.hpp"

namespace sonde {

/// Limits the turn of a step from y. A step that would leave the chart ends at the rim (|v| =
/// Chart::largest_v), where the rim is a row. A step from the rim itself slides along it, to the
/// rim point in the direction of its end; other rows may be violated on that path.
Vec6 within_chart(const Chart& chart, const Vec6& y, const Vec6& step);

/// Whether y is at the rim of the chart, or beyond it.
bool at_rim(const Chart& chart, const Vec6& y);

}  // namespace sonde
