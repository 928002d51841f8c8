// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/study/comparison/compare.hpp"

namespace sonde {

/// What a test says of a claim. Undecided: the difference may be chance. None: there was no trial.
enum class Finding { supported, refuted, undecided, none };
const char* name_of(Finding finding);

/// A claim about PD_g, tested on trials that could have refuted it.
struct TestedClaim {
  const char* key;
  const char* claim;
  Finding finding = Finding::undecided;
  int for_it = 0, against_it = 0;  ///< trials
  /// Trials that count for neither: within 2 % of each other, or of less than the solver resolves.
  int alike = 0;
  /// Of a split at least as uneven, either way, if both sides were as likely (sign test).
  double chance = 1;
};

/// A claim is supported or refuted if the chance is below this.
constexpr double significant = 0.05;

/// - Smoother force, smoother torque: by the total variation in each trial, which is a quarter of a
/// second in which both are in contact all the time. Both renderings are scaled to the same mean
/// force in it, since a softer rendering is not a smoother one; the torque is scaled with its
/// force. What differs by less than a swing between both ends of the clearance that the solver may
/// leave (allowed_clearance) is alike: its force, and the probe's radius times that as a torque.
/// - Fewer steps, fewer pop-throughs: each is a trial. What counts as a step depends on the motion
/// of the device, not on the size of the force.
/// - A torque nearer to the known one (TorqueRealism): tick by tick, at equal forces. Errors that
/// differ by less than twice that clearance, as a share of the depth, are alike; those of a ball
/// also where its facets may make the difference.
/// - More stable: for each contact, the force at the same device pose with the stiffest coupling
/// that is stable in that contact on the device. The method that renders more force before it
/// oscillates is the more stable one at equal forces. Without a device there is no data.
std::vector<TestedClaim> tested_claims(const Comparison& comparison);

/// The chance, if each were as likely, that of their sum at least as many fall on one side. The
/// time grows with their sum, and the bits are the same everywhere.
double sign_test(int one, int other);

}  // namespace sonde
