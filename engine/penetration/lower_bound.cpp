// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/lower_bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "engine/proximity/inside.hpp"
#include "engine/proximity/placement.hpp"
#include "engine/proximity/point_distance.hpp"

namespace sonde {
namespace {

/// μ(r) = max over unit n in the range of Î of |n×r|² / (nᵀÎn), r in principal axes; infinite where
/// a turn that costs nothing moves the point. Rounded up.
double leverage(const Vec3& inertia, const Vec3& r) {
  const Mat3 arm = r.squaredNorm() * Mat3::Identity() - r * r.transpose();
  Vec3 scale;
  for (int i = 0; i < 3; ++i) {
    if (inertia[i] > 0) {
      scale[i] = 1 / std::sqrt(inertia[i]);
    } else {
      // Off the axis of a line-like probe, if only by rounding, the bound says nothing.
      if (arm(i, i) > 1e-12 * inertia.maxCoeff()) return std::numeric_limits<double>::infinity();
      scale[i] = 0;
    }
  }
  const Mat3 weighted = scale.asDiagonal() * arm * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(weighted, Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues()[2]) * (1 + 1e-12);
}

/// Looks for the point of `points` that gives the best bound inside `solid`, nodes of its tree
/// first in which a better one may lie.
class Search {
 public:
  Search(const Body& points, const Body& solid, const Transform& X_SP, const MassProperties& mass,
         const Transform& X_RP, double best, const Deadline& deadline)
      : points_(points),
        solid_(solid),
        X_SP_(X_SP),
        mass_(mass),
        X_RP_(X_RP),
        best_(best),
        deadline_(deadline) {
    guard_ = rounding_guard(extent(points), extent(solid), X_SP.p);
  }

  double run() {
    visit(0);  // the root's slot
    return best_;
  }

 private:
  /// Signed depth of a corner in the solid (negative: outside, by that distance at least).
  double bound_at(const Vec3& x, double& depth) {
    const Vec3 in_solid = X_SP_ * x;
    depth = point_distance(solid_, in_solid) - guard_;
    if (depth <= 0 || !inside(solid_, in_solid)) {
      depth = -std::max(0.0, depth);
      return 0;
    }
    return depth / std::sqrt(1 + leverage(mass_.inertia, X_RP_ * x));
  }

  void visit(std::uint32_t slot) {
    if (++visited_ > most_visits || deadline_.passed()) return;
    // A corner of the first triangle speaks for all of the box: no point of it is deeper by more
    // than its distance from that corner.
    const Tree& tree = points_.tree;
    const Vec3 x = points_.soup.vertices[points_.soup.triangles[tree.first_triangle(slot)][0]];
    double depth = 0;
    best_ = std::max(best_, bound_at(x, depth));
    const std::uint32_t child = tree.child(slot);
    if (child & Tree::triangle_bit) return;
    if (depth + 2 * tree.half_diagonal(slot) <= best_) return;
    for (std::uint32_t k = 0; k < Tree::width && tree.nodes[child].child[k] != Tree::none; ++k)
      visit(child * Tree::width + k);
  }

  static constexpr int most_visits = 600;
  const Body& points_;
  const Body& solid_;
  Transform X_SP_;
  const MassProperties& mass_;
  Transform X_RP_;  // points' frame to the probe's principal frame at its centre of mass
  double best_;
  Deadline deadline_;
  double guard_ = 0;
  int visited_ = 0;
};

/// The i-th number of the van der Corput sequence to a base, in [0, 1).
double van_der_corput(int i, int base) {
  double x = 0;
  for (double digit = 1.0 / base; i > 0; i /= base, digit /= base) x += digit * (i % base);
  return x;
}

/// Points inside both of two solids, which need not be corners of either: a coarse cover of where
/// they may overlap, then a compass search from the best.
class InteriorSearch {
 public:
  InteriorSearch(const Body& probe, const Body& fixed, const Pose& X_FM, const Transform& principal)
      : probe_(probe), fixed_(fixed), back_(inverse(X_FM)), principal_(principal) {
    const Vec3 com = X_FM * probe.mass.com, reach = Vec3::Constant(probe.mass.radius);
    low_ = fixed.tree.low.cwiseMax(com - reach);
    high_ = fixed.tree.high.cwiseMin(com + reach);
    guard_ = rounding_guard(extent(probe), extent(fixed), X_FM.p);
  }

  double run(const Deadline& deadline) {
    const Vec3 size = high_ - low_;
    if (!(size.minCoeff() > 0)) return 0;
    Vec3 at = low_;
    double best = 0;
    for (int i = 1; i <= samples && !deadline.passed(); ++i) {
      const Vec3 u(van_der_corput(i, 2), van_der_corput(i, 3), van_der_corput(i, 5));
      try_point(low_ + u.cwiseProduct(size), best, at);
    }
    if (best <= 0) return 0;
    for (double stride = 0.1; stride > 1e-3; stride *= 0.5)
      for (int i = 0; i < 3; ++i)
        for (const double sign : {1.0, -1.0})
          try_point(at + sign * stride * size[i] * Vec3::Unit(i), best, at);
    return best;
  }

 private:
  void try_point(const Vec3& x, double& best, Vec3& at) const {
    const Vec3 in_probe = back_ * x;
    if (!inside(fixed_, x) || !inside(probe_, in_probe)) return;
    const double depth =
        std::max(point_distance(fixed_, x), point_distance(probe_, in_probe)) - guard_;
    const double bound =
        depth / std::sqrt(1 + leverage(probe_.mass.inertia, principal_ * in_probe));
    if (bound > best) best = bound, at = x;
  }

  static constexpr int samples = 200;
  const Body& probe_;
  const Body& fixed_;
  Transform back_, principal_;
  Vec3 low_, high_;
  double guard_;
};

}  // namespace

std::optional<double> depth_lower_bound(const Body& probe, const Body& fixed, const Pose& X_FM,
                                        const Deadline& deadline) {
  if (!probe.solid && !fixed.solid) return std::nullopt;
  const Transform X(X_FM), back(inverse(X_FM));
  const Mat3 R_PM = probe.mass.R_MP.transpose();
  const Transform principal(R_PM, -(R_PM * probe.mass.com));
  double best = 0;
  if (fixed.solid) best = Search(probe, fixed, X, probe.mass, principal, best, deadline).run();
  if (probe.solid) {
    const Transform from_fixed(principal.R * back.R, principal.R * back.p + principal.p);
    best = Search(fixed, probe, back, probe.mass, from_fixed, best, deadline).run();
  }
  if (probe.solid && fixed.solid)
    best = std::max(best, InteriorSearch(probe, fixed, X_FM, principal).run(deadline));
  return best * (1 - 1e-9);
}

}  // namespace sonde
