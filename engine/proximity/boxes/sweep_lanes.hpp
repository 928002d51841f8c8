// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/proximity/boxes/box_lanes.hpp"

namespace sonde {

/// The velocity of a rigid body at one moment, per unit of the path, in the frame of the boxes:
/// that of the point x, from the placed box's origin, is at_origin + angular × x, lengths times the
/// scale.
struct PlacedVelocity {
  float at_origin[3];
  float angular[3];
};

/// What bounds the path of the boxes from that moment on.
struct PathBounds {
  float com[3];          ///< of the moving body, from the placed box's origin
  float acceleration;    ///< per distance from the centre of mass, per unit of the path squared
  float clearance;       ///< what must be left of a gap, rounding of the placing included
  float speed_rounding;  ///< how far a speed may be off
};

/// How far along the path the gap along one of the six face normals is certain to stay above the
/// clearance: the best of the six, for one box against the sixteen of a node; 0 where they are
/// nearer than that now. In units of the path, rounded down.
struct SweepKernels {
  /// The one box moves, those of the node stand still.
  void (*box_moves)(const PlacedBox& box, const PlacedVelocity& velocity, const PathBounds& path,
                    const Tree::Node& node, float scale, Lanes& out);
  /// The node's boxes move, in their own frame, and the one stands still.
  void (*node_moves)(const PlacedBox& box, const PlacedVelocity& velocity, const PathBounds& path,
                     const Tree::Node& node, float scale, Lanes& out);
};

const SweepKernels& sweep_kernels();
std::span<const SweepKernels> all_sweep_kernels();

}  // namespace sonde
