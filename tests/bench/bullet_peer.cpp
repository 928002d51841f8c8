// SPDX-License-Identifier: GPL-3.0-or-later
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <limits>

#include "tests/bench/peer.hpp"

namespace sonde::bench {
namespace {

/// A mesh in Bullet's arrays, and the shape over them.
class Shape {
 public:
  explicit Shape(const Soup& soup) {
    for (const Vec3& x : soup.vertices)
      for (int i = 0; i < 3; ++i) vertices_.push_back(static_cast<btScalar>(x[i]));
    for (const Triangle& t : soup.triangles)
      for (const std::uint32_t corner : t) indices_.push_back(static_cast<int>(corner));
    arrays_ = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(soup.triangles.size()), indices_.data(), 3 * sizeof(int),
        static_cast<int>(soup.vertices.size()), vertices_.data(), 3 * sizeof(btScalar));
    shape_ = std::make_unique<btGImpactMeshShape>(arrays_.get());
    shape_->setMargin(0);
    shape_->updateBound();  // builds the tree
  }
  btGImpactMeshShape* get() const { return shape_.get(); }

 private:
  std::vector<btScalar> vertices_;
  std::vector<int> indices_;
  std::unique_ptr<btTriangleIndexVertexArray> arrays_;
  std::unique_ptr<btGImpactMeshShape> shape_;
};

btTransform bullet_pose(const Transform& X) {
  const auto f = [](double x) { return static_cast<btScalar>(x); };
  const Mat3& R = X.R;
  return btTransform(btMatrix3x3(f(R(0, 0)), f(R(0, 1)), f(R(0, 2)), f(R(1, 0)), f(R(1, 1)),
                                 f(R(1, 2)), f(R(2, 0)), f(R(2, 1)), f(R(2, 2))),
                     btVector3(f(X.p.x()), f(X.p.y()), f(X.p.z())));
}

struct AnyContact : btCollisionWorld::ContactResultCallback {
  bool any = false;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* /*a*/,
                           int /*part_a*/, int /*triangle_a*/,
                           const btCollisionObjectWrapper* /*b*/, int /*part_b*/,
                           int /*triangle_b*/) override {
    any |= point.getDistance() <= 0;
    return 0;
  }
};

/// A world of two bodies.
class World {
 public:
  World(const Soup& a, const Soup& b)
      : shape_a_(std::make_shared<Shape>(a)),
        shape_b_(&a == &b ? shape_a_ : std::make_shared<Shape>(b)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_) {
    // contactPairTest asks for the algorithm of closest points, which registerAlgorithm leaves out.
    dispatcher_.registerClosestPointsCreateFunc(GIMPACT_SHAPE_PROXYTYPE, GIMPACT_SHAPE_PROXYTYPE,
                                                &gimpact_);
    object_a_.setCollisionShape(shape_a_->get());
    object_b_.setCollisionShape(shape_b_->get());
  }

  bool touch(const Transform& X_BA) {
    object_a_.setWorldTransform(bullet_pose(X_BA));
    AnyContact contact;
    world_.contactPairTest(&object_a_, &object_b_, contact);
    return contact.any;
  }

 private:
  std::shared_ptr<Shape> shape_a_, shape_b_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btGImpactCollisionAlgorithm::CreateFunc gimpact_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  btCollisionObject object_a_, object_b_;
};

btConvexHullShape hull_of(const Soup& soup) {
  btConvexHullShape hull;
  for (const Vec3& x : soup.vertices)
    hull.addPoint(btVector3(static_cast<btScalar>(x.x()), static_cast<btScalar>(x.y()),
                            static_cast<btScalar>(x.z())),
                  false);
  hull.recalcLocalAabb();
  hull.optimizeConvexHull();
  hull.setMargin(0);
  return hull;
}

/// The two convex hulls.
struct Hulls {
  Hulls(const Soup& soup_a, const Soup& soup_b) : a(hull_of(soup_a)), b(hull_of(soup_b)) {}

  double depth(const Transform& X_BA) const {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver solver;
    btVector3 direction(0, 0, 0), on_a, on_b;
    const bool found =
        solver.calcPenDepth(simplex, &a, &b, bullet_pose(X_BA), btTransform::getIdentity(),
                            direction, on_a, on_b, nullptr);
    return found ? static_cast<double>((on_a - on_b).length())
                 : std::numeric_limits<double>::infinity();
  }

  btConvexHullShape a, b;
};

Peer bullet_peer_of(const Soup& a, const Soup& b, const Vec3& /*com_a*/) {
  const auto world = std::make_shared<World>(a, b);
  Peer out;
  out.name = "Bullet";
  out.touch = [world](const Transform& X_BA) { return world->touch(X_BA); };
  out.touch_doubtful_within = 1e-4;
  const auto hulls = std::make_shared<const Hulls>(a, b);
  out.depth = [hulls](const Transform& X_BA) { return hulls->depth(X_BA); };
  return out;
}

}  // namespace

PeerLibrary bullet_library() {
  const auto build = [](const Soup& soup) -> std::shared_ptr<void> {
    return std::make_shared<Shape>(soup);
  };
  const int version = btGetVersion();
  return {"Bullet", std::to_string(version / 100) + "." + std::to_string(version % 100), build,
          bullet_peer_of};
}

}  // namespace sonde::bench
