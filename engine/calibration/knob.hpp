// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// The single setting of a search: the time that it may take, or the accuracy that it should reach.
/// Set one of the two; the other follows from measurements (calibration.hpp). If neither is set,
/// the search takes as long as it needs.
struct Knob {
  double time = 0;      ///< s; 0: not given
  double accuracy = 0;  ///< share of the depth, 0.01 is 1 %; 0: not given
  /// The share of answers that keep their claim, above 0 and below 1. A larger share makes claims
  /// wider, and makes the search use more starts where the way out is long (StaticOptions::sure).
  double sure = 0.9;
};

/// The claimed accuracy of an answer.
struct Claim {
  /// - certified: by the lower bound, or because the probe is free; always holds.
  /// - expected: by calibration; holds for nine in ten answers, or the share that was requested.
  enum class By { nothing, certified, expected };
  By by = By::nothing;  ///< what the claim rests on
  double within = 0;    ///< depth / true depth − 1 is at most this; meaningless with By::nothing
};

}  // namespace sonde
