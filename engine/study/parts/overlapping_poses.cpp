// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/overlapping_poses.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/error.hpp"
#include "engine/geometry/random.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde {
namespace {

bool overlaps(const Body& probe, const Body& fixed, const Pose& X_FM) {
  return overlap(probe, fixed, Transform(X_FM), Doubt::exact);
}

/// Points of a soup's triangles, uniform by area.
class SurfacePoints {
 public:
  explicit SurfacePoints(const Soup& soup) : soup_(soup) {
    double sum = 0;
    for (const Triangle& t : soup.triangles) {
      const auto [a, b, c] = corners(t);
      area_up_to_.push_back(sum += (b - a).cross(c - a).norm());
    }
  }

  Vec3 draw(Random& random) const {
    const double at = random.uniform(0, area_up_to_.back());
    const auto found = std::ranges::upper_bound(area_up_to_, at);
    const auto i = std::min<std::size_t>(static_cast<std::size_t>(found - area_up_to_.begin()),
                                         area_up_to_.size() - 1);
    const auto [a, b, c] = corners(soup_.triangles[i]);
    const double root = std::sqrt(random.uniform(0, 1)), along = random.uniform(0, 1);
    return a + root * ((b - a) + along * (c - b));
  }

 private:
  std::array<Vec3, 3> corners(const Triangle& t) const {
    return {soup_.vertices[t[0]], soup_.vertices[t[1]], soup_.vertices[t[2]]};
  }
  const Soup& soup_;
  std::vector<double> area_up_to_;  // twice the area of the triangles up to each, m²
};

}  // namespace

std::vector<Pose> overlapping_poses(const Body& probe, const Body& fixed,
                                    std::span<const Pose> poses, std::size_t most,
                                    const Stop& stop) {
  std::vector<Pose> all;
  for (const Pose& pose : poses) {
    if (stop()) throw Cancelled();
    if (overlaps(probe, fixed, pose)) all.push_back(pose);
  }
  if (most == 0 || all.size() <= most) return all;
  std::vector<Pose> out;  // the middle one of each of so many stretches
  for (std::size_t i = 0; i < most; ++i) out.push_back(all[(2 * i + 1) * all.size() / (2 * most)]);
  return out;
}

std::vector<Pose> random_overlapping_poses(const Body& probe, const Body& fixed, std::size_t count,
                                           std::uint64_t seed, const Stop& stop) {
  constexpr std::size_t tries_each = 100;
  const SurfacePoints on_probe(probe.soup), on_fixed(fixed.soup);
  Random random(seed);
  std::vector<Pose> out;
  for (std::size_t i = 0; i < count * tries_each && out.size() < count; ++i) {
    if (stop()) throw Cancelled();
    const Quat q = random.rotation();
    const Vec3 a = on_probe.draw(random), b = on_fixed.draw(random);
    const Pose pose{q, b - q * a};
    if (overlaps(probe, fixed, pose)) out.push_back(pose);
  }
  return out;
}

}  // namespace sonde
