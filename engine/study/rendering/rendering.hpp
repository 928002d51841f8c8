// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/scene/poses.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The haptic loop's result at one pose of a device path.
struct RenderedTick {
  double t = 0;                ///< s
  double moved = 0;            ///< √σ from the device pose before to this one, m; 0 at the first
  Vec3 force = Vec3::Zero();   ///< on the hand, fixed frame, before the device's limits, N
  Vec3 torque = Vec3::Zero();  ///< about the centre of mass, N·m
  double depth = 0;            ///< m
  int contacts = 0;            ///< clusters
  bool jumped = false;         ///< Separation::fell, as the engine reports it
  bool failed = false;         ///< no answer: there is no force
  bool converged = true;       ///< false: the way was blocked, or the budget ran out
  Pose separated;              ///< Q, X_FM
};

/// A device path as one method renders it, tick by tick.
using Rendering = std::vector<RenderedTick>;

/// The input of a rendering.
struct RenderSetup {
  Pair pair;
  Coupling coupling = {};     ///< its limits are not applied: they would hide differences
  Budget budget = {};         ///< of each tick; counted work, otherwise the bits are not the same
  StaticOptions search = {};  ///< for the first pose, if it overlaps
};

/// The stiffness against translation of a coupling, N/m: k, or k_t in the classic mode.
double stiffness_of(const Coupling& coupling);

/// Runs the haptic loop over the path. PD_t gets the torque of its clustered contacts
/// (ContactTorque), times the stiffness against translation, because its motion has no turn. Throws
/// Cancelled if `stop` returns true.
Rendering render(const RenderSetup& setup, Method method, std::span<const TimedPose> path,
                 const Stop& stop);

/// A rendering as JSON text, and back with the same bits. Throws InputError, naming `source`, if
/// the text is not a rendering.
std::string to_json(const Rendering& rendering);
Rendering rendering_of(const std::string& json, const std::string& source);

}  // namespace sonde
