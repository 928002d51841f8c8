// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/simd/vectors.hpp"

namespace sonde {

using Quad = FloatX4;
inline Quad quad(const Vec3& x, float fourth = 0) {
  return Quad{static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]), fourth};
}
inline Vec3 vec3(const Quad& x) { return Vec3(x[0], x[1], x[2]); }

/// The approximate signed distance of points from the surface of a solid, negative inside, on a
/// grid about the body, in single precision. The grid is in the body's principal axes with the
/// origin at its centre of mass, so it does not depend on the mesh frame. Each node keeps the
/// distance and its gradient. Between nodes, their planes are interpolated, which is exact beside a
/// flat face and has an error of second order in the spacing beside a curved one. Features thinner
/// than the spacing may be lost. A heuristic for searches, not a bound.
class DistanceField {
 public:
  explicit DistanceField(const Body& solid);
  /// The field of a body without an inside: every point is far away.
  DistanceField();

  /// All the data of a field, for storage. There are no nodes if the body has no inside.
  struct Parts {
    Quad low{}, high{};
    IntX4 count{};
    float spacing = 0, per_spacing = 0;
    std::vector<Quad> nodes;
  };
  Parts parts() const;
  /// @pre Either there are no nodes, or one for each grid point, with at least two on each side.
  explicit DistanceField(const Parts& parts);

  /// The gradient (about a unit vector, away from the solid) and, as the fourth component, the
  /// distance, m, of a point. The point's fourth component is ignored. There must be a solid.
  Quad at(const Quad& x) const;

  /// Lower bound of the distance of a point from the solid, m: cheap, and useful far outside.
  float at_least(const Quad& x) const {
    const Quad below = low_ - x, above = x - high_;
    const Quad by = below > above ? below : above;
    return std::max(std::max(by[0], by[1]), by[2]);
  }

  double spacing() const { return static_cast<double>(spacing_); }  ///< m
  std::size_t bytes() const { return nodes_.capacity() * sizeof(Quad); }

 private:
  using Cell = IntX4;
  void fill(const Body& solid);
  void set_most();
  Quad beyond(const Quad& at_border, const Quad& way) const;

  Quad low_{}, high_{};  // of the grid
  Quad most_{};          // largest coordinate, in spacings from low_
  Cell count_{};
  float spacing_ = 0, per_spacing_ = 0;
  std::vector<Quad> nodes_;  // gradient, distance; x runs fastest
};

inline Quad DistanceField::at(const Quad& x) const {
  const Quad asked = (x - low_) * per_spacing_;
  Quad u = asked > Quad{} ? asked : Quad{};
  u = u < most_ ? u : most_;
  const Cell cell = __builtin_convertvector(u, Cell);
  const Quad f = u - __builtin_convertvector(cell, Quad);
  const std::ptrdiff_t dy = count_[0], dz = dy * count_[1];
  const Quad* const c = nodes_.data() + cell[0] + cell[1] * dy + cell[2] * dz;
  // The plane of each node is evaluated at x. Interpolated between two neighbours along an axis,
  // the gradients add f (1 − f) times the difference of their components along that axis.
  const Quad d0 = c[0] - c[1], d1 = c[dy] - c[dy + 1], d2 = c[dz] - c[dz + 1],
             d3 = c[dy + dz] - c[dy + dz + 1];
  const Quad a0 = c[0] - f[0] * d0, a1 = c[dy] - f[0] * d1, a2 = c[dz] - f[0] * d2,
             a3 = c[dy + dz] - f[0] * d3;
  const Quad e0 = a0 - a1, e1 = a2 - a3;
  const Quad b0 = a0 - f[1] * e0, b1 = a2 - f[1] * e1;
  const Quad along_z = b0 - b1, along_y = e0 - f[2] * (e0 - e1), x0 = d0 - f[1] * (d0 - d1),
             along_x = x0 - f[2] * (x0 - (d2 - f[1] * (d2 - d3)));
  Quad out = b0 - f[2] * along_z;
  const Quad bulge = f * (1.0f - f);
  out[3] += spacing_ * (bulge[0] * along_x[0] + bulge[1] * along_y[1] + bulge[2] * along_z[2]);
  const Cell inside = asked == u;
  if (inside[0] & inside[1] & inside[2]) return out;
  return beyond(out, (asked - u) * spacing_);
}

}  // namespace sonde
