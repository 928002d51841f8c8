// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/study/identification/estimate.hpp"
#include "engine/study/identification/pulse_windows.hpp"

namespace sonde {

/// What the pulses along one axis say of the handle.
struct HandleFit {
  Estimate inertia;   ///< kg | kg·m²
  Estimate damping;   ///< N·s/m | N·m·s/rad
  Estimate friction;  ///< N | N·m
  Estimate delay;     ///< s
  double offset = 0;  ///< N | N·m
  double misfit = 0;  ///< what the model leaves of the motion: rms over rms
  /// What it leaves, over what of that is white or the encoder's rounding: near one where the model
  /// holds.
  double excess = 1;
  bool between = false;  ///< commands were taken to change between samples: see fit_handle
  bool widened = false;  ///< the intervals hold what parts of the pulses say by themselves
};

/// The free handle whose motion is nearest to the measured one, by least squares over the samples
/// of the windows. Where a pulse began is not taken from the encoder but fitted, pulse by pulse.
///
/// The intervals come from the answers that leave out one pulse each: within a pulse, what the
/// model leaves out stays much the same, so that samples are no independent witnesses (the
/// jackknife by clusters, linearised, with Student's t of one less than the number of pulses).
/// Added to that is what the encoder's rounding (`encoder_step`, m | rad; 0: none) does at 16 other
/// places of the handle between two steps, which may be the same in all pulses.
///
/// These intervals take the model for true. Whether it is, the residuals tell: where their rms is
/// more than twice what of them is white (by second differences, as von Neumann's ratio has it) or
/// the encoder's, the model leaves something that goes on from sample to sample. Then the times of
/// the commands are doubted first: a log that leaves out samples has them late by up to a sample
/// time, each by another part. They are fitted too, and kept where that explains what was left; the
/// intervals then hold both answers, as something that the model has not may look like it. Where
/// it does not, the intervals are widened to hold what the larger and the smaller pulses, and those
/// of either sign, say by themselves. Throws
/// std::invalid_argument where there are fewer than eight pulses, or where they cannot tell the
/// parameters apart.
HandleFit fit_handle(const AxisResponse& response, const std::vector<PulseWindow>& windows,
                     double encoder_step);

/// Student's t, which one in a hundred exceeds, both sides together, at seven or more degrees of
/// freedom: within 0.5 % (the expansion of Cornish and Fisher: Abramowitz and Stegun, 26.7.5).
double student_t_99(double degrees);

}  // namespace sonde
