// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// Generalized (or translational) penetration depth of probe A at X_FM against fixed body B,
/// searched globally on the pair's sketches and from many starts, each descended on the contact
/// space. The separated pose is verified free with exact predicates. Never throws on geometry: the
/// result states a failure. Throws Cancelled if `progress` returns false; it is called with the
/// share of the maximum number of starts. Allocates.
Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options = {},
                           const Progress& progress = {});
/// The same with other constants than search_tuning (search_tuning.hpp), for studies of them.
struct SearchTuning;
Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                           const SearchTuning& tuning, const Progress& progress = {});

}  // namespace sonde
