// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/gap_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

constexpr std::size_t looks_between_stops = 256;

/// The patch as it grows. The gap at a vertex that triangles share is computed once.
class Patch {
 public:
  Patch(const Body& body, const Body& other, const Pose& X_OM, const GapOptions& options,
        const Stop& stop)
      : body_(body), other_(other), X_OM_(X_OM), options_(options), stop_(stop) {
    box_ = {other.tree.low, other.tree.high};
  }

  GapField made() {
    for (std::size_t i = 0; i < body_.soup.triangles.size() && !stopped_; ++i) {
      const Triangle& t = body_.soup.triangles[i];
      if (!may_be_near(body_.soup.vertices[t[0]], body_.soup.vertices[t[1]],
                       body_.soup.vertices[t[2]]))
        continue;
      waiting_.push_back({own(t[0]), own(t[1]), own(t[2])});
    }
    // Each round cuts finer. When there is no room for more triangles, all are equally fine.
    while (!waiting_.empty() && !stopped_) {
      const bool finer = waiting_.size() + field_.patch.triangles.size() < options_.most;
      for (const Triangle& t : std::exchange(waiting_, {})) take(t, finer);
    }
    return stopped_ ? GapField{} : std::move(field_);
  }

 private:
  /// Compares boxes only, which costs almost nothing.
  bool may_be_near(const Vec3& a, const Vec3& b, const Vec3& c) const {
    Eigen::AlignedBox3d triangle(X_OM_ * a);
    triangle.extend(X_OM_ * b).extend(X_OM_ * c);
    return triangle.exteriorDistance(box_) <= options_.reach;
  }

  double gap(const Vec3& x) {
    if (stop_ && ++looks_ % looks_between_stops == 0 && stop_()) stopped_ = true;
    return stopped_ ? std::numeric_limits<double>::infinity() : point_distance(other_, X_OM_ * x);
  }

  std::uint32_t add(const Vec3& x) {
    field_.patch.vertices.push_back(x);
    field_.gaps.push_back(gap(x));
    return static_cast<std::uint32_t>(field_.gaps.size() - 1);
  }
  std::uint32_t own(std::uint32_t vertex) {
    const auto [at, fresh] = own_.try_emplace(vertex, 0);
    if (fresh) at->second = add(body_.soup.vertices[vertex]);
    return at->second;
  }
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [at, fresh] = middles_.try_emplace(std::uint64_t(low) << 32 | high, 0);
    if (fresh) at->second = add(0.5 * (point(a) + point(b)));
    return at->second;
  }
  const Vec3& point(std::uint32_t i) const { return field_.patch.vertices[i]; }

  void take(const Triangle& t, bool finer) {
    const Vec3 &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    const double longest =
        std::sqrt(std::max({(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()}));
    // The gap has Lipschitz constant 1, so no point of the triangle is nearer than least − longest.
    const double least = std::min({field_.gaps[t[0]], field_.gaps[t[1]], field_.gaps[t[2]]});
    if (least - longest > options_.reach || stopped_) return;
    if (!finer || longest <= options_.cell) {
      if (least <= options_.reach) field_.patch.triangles.push_back(t);
      return;
    }
    const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
    for (const Triangle& part : {Triangle{t[0], ab, ca}, Triangle{ab, t[1], bc},
                                 Triangle{ca, bc, t[2]}, Triangle{ab, bc, ca}})
      waiting_.push_back(part);
  }

  const Body& body_;
  const Body& other_;
  const Pose X_OM_;
  const GapOptions& options_;
  const Stop& stop_;
  Eigen::AlignedBox3d box_;
  GapField field_;
  std::vector<Triangle> waiting_;
  std::unordered_map<std::uint32_t, std::uint32_t> own_;
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
  std::size_t looks_ = 0;
  bool stopped_ = false;
};

}  // namespace

GapField gap_field(const Body& body, const Body& other, const Pose& X_OM, const GapOptions& options,
                   const Stop& stop) {
  return Patch(body, other, X_OM, options, stop).made();
}

}  // namespace sonde
