// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// The one knob of a search: the time that it may take, or the accuracy that it should reach. Give
/// one of the two; the other follows from what was measured (calibration.hpp). Give neither, and
/// the search takes as long as it needs.
struct Knob {
  double time = 0;      ///< s; 0: not given
  double accuracy = 0;  ///< share of the depth, 0.01 is 1 %; 0: not given
  /// The share of answers that keep to what they claim, above 0 and below 1. More: claims are
  /// wider, and where the way out is long the search makes more starts (StaticOptions::sure).
  double sure = 0.9;
};

/// How near to the true depth an answer claims to be.
struct Claim {
  /// - certified: by the lower bound, or because the probe is free; always holds.
  /// - expected: by calibration; holds for nine in ten answers, or as many as were asked for.
  enum class By { nothing, certified, expected };
  By by = By::nothing;  ///< what the claim rests on
  double within = 0;    ///< depth / true depth − 1 is at most this; no meaning with By::nothing
};

}  // namespace sonde
