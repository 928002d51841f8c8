// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine/geometry/soup.hpp"
#include "engine/geometry/transform.hpp"
#include "tests/bench/poses.hpp"

namespace sonde::bench {

struct SweepAnswer {
  bool hit = false;
  double free_until = 1;  ///< share of the path, 0 to 1
};

/// Another library, holding one pair of meshes. A function left empty: it does not answer that.
struct Peer {
  std::string name;
  /// Do triangles meet?
  std::function<bool(const Transform& X_BA)> touch;
  /// Its touch answers say nothing about poses nearer to touching than this, m.
  double touch_doubtful_within = 0;
  std::function<double(const Transform& X_BA)> distance;
  /// What it calls the depth of penetration where they overlap, m; not finite where it finds none.
  std::function<double(const Transform& X_BA)> depth;
  std::function<SweepAnswer(const Trip& trip)> sweep;
  /// The same by a function that is not part of its interface.
  std::function<SweepAnswer(const Trip& trip)> sweep_oriented;
  /// The pose at a share s of the path that its sweeps take for a trip.
  std::function<Transform(const Trip& trip, double s)> on_path;
};

/// A library that is compared with: how it builds what it asks of one mesh, and of a pair.
struct PeerLibrary {
  std::string name;
  std::string version;
  std::function<std::shared_ptr<void>(const Soup&)> build;
  /// `com_a`: what A turns about on a trip, in its mesh frame.
  std::function<Peer(const Soup& a, const Soup& b, const Vec3& com_a)> pair;
};

/// The Flexible Collision Library, BVHModel<OBBRSS<double>>. Touch: collide, ended by the first
/// contact. Distance: distance without tolerances, with the nearest points. Sweep:
/// continuousCollide by conservative advancement on InterpMotion, which goes from the first pose
/// to the last with a constant velocity and a constant angular velocity about A's centre of mass.
/// That rebuilds the tree of the moved mesh for each step, and moves what it has moved before;
/// the library's own advancement for oriented boxes, which it does not reach, is measured too.
/// Depth: the largest of all contacts of collide.
PeerLibrary fcl_library();

/// Bullet in its build for single precision, btGImpactMeshShape with margin 0. Touch:
/// btCollisionWorld::contactPairTest, which has no way to end at the first contact: it collects all
/// of them. It has neither a distance nor a sweep of two such meshes. Depth: that of the two convex
/// hulls, by its expanding-polytope solver.
PeerLibrary bullet_library();

/// Those that the program was built with.
std::vector<PeerLibrary> installed_peers();

}  // namespace sonde::bench
