// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/study/identification/estimate.hpp"
#include "engine/study/identification/pulse_windows.hpp"

namespace sonde {

/// The properties of the handle identified from the pulses along one axis.
struct HandleFit {
  Estimate inertia;   ///< kg | kg·m²
  Estimate damping;   ///< N·s/m | N·m·s/rad
  Estimate friction;  ///< N | N·m
  Estimate delay;     ///< s
  double offset = 0;  ///< N | N·m
  double misfit = 0;  ///< residual motion of the model: rms over rms
  /// Ratio of the residuals to their white part or the encoder's rounding: near one if the model is
  /// valid.
  double excess = 1;
  bool between = false;  ///< commands were fitted to change between samples: see fit_handle
  bool widened = false;  ///< the intervals include the results of parts of the pulses
};

/// The free handle whose motion is nearest to the measured one, by least squares over the samples
/// of the windows. The start position of each pulse is fitted, not taken from the encoder.
///
/// The intervals come from the solutions that leave out one pulse each: within a pulse, the model's
/// error stays much the same, so samples are not independent (the jackknife by clusters,
/// linearised, with Student's t of one less than the number of pulses). Added to that is the effect
/// of the encoder's rounding (`encoder_step`, m | rad; 0: none) at 16 other positions of the handle
/// between two steps, which may be the same in all pulses.
///
/// These intervals assume that the model is true. The residuals test that: if their rms is more
/// than twice their white part (by second differences, as in von Neumann's ratio) or the encoder's
/// rounding, the model has an error that persists from sample to sample. Then the times of the
/// commands are questioned first: a log that omits samples has them late by up to a sample time,
/// each by a different part. They are fitted too, and kept if that explains the residuals; the
/// intervals then include both solutions, since another effect that is not in the model may look
/// like it. If it does not explain them, the intervals are widened to include the results of the
/// larger and of the smaller pulses, and of those of either sign. Throws std::invalid_argument if
/// there are fewer than eight pulses, or if they cannot distinguish the parameters.
HandleFit fit_handle(const AxisResponse& response, const std::vector<PulseWindow>& windows,
                     double encoder_step, const Progress& progress = {});

}  // namespace sonde
