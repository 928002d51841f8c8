// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/study/stability/felt_stiffness.hpp"

namespace sonde {

/// The sampled wall in all six degrees of freedom: a device, with a still hand on it, against a
/// contact that is linear about a pose (as SampledAxis, with its terms along every axis; friction,
/// limits and encoders are not modelled):
///
///     M ẍ + D ẋ = −F + hand,   F_k = K x_k + B (x_k − x_{k−1})/T
///
/// K and B are those of the coupling. Axes for which the device has no motors (a limit of 0) are
/// not rendered: those rows are 0, while the handle still moves along them, held by its hand.
struct SampledContact {
  SimulatedDeviceParameters device;
  double sample_time = 1e-3;           ///< T, s
  Mat6 stiffness = Mat6::Zero();       ///< K, of (δx, δφ)
  Mat6 held_stiffness = Mat6::Zero();  ///< a part of K to which no factor applies
  Mat6 damping = Mat6::Zero();         ///< B
  /// The commanded wrench is the gradient of an energy (the object norm with all rigid motions).
  /// Then an asymmetry of K is an error of the differences that measured it.
  bool gradient = false;
};

/// The factor by which an oscillation grows with each sample, as for a SampledAxis: the largest
/// absolute value of the eigenvalues of the loop over one sample. Eigenvalues on the positive real
/// axis are left out: they stand for a probe that slides away from an edge or a corner that it is
/// pressed against, which no gain prevents but a hand does.
double buzz_radius(const SampledContact& contact);

/// The largest factor on K (B and held_stiffness are not changed) up to which the loop is stable,
/// within 1e-4 of itself; 0 if it is never stable, infinite if it is stable up to 1e12.
/// Oscillations slower than `slowest` (Hz) are ignored.
double largest_stable_factor(const SampledContact& contact, double slowest = 0);
/// Hz: what is slower is no buzz. It may grow all the same, and then it is unstable too.
constexpr double slowest_buzz = 5;
/// The same for a handle that is pressed as before, but not held by a hand: no spring and no
/// damper. Only oscillations from slowest_buzz on count: a hand that comes back stops a slower one,
/// and a handle that nothing presses any more leaves the contact before one has grown.
double largest_released_factor(const SampledContact& contact);
/// The same for oscillations of any frequency. They grow if they double within a minute: what takes
/// longer is too close to rounding to tell. What grows by more than e while it turns by a radian
/// slides away, and is left out. Not above largest_released_factor.
double largest_released_factor_of_any_swing(const SampledContact& contact);

/// The largest factor on K up to which the loop is passive, that is, takes energy out of whatever
/// holds the handle: D − |B| ⪰ (T/2 + t_d) K, with D the damping of the device alone. 0 if B alone
/// is too large, and if the rendered wrench is no gradient (cycle_lever): then no stiffness is
/// passive.
double largest_passive_factor(const SampledContact& contact);

/// The same with the turn of the handle held: only the force, and only displacements.
double largest_passive_factor_in_translation(const SampledContact& contact);

/// How far the rendered wrench is from a gradient: the largest singular value of C = K_xφ − K_φxᵀ,
/// for K as rendered, N/rad (in m, at one N/m). Moving the handle round a slow cycle gains the
/// energy
///
///     W = −∮ (C φ)·dx  ≤  cycle_lever · (half of the turn's range, rad) · (way of the
///     displacement, m)
///
/// at any delay and rate, and no damping prevents it: the slower the cycle, the less the damping
/// takes. Zero for a wall that conserves energy, as for the object norm with all of its motors.
double cycle_lever(const SampledContact& contact);

}  // namespace sonde
