// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/numbers.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/tuning/gain_sweep.hpp"
#include "engine/study/tuning/rest_ladder.hpp"

namespace sonde {

/// Whether the probe keeps oscillating for seconds at this stiffness, N/m | N·m/rad.
struct LongHold {
  double stiffness = 0;
  bool swings_without_friction = false;  ///< after the usual knock
  bool swings_at_harder_knocks = false;  ///< after the hardest, with the profile's friction
};

/// A sweep of the stiffness at one damping, as stored in a part of the study.
struct TuningColumn {
  double damping = 0;
  double theory_stable = 0;  ///< infinite if theory has no limit
  double theory_passive = 0;
  /// As in TheoryLimits; infinite if a study did not report it.
  double theory_released = infinity, theory_passive_in_translation = infinity;
  std::optional<double> theory_released_any_swing;  ///< no value if a study did not report it
  double cycle_lever = 0;                           ///< as TheoryLimits
  SweepLimit stable, good;
  /// The stability limits on a device without friction, and at harder_knocks; no value if a study
  /// did not search for them.
  std::optional<SweepLimit> without_friction, harder_knocks;
  /// No stiffness held without friction: the theoretical limit replaces the measured one.
  bool without_friction_by_theory = false;
  std::optional<LongHold> long_hold;  ///< no value if it was not made
  std::vector<SweepPoint> runs;
};

/// A finished part: one situation, hand and axis, with the assumed value that it varies.
struct TuningLine {
  std::size_t situation = 0;
  std::string kind;
  std::string hand;
  GainAxis axis = GainAxis::object;
  std::string assumed;  ///< a key of the profile; empty: the profile as it is
  double times = 1;
  std::vector<TuningColumn> columns;  ///< by damping
};

/// All results at the end of a study.
struct TuningResults {
  std::string about;  ///< JSON, as Study
  Coupling::Mode mode = Coupling::Mode::object;
  std::map<std::string, double> device;  ///< the profile's values by key
  std::string device_id;
  double sample_time = 1e-3;
  double max_force = 0, max_torque = 0;  ///< of the coupling, N and N·m
  bool trusts_friction = false;          ///< as TuningRequest
  JointGains joint;                      ///< if all gains were swept together
  /// Largest felt stiffness in each situation at gains of 1 N/m (and inertia/mass times that,
  /// N·m/rad, if rotations have their own).
  struct Felt {
    double translation = 0, rotation = 0;
  };
  std::vector<Felt> felt;
  double largest_inertia = 0;            ///< of the probe, Î, m²; 0: unknown
  bool always_held = false;              ///< as TuningRequest
  std::string only_kind;                 ///< of contact, the one studied; empty: every one found
  std::optional<DamperInTheory> damper;  ///< if the mode is the object norm; none: unknown
  std::optional<RestLadder> ladder;      ///< none: it was not climbed, or not yet
  std::vector<TuningLine> lines;         ///< those of the unchanged profile come first
};

bool has_friction(const TuningResults& results);

/// Keys of the profile that have no effect without friction.
bool is_friction(const std::string& key);

/// The name of the part that holds the ladder.
constexpr const char* ladder_part = "rest";

/// Reads a complete study of kind "tune". Throws InputError if a part is missing or was not written
/// by a study; `folder` is for the message.
TuningResults read_tuning(const std::string& folder, const StudyFolder& study);
/// What a study is about, without any line yet. Throws what the parser throws where no study wrote
/// it.
TuningResults results_without_lines(const std::string& about);

}  // namespace sonde
