// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/witness.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/penetration/bound/bound_tuning.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// The latest gradients, and the least vector of their convex hull: an ascent direction for all of
/// them (after the bundle methods of Lemaréchal).
class Bundle {
 public:
  void clear() { size_ = 0; }
  void add(const Vec3& g) {
    if (size_ == most) {
      std::rotate(g_.begin(), g_.begin() + 1, g_.end());
      --size_;
    }
    g_[size_++] = g;
  }
  /// Computed with Frank-Wolfe steps.
  Vec3 least() const {
    Vec3 p = g_[size_ - 1];
    for (int i = 0; i < bound_tuning.bundle_steps; ++i) {
      Vec3 low = p;
      for (std::size_t k = 0; k < size_; ++k)
        if (p.dot(g_[k]) < p.dot(low)) low = g_[k];
      const Vec3 d = low - p;
      if (!(d.squaredNorm() > 0)) break;
      p += std::clamp(-p.dot(d) / d.squaredNorm(), 0.0, 1.0) * d;
    }
    return p;
  }

 private:
  static constexpr std::size_t most = bound_tuning.bundle;
  std::array<Vec3, most> g_;
  std::size_t size_ = 0;
};

}  // namespace

CommonDepth::CommonDepth(const Body& probe, const Body& fixed, const Pose& X_FM)
    : probe_(probe),
      fixed_(fixed),
      X_FM_(X_FM),
      X_MW_(probe.mass.R_MP, probe.mass.com),
      guard_(2 * rounding_guard(extent(probe), extent(fixed), X_FM.p)) {
  X_FW_ = Transform(X_FM_.R * X_MW_.R, X_FM_ * X_MW_.p);
}

CommonDepth::Side CommonDepth::side(const Body& body, const Vec3& x, double known) const {
  const NearestPoint near = nearest_point(body, x, 0);
  // Within the guard, the side does not matter, and a ray cast so near a triangle is expensive.
  const bool clear = body.solid && near.distance > guard_;
  const bool in = clear && (known != 0 ? known > 0 : winds_around(body, x));
  const Vec3 away = near.distance > 0 ? Vec3((x - near.point) / near.distance) : Vec3::Zero();
  return in ? Side{near.distance - guard_, away} : Side{-near.distance - guard_, -away};
}

CommonPoint CommonDepth::evaluate(const Mat3& R, const Vec3& x, double known_a,
                                  double known_b) const {
  ++evaluations_;
  CommonPoint out{x, R.transpose() * x, 0, 0, {}, {}};
  const Side a = side(probe_, X_MW_ * out.r, known_a), b = side(fixed_, X_FW_ * x, known_b);
  out.a = a.depth, out.up_a = R * (X_MW_.R.transpose() * a.up);
  out.b = b.depth, out.up_b = X_FW_.R.transpose() * b.up;
  return out;
}

CommonPoint CommonDepth::at(const Mat3& R, const Vec3& x) const { return evaluate(R, x, 0, 0); }

CommonPoint CommonDepth::at(const Mat3& R, const Vec3& x, const CommonPoint& known) const {
  const double step = (x - known.x).norm() + 4 * guard_;
  return evaluate(R, x, std::abs(known.a) > step ? known.a : 0,
                  std::abs(known.b) > step ? known.b : 0);
}

CommonPoint CommonDepth::ascend(const Mat3& R, const CommonPoint& start, double stride,
                                int evaluations) const {
  CommonPoint best = start;
  Bundle bundle;
  bundle.add(best.up());
  // Finding any common point is worth more evaluations than finding a deeper one.
  for (int i = 0;
       i < evaluations || (best.depth() <= 0 && i < bound_tuning.more_without_any * evaluations);
       ++i) {
    const Vec3 up = bundle.least();
    if (up.norm() < bound_tuning.level) {
      // The top of a ridge, at this stride.
      if (best.up().norm() < bound_tuning.level) break;
      stride *= bound_tuning.stride_at_top;
      bundle.clear();
      bundle.add(best.up());
      continue;
    }
    const CommonPoint next = at(R, best.x + stride / up.norm() * up, best);
    bundle.add(next.up());
    const bool better = next.depth() > best.depth();
    if (better) best = next;
    stride *= better ? bound_tuning.stride_growth : bound_tuning.stride_decay;
  }
  return best;
}

}  // namespace sonde
