// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "engine/study/charts/svg_chart.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/stability/sampled_stability.hpp"
#include "engine/study/tuning/tuning_results.hpp"

namespace sonde {

/// The impedance that a sampled wall renders to a hand that moves the handle at ω (rad/s), in
/// closed form, for a linear contact along one axis: minus the force over the velocity, N·s/m |
/// N·m·s/rad. The force is computed from samples, held, and delayed:
///
///     Z(jω) = (K + B (1 − e^−jωT)/T) · e^−jωt_d · (1 − e^−jωT)/(jωT) / jω
///
/// (at the frequency of the motion; aliases at other frequencies are ignored). The ideal is K/jω +
/// B.
std::complex<double> rendered_impedance(const SampledAxis& axis, double stiffness, double omega);
std::complex<double> wanted_impedance(double stiffness, double damping, double omega);

/// The device alone against one wall along an axis, without a hand: the largest stiffness as a
/// function of the virtual damping (the Z-width: Colgate and Brown, 1994).
struct ZWidthPoint {
  double damping = 0;  ///< virtual, N·s/m | N·m·s/rad
  double stable = 0, passive = 0;
};
std::vector<ZWidthPoint> z_width(const SampledAxis& axis, double most_damping);

/// How the limit depends on a property, from a twentieth to four times the profile's value (the
/// rate from 500 Hz to 10 kHz, the damping of a hand from 0.1 to 20 N·s/m).
struct LimitAt {
  double value = 0, stable = 0, passive = 0;
  /// d ln(passive) / d ln(value): −1 if doubling the value halves the limit.
  double slope = 0;
};
std::vector<LimitAt> limits_by_delay(const SampledAxis& axis);
std::vector<LimitAt> limits_by_rate(const SampledAxis& axis);
std::vector<LimitAt> limits_by_hand_damping(const SampledAxis& axis);
/// By the step of the encoder, m | rad: the stiffness that friction (N | N·m) keeps quiet, 2 f/step
/// (Abbott and Okamura, 2005), or the limit without a step if that is less.
std::vector<LimitAt> limits_by_step(const SampledAxis& axis, double step, double friction);

/// Curves of one kind, as numbers and as a picture.
struct DeviceCurves {
  std::string name;  ///< of its files
  std::string csv;
  SvgChart chart;
};

/// z_width, limits, impedance, hardness: for the device of a study, for its translation and, if it
/// has motors for it, its rotation; the impedance is at the recommended gains, and the hardness of
/// a wall is given up to twice their stiffness. Both are missing without a recommendation.
std::vector<DeviceCurves> device_curves(const TuningResults& results);
/// NAME.csv and NAME.svg of each.
std::vector<StudyFile> device_curve_files(const TuningResults& results);

}  // namespace sonde
