// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/progress.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/search_tuning.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// The result of a PD_t search without a limit, and its number of descents on sketches. A
/// translation that frees the probe, reversed, frees the fixed body if that moves instead. So both
/// problems are searched, each with its own starts, and the shorter result counts; the second only
/// if the first leaves the answer open, or is nearly a touch. Which is searched first does not
/// depend on which body is the probe. Thus PD_t mostly does not change if the bodies are exchanged.
struct Translated {
  Separation found;
  int sketches = 0;
};
Translated translated_both_ways(const Pair& pair, const Pose& device, const StaticOptions& options,
                                const SearchTuning& tuning, const Progress& progress);

}  // namespace sonde
