// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/bench/queries.hpp"

namespace sonde::bench {

/// Sweeps of A along the trips to the first contact with B. Sonde's path and another library's have
/// the same ends and the same axis, but not quite the same turn in between.
std::vector<Contender> sweep_contenders(const Stage& stage, Place place);

/// Each library is judged on its own path, by touch queries at many samples of it. Sonde is wrong
/// where it calls a sample free that is not, or stops more than 1 % of R before anything. Another
/// library that calls a sample free that is not has missed a contact.
Verdict judge_sweep(const Stage& stage, Place place, std::size_t trip, const Answer& ours,
                    const Contender& contender, const Answer& theirs);

}  // namespace sonde::bench
