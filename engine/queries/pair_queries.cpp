// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/pair_queries.hpp"

#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/search/clearance_of.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"
#include "engine/queries/checked_pose.hpp"

namespace sonde {
namespace {

/// R: the gap at the end of a swept path; larger than the rounding of poses of the probe's size.
constexpr double kept_gap = 1e-9;

/// @pre The pose is checked.
bool meet(const Pair& pair, const Pose& X) {
  const FreeTest test = test_free(pair.probe(), pair.fixed(), X);
  if (test.fault) throw InputError(test.fault);
  return !test.free;
}

/// The closest points of the two triangles.
Contact contact_of(const Body& probe, const Body& fixed, const Pose& X_FM, const Sweep& stop) {
  const ClosestPoints points =
      closest_points(place(Transform(X_FM), corners(surface(probe), stop.triangle_a)),
                     corners(surface(fixed), stop.triangle_b));
  Contact out;
  out.on_probe = points.a;
  out.on_fixed = points.b;
  if (points.distance > 0) out.normal = points.normal;
  out.gap = points.gap;
  return out;
}

}  // namespace

bool touch(const Pair& pair, const Pose& X_FM) {
  const RoundToNearest round_to_nearest;
  return meet(pair, checked_pose(X_FM));
}

Clearance distance(const Pair& pair, const Pose& X_FM) {
  const RoundToNearest round_to_nearest;
  const Pose X = checked_pose(X_FM);
  const Body &probe = pair.probe(), &fixed = pair.fixed();
  // If rounding is large, the exact test decides first whether a distance means anything.
  const double rounding = rounding_guard(extent(probe), extent(fixed), X.p);
  if (!(rounding < kept_gap * probe.mass.radius))
    return clearance_of(probe, fixed, X, meet(pair, X));
  Clearance apart = clearance_of(probe, fixed, X, false);
  // If the distance exceeds the rounding error, no two triangles meet.
  const bool clear = apart.distance > rounding;
  if (clear ? !component_inside(probe, fixed, Transform(X)) : !meet(pair, X)) return apart;
  return {0, apart.on_probe, apart.on_fixed, true};
}

SweptPath sweep(const Pair& pair, const Pose& X0_FM, const Pose& X1_FM) {
  const RoundToNearest round_to_nearest;
  const Pose from = checked_pose_of_motion(X0_FM), to = checked_pose_of_motion(X1_FM);
  SweptPath out;
  out.X_FM = from;
  if (meet(pair, from)) {
    out.hit = out.overlapping = true;
    return out;
  }
  const Body &probe = pair.probe(), &fixed = pair.fixed();
  const Motion motion(probe.mass, from, to);
  const Sweep swept = sweep(probe, fixed, motion, kept_gap * probe.mass.radius);
  out.free = swept.free_until;
  out.hit = swept.hit;
  out.X_FM = out.free >= 1 ? to : motion.pose_at(out.free);
  if (!out.hit) return out;
  // Far out, the path is so rough that any obstacle may be rounding.
  const Vec3 farthest = from.p.cwiseAbs().cwiseMax(to.p.cwiseAbs());
  if (is_rough(probe, fixed, farthest))
    throw InputError("the motion leads too far from the origin for the size of the probe");
  out.contact = contact_of(probe, fixed, out.X_FM, swept);
  return out;
}

}  // namespace sonde
