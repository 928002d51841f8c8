// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "engine/study/parts/study_parts.hpp"
#include "engine/study/tuning/tuning.hpp"

namespace sonde {

/// Looks for the situations, and, on so many threads, for the damping at which assumed values are
/// varied; takes the first look. Errors as tuning_contacts.
std::shared_ptr<const TuningPlan> study_plan(const TuningRequest& request, unsigned threads,
                                             const Stop& stop,
                                             const std::function<void(double)>& progress = {});

/// The study of such a plan. Each situation, hand and axis is a part. In the situation that theory
/// calls the hardest, so is half and twice each assumed value of the profile, and both ends of each
/// measured one's interval, unless the search (to the square of its ratio) would not tell them
/// apart.
Study plan_tuning(const std::shared_ptr<const TuningPlan>& plan);
/// Makes the plan too.
Study plan_tuning(const TuningRequest& request, unsigned threads, const Stop& stop,
                  const std::function<void(double)>& progress = {});

/// Limits of a first look are known to this ratio.
constexpr double first_look_ratio = 1.3;

}  // namespace sonde
