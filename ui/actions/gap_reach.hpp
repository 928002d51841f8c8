// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/progress.hpp"
#include "engine/proximity/queries/gap_field.hpp"

namespace sonde::ui {

/// The gap that the last colour should stand for, m, 1, 2 or 5 times a power of ten: a few times
/// the clearance where much of the surfaces lies at about one gap, as in a fit, and `range` where
/// the gaps are spread. The fields are those of both bodies up to `range`; what touches, up to
/// `touch`, says nothing of the clearance.
double fitted_reach(const GapField& probe, const GapField& fixed, double range, double touch);

/// That of two bodies at a pose: looks as far as suits the probe, and further where nothing is so
/// near: at first up to the probe's radius, then up to some times the least gap found there.
double fitted_reach(const Body& probe, const Body& fixed, const Pose& X_FM, const Stop& stop = {});

/// How far is near, for a probe of this size, m.
double suited_reach(const Body& probe);
/// The largest triangle of what is painted up to there, m: as many places as there are gaps to be
/// told apart, and not finer than suits the probe.
double gap_cell(const Body& probe, double reach);

}  // namespace sonde::ui
