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
struct SampledContact {
  SimulatedDeviceParameters device;
  double sample_time = 1e-3;           ///< T, s
  Mat6 stiffness = Mat6::Zero();       ///< K, of (δx, δφ)
  Mat6 held_stiffness = Mat6::Zero();  ///< a part of K that no factor multiplies
  Mat6 damping = Mat6::Zero();         ///< B
};

/// The factor by which an oscillation grows with each sample, as of a SampledAxis: the largest
/// absolute value of the eigenvalues of the loop over one sample. Eigenvalues on the positive real
/// axis are left out: there the probe slides away from an edge or a corner that it is pressed
/// against, which no gain prevents and a hand does.
double buzz_radius(const SampledContact& contact);

/// The factor up to which K may be multiplied (B and what is held stay) and the loop is stable,
/// within 1e-4 of itself; 0 where it is stable at none, infinite where it is at all up to 1e12.
double largest_stable_factor(const SampledContact& contact);

/// The factor on K up to which the loop takes energy out of whatever holds the handle: D − |B| ⪰
/// (T/2 + t_d) K, with D the damping of the device alone. 0 where B alone is too much.
double largest_passive_factor(const SampledContact& contact);

}  // namespace sonde
