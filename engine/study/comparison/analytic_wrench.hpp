// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/study/rendering/rendering.hpp"

namespace sonde {

/// The wrench that PD_g implies, where it is known without the solver:
///
/// - *half-space*: any probe that meets one face of a large box away from its edges, so that the
/// box acts as a half-space (half_space_below). PD_g is then a search over rotations only.
/// - *ball*: a solid probe whose faces all lie on a sphere about its centre of mass, within 3 %. No
/// contact turns it, so the torque is zero. The force is unknown.
/// - *none*: any other pair.
enum class AnalyticKind { none, ball, half_space };

struct AnalyticTick {
  std::size_t tick = 0;        ///< index in the path
  Vec3 force = Vec3::Zero();   ///< before the device's limits, N
  Vec3 torque = Vec3::Zero();  ///< N·m
};

struct AnalyticWrenches {
  AnalyticKind kind = AnalyticKind::none;
  std::vector<AnalyticTick> ticks;  ///< half-space only: some ticks of the path, evenly chosen
  /// Ball only: the largest torque of its facets, of force times radius. A contact of a facet may
  /// lie so far from where it would be on a sphere.
  double facets = 0;
};

/// At no more than `most_ticks` ticks of the path, where the wrench is known.
AnalyticWrenches analytic_wrenches(const RenderSetup& setup, std::span<const TimedPose> path,
                                   std::uint64_t seed, std::size_t most_ticks, const Stop& stop);

std::string to_json(const AnalyticWrenches& wrenches);
/// Throws InputError, naming `source`, if the text is not of this kind.
AnalyticWrenches analytic_wrenches_of(const std::string& json, const std::string& source);

/// The difference of a rendering from the analytic wrench.
struct TorqueRealism {
  AnalyticKind kind = AnalyticKind::none;
  std::size_t ticks = 0;  ///< number of ticks compared
  /// Half-space: |F − F*| / |F*|, median over the ticks and the worst.
  double force_error = 0, worst_force_error = 0;
  /// Half-space: |τ − τ*| / (R |F*|). Ball, in contact: |τ| / (R |F|). Median and worst.
  double torque_error = 0, worst_torque_error = 0;
  /// The same error at ticks of the path, with the rendering scaled to the known force (so that a
  /// smaller force is no better torque). For a ball, at intervals of a twentieth of a second.
  struct AtTick {
    std::size_t tick = 0;
    double error = 0;
  };
  std::vector<AtTick> at_equal_force = {};
  double facets = 0;  ///< of a ball: how far its own facets may put the torque off
};
TorqueRealism torque_realism(const Rendering& rendering, const AnalyticWrenches& analytic,
                             double radius);

}  // namespace sonde
