// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/corner_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

/// A fan of a disc has any number of triangles in few planes, one of a pole many planes.
constexpr std::size_t most_compared = 64;
/// A point is on all planes where it is to this part of the way.
constexpr double on_planes = 1e-9;
/// The common point of three planes is the corner unless it is further off than the nearest point
/// behind them all by this factor: planes that are nearly parallel to one line.
constexpr double too_far = 4;

}  // namespace

CornerPlanes::CornerPlanes(const Soup& soup, const Fans& fans, double by, double rounding,
                           const Progress& progress)
    : soup_(soup), fans_(fans), way_(std::abs(by)), sign_(by < 0 ? -1 : 1) {
  find_planes(rounding, progress);
}

void CornerPlanes::find_planes(double rounding, const Progress& progress) {
  const std::size_t n = soup_.triangles.size();
  normal_.resize(n);
  area_.resize(n);
  has_say_.resize(n);
  tilt_.resize(n);
  first_.assign(fans_.count() + 1, 0);
  for_each_index(n, progress, [&](std::size_t t) {
    const Vec3 v = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (corner(t, (k + 1) % 3) - corner(t, k)).norm());
    area_[t] = v.norm();
    normal_[t] = v / area_[t];
    has_say_[t] = area_[t] > rounding * longest;
    tilt_[t] = std::max(one_plane, rounding * longest / area_[t]);
    for (const std::uint32_t fan : fans_.of[t]) ++first_[fan + 1];
  });
  for (const auto& [fan, triangle] : fans_.beside) ++first_[fan + 1];
  for (std::size_t i = 0; i < fans_.count(); ++i) first_[i + 1] += first_[i];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  faces_.resize(first_.back());
  for (std::uint32_t t = 0; t < n; ++t)
    for (const std::uint32_t fan : fans_.of[t]) faces_[next[fan]++] = t;
  for (const auto& [fan, triangle] : fans_.beside) faces_[next[fan]++] = triangle;
}

std::vector<HalfSpace3> CornerPlanes::planes_of(std::uint32_t fan) const {
  std::vector<HalfSpace3> planes;  // the normals weighted by the area, until the end
  std::vector<std::uint32_t> faces;
  for_faces(fan, [&](std::uint32_t t) { faces.push_back(t); });
  // Those first that tell their planes best.
  std::ranges::stable_sort(faces, {}, [&](std::uint32_t t) { return tilt_[t]; });
  for (const std::uint32_t t : faces) {
    const std::size_t from = planes.size() > most_compared ? planes.size() - most_compared : 0;
    const auto same = std::find_if(
        planes.begin() + static_cast<std::ptrdiff_t>(from), planes.end(),
        [&](const HalfSpace3& plane) {
          return (plane.normal.normalized() - normal_[t]).squaredNorm() <= tilt_[t] * tilt_[t];
        });
    if (same != planes.end())
      same->normal += area_[t] * normal_[t];
    else
      planes.push_back({area_[t] * normal_[t], way_});
  }
  for (HalfSpace3& plane : planes) plane.normal = sign_ * plane.normal.normalized();
  return planes;
}

Vec3 CornerPlanes::way_of(std::uint32_t fan) const {
  const std::vector<HalfSpace3> planes = planes_of(fan);
  const Vec3 common = nearest_to_planes(planes);
  const bool on_all = std::ranges::all_of(planes, [&](const HalfSpace3& plane) {
    return std::abs(plane.normal.dot(common) - way_) <= on_planes * way_;
  });
  if (on_all && planes.size() < 3) return limited(common);
  const std::optional<Vec3> nearest = nearest_in(planes, Vec3::Zero(), 1e-12 * way_);
  const double most = most_inward_way * way_;
  if (on_all && common.norm() <= (nearest ? too_far * nearest->norm() : most))
    return limited(common);
  if (nearest && nearest->norm() <= most) return limited(*nearest);
  return sign_ * way_ * mean_normal(fan);
}

Vec3 CornerPlanes::limited(const Vec3& way) const {
  const double most = sign_ > 0 ? most_outward_way * way_ : way.norm();
  return way.norm() <= most ? way : Vec3(most / way.norm() * way);
}

/// Weighted by the angles, which does not depend on how the faces are cut (Bærentzen and Aanæs,
/// 2005).
Vec3 CornerPlanes::mean_normal(std::uint32_t fan) const {
  Vec3 sum = Vec3::Zero();
  for_faces(fan, [&](std::uint32_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (fans_.of[t][k] != fan) continue;
      const Vec3 a = corner(t, (k + 1) % 3) - corner(t, k);
      const Vec3 b = corner(t, (k + 2) % 3) - corner(t, k);
      sum += elementary::atan2(a.cross(b).norm(), a.dot(b)) * normal_[t];
    }
  });
  return sum.norm() > 0 ? Vec3(sum.normalized()) : Vec3(Vec3::Zero());
}

double file_rounding(const Soup& soup) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : soup.vertices) box.extend(x);
  if (box.isEmpty()) return 0;
  const double farthest =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::min(double(std::numeric_limits<float>::epsilon()) * farthest,
                  1e-6 * box.sizes().maxCoeff());
}

}  // namespace sonde
