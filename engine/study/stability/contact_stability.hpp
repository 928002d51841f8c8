// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/study/stability/felt_stiffness.hpp"

namespace sonde {

/// The sampled wall in all six degrees at once: a device, with a hand on it that holds still,
/// against a contact that is linear about a pose (as SampledAxis, whose terms hold along every
/// axis; friction, limits and encoders are left out):
///
///     M ẍ + D ẋ = −F + hand,   F_k = K x_k + B (x_k − x_{k−1})/T
///
/// K and B are what the coupling asks for. What the device has no motors for (a limit of 0) is not
/// rendered: those rows count as 0, while the handle still moves that way, and its hand holds it.
struct SampledContact {
  SimulatedDeviceParameters device;
  double sample_time = 1e-3;           ///< T, s
  Mat6 stiffness = Mat6::Zero();       ///< K, of (δx, δφ)
  Mat6 held_stiffness = Mat6::Zero();  ///< a part of K that no factor multiplies
  Mat6 damping = Mat6::Zero();         ///< B
  /// The wrench asked for is the gradient of an energy (the object norm with all rigid motions).
  /// Then a K that is not symmetric is an error of the differences it was measured by.
  bool gradient = false;
};

/// The factor by which an oscillation grows with each sample, as of a SampledAxis: the largest
/// absolute value of the eigenvalues of the loop over one sample. Eigenvalues on the positive real
/// axis are left out: there the probe slides away from an edge or a corner that it is pressed
/// against, which no gain prevents and a hand does.
double buzz_radius(const SampledContact& contact);

/// The factor up to which K may be multiplied (B and what is held stay) and the loop is stable,
/// within 1e-4 of itself; 0 where it is stable at none, infinite where it is at all up to 1e12.
/// Oscillations slower than `slowest` (Hz) are left out.
double largest_stable_factor(const SampledContact& contact, double slowest = 0);
/// The same of a handle that is pressed as before, but that no hand holds: neither spring nor
/// damper. What is slower than 5 Hz is left out: a handle that drifts away does not buzz, and a
/// hand that comes back stops it.
double largest_released_factor(const SampledContact& contact);

/// The factor on K up to which the loop takes energy out of whatever holds the handle: D − |B| ⪰
/// (T/2 + t_d) K, with D the damping of the device alone. 0 where B alone is too much, and where
/// the wrench that is rendered is no gradient (cycle_lever): there no stiffness is passive.
double largest_passive_factor(const SampledContact& contact);

/// The same with the turn of the handle held: of the force alone, by displacements alone.
double largest_passive_factor_in_translation(const SampledContact& contact);

/// How far the rendered wrench is from a gradient: the largest singular value of C = K_xφ − K_φxᵀ,
/// of K as rendered, N/rad (in m, at one N/m). Whoever moves the handle round a slow cycle gets
///
///     W = −∮ (C φ)·dx  ≤  cycle_lever · (half of the turn's range, rad) · (way of the
///     displacement, m)
///
/// out of it, at any delay and rate, and no damping prevents it: the slower the cycle, the less it
/// takes. Zero for a wall that conserves energy; so for the object norm with all of its motors.
double cycle_lever(const SampledContact& contact);

}  // namespace sonde
