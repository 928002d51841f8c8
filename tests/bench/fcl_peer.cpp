// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bench/peer.hpp"

namespace sonde::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSS<double>>;
using FclPose = fcl::Transform3<double>;
using FclMotion = fcl::InterpMotion<double>;

std::shared_ptr<const Model> model_of(const Soup& soup) {
  auto model = std::make_shared<Model>();
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel(static_cast<int>(soup.triangles.size()),
                    static_cast<int>(soup.vertices.size()));
  model->addSubModel(soup.vertices, triangles);
  model->endModel();
  return model;
}

FclPose fcl_pose(const Transform& X) {
  FclPose out = FclPose::Identity();
  out.linear() = X.R;
  out.translation() = X.p;
  return out;
}

struct Pair {
  std::shared_ptr<const Model> a, b;
  Vec3 com_a;

  /// By matrices and a centre: the other constructors leave velocities or the centre unset.
  FclMotion motion(const Trip& trip) const {
    const Transform from(trip.from), to(trip.to);
    return {from.R, from.p, to.R, to.p, com_a};
  }
};

FclMotion standing() {
  return {Mat3::Identity(), Vec3::Zero(), Mat3::Identity(), Vec3::Zero(), Vec3::Zero()};
}

bool touch(const Pair& pair, const Transform& X_BA) {
  const fcl::CollisionRequest<double> request(1, false);
  fcl::CollisionResult<double> result;
  return fcl::collide(pair.a.get(), fcl_pose(X_BA), pair.b.get(), FclPose::Identity(), request,
                      result) > 0;
}

double distance(const Pair& pair, const Transform& X_BA) {
  const fcl::DistanceRequest<double> request(true);
  fcl::DistanceResult<double> result;
  fcl::distance(pair.a.get(), fcl_pose(X_BA), pair.b.get(), FclPose::Identity(), request, result);
  return result.min_distance;
}

double depth(const Pair& pair, const Transform& X_BA) {
  constexpr std::size_t all = 1'000'000;
  const fcl::CollisionRequest<double> request(all, true);
  fcl::CollisionResult<double> result;
  fcl::collide(pair.a.get(), fcl_pose(X_BA), pair.b.get(), FclPose::Identity(), request, result);
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < result.numContacts(); ++i)
    deepest = std::max(deepest, std::abs(result.getContact(i).penetration_depth));
  return deepest;
}

SweepAnswer sweep(const Pair& pair, const Trip& trip) {
  const FclMotion moving = pair.motion(trip), still = standing();
  fcl::ContinuousCollisionRequest<double> request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResult<double> result;
  fcl::continuousCollide(pair.a.get(), &moving, pair.b.get(), &still, request, result);
  return {result.is_collide, result.is_collide ? result.time_of_contact : 1};
}

/// What the library has for oriented boxes, but does not reach from continuousCollide.
SweepAnswer sweep_oriented(const Pair& pair, const Trip& trip) {
  using Node = fcl::detail::MeshConservativeAdvancementTraversalNodeOBBRSS<double>;
  const FclMotion moving = pair.motion(trip), still = standing();
  const fcl::CollisionRequest<double> request;
  fcl::CollisionResult<double> result;
  double free_until = 1;
  const bool hit = fcl::detail::conservativeAdvancementMeshOriented<fcl::OBBRSS<double>, Node>(
      *pair.a, &moving, *pair.b, &still, request, result, free_until);
  return {hit, hit ? free_until : 1};
}

Transform on_path(const Pair& pair, const Trip& trip, double s) {
  const FclMotion motion = pair.motion(trip);
  motion.integrate(s);
  FclPose X;
  motion.getCurrentTransform(X);
  return {X.linear(), X.translation()};
}

Peer fcl_peer_of(const Soup& a, const Soup& b, const Vec3& com_a) {
  const auto model_a = model_of(a);
  const Pair pair{model_a, &a == &b ? model_a : model_of(b), com_a};
  Peer out;
  out.name = "FCL";
  out.touch = [pair](const Transform& X_BA) { return touch(pair, X_BA); };
  out.distance = [pair](const Transform& X_BA) { return distance(pair, X_BA); };
  out.depth = [pair](const Transform& X_BA) { return depth(pair, X_BA); };
  out.sweep = [pair](const Trip& trip) { return sweep(pair, trip); };
  out.sweep_oriented = [pair](const Trip& trip) { return sweep_oriented(pair, trip); };
  out.on_path = [pair](const Trip& trip, double s) { return on_path(pair, trip, s); };
  return out;
}

}  // namespace

PeerLibrary fcl_library() {
  const auto build = [](const Soup& soup) -> std::shared_ptr<void> {
    return std::const_pointer_cast<Model>(model_of(soup));
  };
  return {"FCL", FCL_VERSION, build, fcl_peer_of};
}

}  // namespace sonde::bench
