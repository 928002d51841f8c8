// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// One axis of a device against a virtual spring and damper, with no hand on it:
///
///     m ẍ + b ẋ = −F,   F_k = K x_k + B (x_k − x_{k−1})/T
///
/// F is computed at sample k from the position at that time, reaches the motors after the delay,
/// and is held until the next one does (zero-order hold). Units on the left are for a translation,
/// on the right for a rotation, which has the same equation.
struct SampledAxis {
  double inertia = 0.1;        ///< m, kg | kg·m²; above zero
  double damping = 0;          ///< b, of the mechanism, N·s/m | N·m·s/rad; zero or more
  double virtual_damping = 0;  ///< B, N·s/m | N·m·s/rad; zero or more
  double sample_time = 1e-3;   ///< T, s; above zero
  double delay = 0;  ///< t_d, s, from sample to motors; need not be a whole number of samples
};

/// Largest absolute value of the eigenvalues of the loop over one sample, at the stiffness K (N/m |
/// N·m/rad): the factor by which an oscillation grows with each sample. At most 1: stable. Exact
/// for any delay: a sample is split where the motors change. Throws std::invalid_argument for an
/// axis outside the ranges above or a number that is not finite.
double spectral_radius(const SampledAxis& axis, double stiffness);

/// The stiffness up to which the loop is stable, N/m | N·m/rad, within 1e-6 of itself: the spectral
/// radius is at most 1 at every K from zero to there. Zero if no K is stable (no damping at all, or
/// more virtual damping than the sampling permits). Errors as for spectral_radius.
double largest_stable_stiffness(const SampledAxis& axis);

/// The stiffness up to which the wall is passive, that is, takes energy out of whatever touches it,
/// a hand or another passive body, N/m | N·m/rad: (b − B)/(T/2 + t_d), zero if that is negative.
/// For B = 0 and a delay of whole samples this is exact (Colgate and Schenkel, 1994, with the delay
/// in their condition); virtual damping reduces the passive damping by at most B. Never above the
/// largest stable stiffness. Errors as for spectral_radius.
double largest_passive_stiffness(const SampledAxis& axis);

}  // namespace sonde
