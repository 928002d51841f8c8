// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/stability/time_trace.hpp"
#include "engine/study/tuning/tuning.hpp"

namespace sonde {

/// The input of `sonde traces`: one contact of a scene, over time at several gains.
struct TracesRequest {
  TuningRequest tuning;
  /// N/m: k or k_t. Empty: a quarter, a half, one and one and a half times the theoretical limit
  /// without damping, to three digits.
  std::vector<double> stiffness = {};
  /// N·s/m: b_t, with the classic or damped coupling. Empty: none, a quarter and all of the
  /// device's largest.
  std::vector<double> damping = {};
  std::optional<ContactKind> kind =
      {};  ///< of the contact; none: the one with the lowest theoretical limit
  HandGrip hand = hand_grips[0];
};

/// A part for each course, stiffness and damping. Takes seconds; errors as for tuning_contacts, and
/// InputError if there is no contact of that kind.
Study plan_traces(const TracesRequest& request, const Stop& stop,
                  const std::function<void(double)>& progress = {});

}  // namespace sonde
