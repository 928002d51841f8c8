// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// The one knob of an answer: what it may take, or how near to the true depth it is wanted. One of
/// the two is given, and the other follows from what was measured (calibration.hpp). Neither: as
/// long as it takes.
struct Knob {
  double time = 0;      ///< s; 0: not given
  double accuracy = 0;  ///< share of the depth, 0.01 is 1 %; 0: not given
};

/// How near to the true depth an answer claims to be.
struct Claim {
  /// - certified: by the lower bound, or since the probe is free; it holds always.
  /// - expected: by calibration, of nine in ten answers.
  enum class By { nothing, certified, expected };
  By by = By::nothing;
  double within = 0;  ///< depth / true depth − 1 is at most this; of no meaning for nothing
};

}  // namespace sonde
