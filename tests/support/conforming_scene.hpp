// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of conforming contact, each the same motion of the same two shapes however they are cut.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "tests/support/conforming.hpp"

namespace sonde::test {

constexpr double felt_stiffness = 500;  ///< k of the object norm, N/m

/// Two shapes and a motion. Shapes and poses are those of the untilted scene.
struct ConformingScene {
  std::string name;
  std::function<PolygonSoup(const Cutting&)> probe, fixed;
  std::vector<Pose> path;  ///< begins and ends free
};

/// The frames that a scene is given in, askew to each other and to the axes, or neither.
struct Skew {
  Quat probe = Quat::Identity();  ///< turns the probe's mesh in its frame
  Quat world = Quat::Identity();  ///< turns the whole scene
};
Skew askew();

/// What the hand feels in a tick, in the untilted scene's axes.
struct Felt {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();  ///< N; N·m
  double depth = 0;                                  ///< m
  Status status = Status::failed;
  bool converged = false, jumped = false;
  Pose separated;
};

struct BodyPairCut {
  std::shared_ptr<const Body> probe, fixed;
};
/// The scene's bodies; the fixed one is cut a little finer, so that edges cross.
BodyPairCut cut_bodies(const ConformingScene& scene, const Cutting& cutting, const Skew& skew = {});

/// Follows the path with the coherent solver, without a budget.
std::vector<Felt> follow(const BodyPairCut& bodies, const std::vector<Pose>& path,
                         const Skew& skew = {});

/// A block pressed 3 mm into a slab, slid and turned on it, and lifted. Its closed form: depth is
/// how far its face is below the slab's, the force k·depth along the normal, no torque.
ConformingScene block_on_slab();
/// The same, turned by that much about a line in the face.
ConformingScene block_on_slab_off(double angle);
/// How far the block's face is below the slab's at a pose of block_on_slab(), m; < 0 above.
double pressed_into_slab(const Pose& X);

/// A cylinder in a hole with 1 % clearance: pressed sideways onto a facet, slid along the axis,
/// turned about it and back, and let go. Until it turns, depth is how far its facet is pressed.
ConformingScene cylinder_in_hole();
/// How far the facet is pressed at a pose that is not turned, and along which normal.
double pressed_into_hole(const Pose& X);
Vec3 hole_normal();

/// A wedge lowered into its notch, pressed 2 mm, pushed sideways and slid along. Its closed form:
/// the separated wedge is seated, x = z = 0.
ConformingScene wedge_in_notch();

/// A peg lowered into its blind hole and drawn out again, off its axis by at most `shift` (m) and
/// askew by at most `tilt` (rad), both wandering. `lowest` (m, over the bottom of the hole; below
/// zero it is pressed onto that) is where it turns back, `step` how far it goes in a tick. `guided`
/// (m): it is on the axis until the tip is so far inside, and off it in full at twice as far.
struct PegPath {
  double shift = 0, tilt = 0, lowest = 1e-3, step = 5e-5, guided = 0;
};
ConformingScene peg_in_hole(double clearance, const PegPath& path);
/// Beside X on the axis: a pose that is free. Its σ from X is the most that X's depth may be.
Pose peg_on_axis(const Pose& X);

/// √σ between two poses.
double object_distance(const MassProperties& mass, const Pose& O, const Pose& Q);

/// A closed slow loop through a scene's contact in so many ticks, for the energy test.
std::vector<Pose> block_loop(int ticks);
std::vector<Pose> cylinder_loop(int ticks);
std::vector<Pose> wedge_loop(int ticks);

}  // namespace sonde::test
