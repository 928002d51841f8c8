// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sketch/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// Number of cells along the longest side.
constexpr double cells = 28;
/// In spacings: margin of the grid around the body. Outside the grid, the distance is that at the
/// nearest point of the grid's border plus the distance to that point.
constexpr double pad = 1.5;

}  // namespace

DistanceField::DistanceField()
    : low_(quad(Vec3::Constant(std::numeric_limits<float>::infinity()))), high_(low_) {}

DistanceField::DistanceField(const Body& solid) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : surface(solid).vertices)
    box.extend(solid.mass.R_MP.transpose() * (x - solid.mass.com));
  const double spacing = box.sizes().maxCoeff() / cells;
  spacing_ = static_cast<float>(spacing);
  per_spacing_ = static_cast<float>(1 / spacing);
  low_ = quad(box.min() - Vec3::Constant(pad * spacing));
  for (int i = 0; i < 3; ++i) {
    count_[i] = static_cast<int>(std::ceil(box.sizes()[i] / spacing + 2 * pad)) + 1;
  }
  set_most();
  high_ = low_ + spacing_ * __builtin_convertvector(count_ - 1, Quad);
  fill(solid);
}

DistanceField::DistanceField(const Parts& parts)
    : low_(parts.low),
      high_(parts.high),
      count_(parts.count),
      spacing_(parts.spacing),
      per_spacing_(parts.per_spacing),
      nodes_(parts.nodes) {
  if (!nodes_.empty()) set_most();
}

DistanceField::Parts DistanceField::parts() const {
  return {low_, high_, count_, spacing_, per_spacing_, nodes_};
}

void DistanceField::set_most() {
  for (int i = 0; i < 3; ++i) most_[i] = static_cast<float>(count_[i] - 1) * (1 - 1e-6f);
}

void DistanceField::fill(const Body& solid) {
  nodes_.reserve(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
  for (int k = 0; k < count_[2]; ++k)
    for (int j = 0; j < count_[1]; ++j)
      for (int i = 0; i < count_[0]; ++i) {
        const Vec3 local = vec3(low_) + static_cast<double>(spacing_) * Vec3(i, j, k);
        const Vec3 x = solid.mass.R_MP * local + solid.mass.com;
        const NearestPoint near = nearest_point(solid, x, 0);
        // Two neighbouring nodes are on the same side if one is further from the surface than from
        // the other.
        const bool same = i > 0 && near.distance > 1.001 * spacing();
        const double sign = (same ? nodes_.back()[3] < 0 : winds_around(solid, x)) ? -1 : 1;
        const Vec3 way = solid.mass.R_MP.transpose() * (x - near.point);
        nodes_.push_back(quad(sign / std::max(near.distance, 1e-300) * way,
                              static_cast<float>(sign * near.distance)));
      }
}

/// The distance beyond the border of the grid: from the border straight to the surface.
Quad DistanceField::beyond(const Quad& at_border, const Quad& way) const {
  Quad out = std::max(at_border[3], 0.0f) * at_border + way;
  out[3] = 0;
  const Quad squares = out * out;
  const float distance = std::sqrt(squares[0] + squares[1] + squares[2]);
  out /= std::max(distance, 1e-30f);
  out[3] = distance;
  return out;
}

}  // namespace sonde
