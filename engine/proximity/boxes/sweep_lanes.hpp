// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/proximity/boxes/box_lanes.hpp"

namespace sonde {

/// The velocity of a rigid body at one moment, per unit of the path, in the frame of the boxes. The
/// point x, relative to the placed box's origin, has the velocity at_origin + angular × x, lengths
/// times the scale.
struct PlacedVelocity {
  float at_origin[3];
  float angular[3];
};

/// Bounds of the motion from that moment on.
struct PathBounds {
  float com[3];          ///< of the moving body, relative to the placed box's origin
  float acceleration;    ///< per distance from the centre of mass, per unit of the path squared
  float clearance;       ///< gap that must remain, including the rounding of the placing
  float speed_rounding;  ///< error bound of a speed
};

/// How far along the path the gap along one of the six face normals is certain to stay above the
/// clearance (conservative advancement): the best of the six, for one box against the sixteen of a
/// node; 0 if the gap is smaller than that already. In units of the path, rounded down.
struct SweepKernels {
  /// The single box moves, and those of the node stand still.
  void (*box_moves)(const PlacedBox& box, const PlacedVelocity& velocity, const PathBounds& path,
                    const Tree::Node& node, float scale, Lanes& out);
  /// The node's boxes move, in their own frame, and the single box stands still.
  void (*node_moves)(const PlacedBox& box, const PlacedVelocity& velocity, const PathBounds& path,
                     const Tree::Node& node, float scale, Lanes& out);
};

const SweepKernels& sweep_kernels();
std::span<const SweepKernels> all_sweep_kernels();

}  // namespace sonde
