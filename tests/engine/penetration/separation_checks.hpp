// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of every answer to a penetration query, checked without the engine's own charts,
// trees and sweeps.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "tests/support/brute_force.hpp"

namespace sonde::test {

/// √σ between two poses, by the mean squared displacement of the probe's points.
inline double pose_distance(const Body& probe, const Pose& O, const Pose& Q) {
  return std::sqrt(std::max(0.0, mean_squared_displacement(moments(probe), O, Q)));
}

/// The promised clearance: max(1e-9 R, 1e-4 min(R, depth)).
inline double promised_clearance(double radius, double depth) {
  return std::max(1e-9 * radius, 1e-4 * std::min(radius, depth));
}

/// The row of a cluster at y. A couple of moment n is that of a force e along f, moved along e,
/// where e × f = n.
inline Vec6 row_of(const Chart& chart, const Vec6& y, const ContactCluster& cluster) {
  const Contact& c = cluster.contact;
  const Vec3 e = c.normal.unitOrthogonal(), f = c.normal.cross(e);
  return chart.row(y, c.on_probe, c.normal) +
         cluster.pitch * (chart.row(y, c.on_probe + e, f) - chart.row(y, c.on_probe, f));
}

/// The clusters add up to what the contacts add up to.
inline void check_clusters(const Chart& chart, const Vec6& y, const Separation& s, const Vec6& sum,
                           const std::string& what) {
  Vec6 by_clusters = Vec6::Zero();
  int rows = 0;
  for (const ContactCluster& c : s.clusters) {
    EXPECT_GT(c.contact.multiplier, 0) << what;
    by_clusters += c.contact.multiplier * row_of(chart, y, c);
    rows += c.rows;
  }
  EXPECT_EQ(rows, s.contacts.size) << what;
  EXPECT_EQ(s.clusters.size > 0, s.contacts.size > 0) << what;
  EXPECT_LT((by_clusters - sum).norm(), 1e-9 * s.depth + 1e-300) << what;
}

/// The contacts as they are reported: on the bodies, and adding up to y but for the residual.
inline void check_contacts(const Body& probe, const Body& fixed, const Separation& s,
                           const std::string& what) {
  const Chart chart(probe.mass, s.device);
  const Vec6 y = chart.coordinates(s.separated);
  const double size = probe.mass.radius + fixed.mass.radius + fixed.mass.com.norm();
  Vec6 sum = Vec6::Zero();
  for (const Contact& c : s.contacts) {
    EXPECT_GT(c.multiplier, 0) << what;
    EXPECT_NEAR(c.normal.norm(), 1, 1e-12) << what;
    EXPECT_GE(c.gap, 0) << what;
    // The gap is that along all of the triangles, of which closest_points() gives 0.999 of the
    // distance at least; but for points off by ε·size, which turn the normal by ε·size / gap: a
    // triangle sticks out by that times its own size.
    const double apart = c.normal.dot(c.on_probe - c.on_fixed);
    const double turned = std::numeric_limits<double>::epsilon() * size * size / apart;
    EXPECT_LE(c.gap, apart + 1e-13 * size) << what;
    EXPECT_GE(c.gap, 0.999 * apart - turned - 1e-13 * size) << what;
    EXPECT_LT(point_distance(probe, inverse(s.separated) * c.on_probe), 1e-12 * size) << what;
    sum += c.multiplier * chart.row(y, c.on_probe, c.normal);
  }
  check_clusters(chart, y, s, sum, what);
  if (s.rotation > 0) {
    EXPECT_NEAR((y - sum).norm(), s.residual * s.depth, 1e-9 * s.depth + 1e-13 * size) << what;
  }
}

/// Reference: exact predicates on all pairs of triangles, winding numbers of all vertices, and
/// second moments by integration.
inline void check_separation(const Body& probe, const Body& fixed, const Separation& s,
                             const std::string& what) {
  ASSERT_EQ(s.status, Status::penetrating) << what << ": " << s.reason;
  const Transform Q(s.separated);
  const double radius = probe.mass.radius;
  EXPECT_TRUE(is_free(probe, fixed, Q)) << what;
  EXPECT_LE(least_distance_of_pairs(probe, fixed, Q), promised_clearance(radius, s.depth)) << what;
  EXPECT_DOUBLE_EQ(s.depth * s.depth, s.sigma) << what;
  const double size = radius + probe.mass.com.norm() + s.separated.p.norm();
  EXPECT_NEAR(pose_distance(probe, s.device, s.separated), s.depth, 1e-9 * s.depth + 1e-13 * size)
      << what;
  EXPECT_NEAR(s.translation * s.translation + s.rotation * s.rotation, s.sigma, 1e-12 * s.sigma);
  if (s.lower_bound) {
    EXPECT_LE(*s.lower_bound, s.depth) << what;
  }
  if (s.pdt) {
    EXPECT_LE(s.depth, *s.pdt) << what;
  }
  check_contacts(probe, fixed, s, what);
}

}  // namespace sonde::test
