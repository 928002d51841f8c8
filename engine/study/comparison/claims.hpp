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

/// A claim about PD_g, tested on what could have gone the other way.
struct TestedClaim {
  const char* key;
  const char* claim;
  Finding finding = Finding::undecided;
  int for_it = 0, against_it = 0;  ///< trials
  int alike = 0;                   ///< trials within 2 % of each other, which count for neither
  /// Of a split at least as uneven, either way, if both sides were as likely (sign test).
  double chance = 1;
};

/// A claim is supported or refuted where the chance is below this.
constexpr double significant = 0.05;

/// - Smoother force, smoother torque: by the total variation, trial by trial: a quarter of a second
///   in which both are in contact all the time. Both renderings are scaled to the same mean force
///   in it, since a softer one is not a smoother one; the torque goes with its force.
/// - Fewer steps, fewer pop-throughs: each is a trial. What counts as a step goes by the way of the
///   device, not by the size of the force.
/// - A torque nearer to the one that is known (TorqueRealism): tick by tick, at equal forces.
/// - More stable: contact by contact, the force at the same device pose where the coupling is as
///   stiff as the contact bears on the device. The one that renders more before it swings is the
///   more stable at equal forces. Without a device nothing was seen.
std::vector<TestedClaim> tested_claims(const Comparison& comparison);

/// The chance, if each were as likely, that of their sum at least as many fall on one side. The
/// time grows with their sum, and the bits are the same everywhere.
double sign_test(int one, int other);

}  // namespace sonde
