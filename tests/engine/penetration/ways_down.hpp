// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a separated pose is an optimum: straight free motions along which σ falls.
#pragma once

#include <Eigen/QR>
#include <cmath>
#include <random>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {

/// Are the poses on a straight way (in y) all free? Reference: exact predicates on all pairs of
/// triangles, beside those of the engine.
inline bool is_free_along(const Body& probe, const Body& fixed, const Chart& chart, const Vec6& y,
                          const Vec6& way, int samples) {
  const Placed still(fixed, Transform());
  for (int i = 1; i <= samples; ++i) {
    // Closer at first, where the contacts are.
    const double share = std::pow(double(i) / samples, 2);
    const Transform X(chart.pose(y + share * way));
    if (triangles_meet(probe, fixed, X, Doubt::contact)) return false;
    if (any_meet(Placed(probe, X), still)) return false;
  }
  return true;
}

/// A direction of unit length: any; or near that in which σ falls steepest; or a pure translation
/// or turn. The last leave a slot's mouth where few of the first do.
inline Vec6 random_way(const Vec6& y, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Vec6 way;
  for (double& x : way) x = normal(random);
  way.normalize();
  switch (random() % 4) {
    case 0:
      return way;
    case 1:
      return (uniform(random, 0, 2) * way - y.normalized()).normalized();
    case 2:
      way.head<3>() *= 0.03;
      return way.normalized();
    default:
      way.tail<3>() *= 0.03;
      return way.normalized();
  }
}

/// What a pose would do if it were held by some of its contacts alone: slide along these in the
/// direction in which σ falls steepest, and a little away from them, since they bend. A contact
/// that is none is left out in half of these.
inline std::vector<Vec6> ways_past_contacts(const Chart& chart, const Vec6& y,
                                            const ContactSet& contacts) {
  std::vector<Vec6> out;
  for (unsigned held = 0; held < 1u << contacts.size; ++held) {
    Eigen::Matrix<double, 6, Eigen::Dynamic> rows(6, 0);
    Vec6 away = Vec6::Zero();
    for (int i = 0; i < contacts.size; ++i) {
      if (!(held >> i & 1u)) continue;
      const Vec6 row = chart.row(y, contacts[i].on_probe, contacts[i].normal);
      rows.conservativeResize(6, rows.cols() + 1);
      rows.col(rows.cols() - 1) = row;
      away += row.normalized();
    }
    Vec6 along = -y;
    if (rows.cols() > 0) along += rows * rows.completeOrthogonalDecomposition().solve(y);
    for (const double lift : {0.01, 0.1, 0.3})
      if (const Vec6 way = along.normalized() + lift * away; along.norm() > 1e-6 * y.norm())
        out.push_back(way.normalized());
  }
  return out;
}

/// From a separated pose, of straight motions of 6.4e-3 R along which σ falls with a slope of a
/// tenth at least, the steepest that is free; 0 where none is. The motions are those past contacts
/// and so many random ones.
inline double steepest_way_down(const Body& probe, const Body& fixed, const Separation& s,
                                int tries, std::mt19937_64& random) {
  const Chart chart(probe.mass, s.device);
  const Vec6 y = chart.coordinates(s.separated);
  const double step = 6.4e-3 * probe.mass.radius;
  std::vector<Vec6> ways = ways_past_contacts(chart, y, s.contacts);
  for (int i = 0; i < tries; ++i) ways.push_back(random_way(y, random));
  double steepest = 0;
  for (Vec6& way : ways) {
    const double slope = std::abs(way.dot(y)) / y.norm();
    if (slope < 0.1 || slope <= steepest) continue;
    if (way.dot(y) > 0) way = -way;
    // Few places rule out most; a thin overlap between them is found by many.
    if (is_free_along(probe, fixed, chart, y, step * way, 8) &&
        is_free_along(probe, fixed, chart, y, step * way, 300))
      steepest = slope;
  }
  return steepest;
}

}  // namespace sonde::test
