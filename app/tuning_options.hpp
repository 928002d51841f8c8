// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/bodies.hpp"
#include "app/study_run.hpp"
#include "engine/study/tuning/tuning.hpp"

namespace sonde::app {

/// What the commands on gains share: the scene, the device, and where contacts are looked for.
struct TuningOptions {
  BodyOptions bodies;
  StudyOptions study;
  std::string device;
  std::string trajectory;
  std::string coupling_mode;
  std::string method = "pdg";
  std::uint64_t seed = 1;
};
void add_flags(CLI::App& parser, TuningOptions& options);

TuningRequest request_of(const Scene& scene, const TuningOptions& options, const Pair& pair,
                         const DeviceProfile& device);

/// Prints, on stderr, the gains of a scene that are stiffer than the device bears by its maker's
/// word: on it they are rendered as that (see engine/haptics/safety/borne_gains.hpp).
void note_gains(const Coupling& gains, const DeviceProfile& device, const MassProperties& mass);

/// Prints the contacts that a study is not about, on stderr.
void note_skipped(const Study& study);

}  // namespace sonde::app
