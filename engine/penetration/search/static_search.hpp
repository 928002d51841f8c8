// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// Generalized (or translational) penetration depth of probe A at X_FM against fixed body B,
/// searched globally on the pair's sketches and from many starts, each descended on the contact
/// space. The separated pose is verified free with exact predicates. Never throws on geometry: a
/// failure says so in the result. Throws Cancelled where the progress says so, which is told the
/// share of the most starts. Allocates.
Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options = {},
                           const Progress& progress = {});
/// The same with other numbers than the search's own (search_tuning.hpp), for studies of them.
struct SearchTuning;
Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                           const SearchTuning& tuning, const Progress& progress = {});

}  // namespace sonde
