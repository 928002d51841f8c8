// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "engine/study/parts/study_parts.hpp"
#include "engine/study/tuning/tuning.hpp"

namespace sonde {

/// Searches for the situations and, on `threads` threads, for the damping at which assumed values
/// are varied; takes the first look. Errors as for tuning_contacts.
std::shared_ptr<const TuningPlan> study_plan(const TuningRequest& request, unsigned threads,
                                             const Stop& stop,
                                             const std::function<void(double)>& progress = {});

/// The study of such a plan. Each situation, hand and axis is a part. In the situation with the
/// lowest theoretical limit, there are also parts for half and twice each assumed value of the
/// profile, and for both ends of each measured value's interval, unless the search (to the square
/// of its ratio) could not distinguish them.
Study plan_tuning(const std::shared_ptr<const TuningPlan>& plan);
/// The same, including the plan.
Study plan_tuning(const TuningRequest& request, unsigned threads, const Stop& stop,
                  const std::function<void(double)>& progress = {});

/// The limits of a first look are known to this ratio.
constexpr double first_look_ratio = 1.3;

}  // namespace sonde
