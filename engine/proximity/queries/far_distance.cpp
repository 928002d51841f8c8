// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/far_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/base/numbers.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {
namespace {

/// In sizes of the bodies: at less than this distance, the float distances of boxes still
/// distinguish the parts of a body.
constexpr double far = 300;
/// Share of the distance: a smaller gain is rounding.
constexpr double rounding = 4e-15;
constexpr std::size_t most_candidates = 1024;

/// A triangle as seen along the line between the bodies: how far it extends towards the other body,
/// and a circle around it perpendicular to the line, m.
struct Seen {
  std::uint32_t triangle = 0;
  double towards = -infinity;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius = 0;
};

/// One of the bodies, seen from the other.
class View {
 public:
  /// `towards`: unit, in the body's frame, towards the other. `sideways`: two axes perpendicular to
  /// it, the same for both bodies.
  View(const Body& body, const Vec3& origin, const Vec3& towards,
       const std::array<Vec3, 2>& sideways)
      : body_(body), origin_(origin), towards_(towards), sideways_(sideways) {}

  Seen look(std::uint32_t triangle) const {
    Seen out{.triangle = triangle};
    std::array<Eigen::Vector2d, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 x = surface(body_).vertices[surface(body_).triangles[triangle][i]] - origin_;
      out.towards = std::max(out.towards, towards_.dot(x));
      at[i] = {sideways_[0].dot(x), sideways_[1].dot(x)};
      out.middle += at[i] / 3;
    }
    for (const Eigen::Vector2d& x : at) out.radius = std::max(out.radius, (x - out.middle).norm());
    return out;
  }
  Seen foremost() const {
    Seen out;
    for (std::uint32_t i = 0; i < count(); ++i)
      if (const Seen seen = look(i); seen.towards > out.towards) out = seen;
    return out;
  }
  std::uint32_t count() const {
    return static_cast<std::uint32_t>(surface(body_).triangles.size());
  }

 private:
  const Body& body_;
  Vec3 origin_, towards_;
  std::array<Vec3, 2> sideways_;
};

/// The triangles of one body that extend far enough towards the other; if there is no room for
/// them, all triangles of the body.
class Candidates {
 public:
  Candidates(const View& view, double least) : view_(view), least_(least) {
    for (std::uint32_t i = 0; i < view.count() && size_ <= most_candidates; ++i)
      if (const Seen seen = view.look(i); seen.towards >= least) {
        if (size_ < most_candidates) kept_[size_] = seen;
        ++size_;
      }
  }
  /// Calls visit(seen) for each.
  void visit(const auto& visit) const {
    if (size_ <= most_candidates) {
      for (const Seen& seen : std::span(kept_).first(size_)) visit(seen);
      return;
    }
    for (std::uint32_t i = 0; i < view_.count(); ++i)
      if (const Seen seen = view_.look(i); seen.towards >= least_) visit(seen);
  }

 private:
  const View& view_;
  double least_;
  std::array<Seen, most_candidates> kept_;
  std::size_t size_ = 0;
};

Vec3 middle_of(const Body& body) { return 0.5 * (body.tree.low + body.tree.high); }
double size_of(const Body& body) { return (body.tree.high - body.tree.low).norm(); }

}  // namespace

std::optional<Distance> far_distance(const Body& a, const Body& b, const Transform& X_BA) {
  const Vec3 middle_a = middle_of(a), middle_b = middle_of(b), away = X_BA * middle_a - middle_b;
  const double apart = away.stableNorm();
  if (!(apart > far * (size_of(a) + size_of(b)))) return std::nullopt;
  const Vec3 unit = away / apart, aside = unit.unitOrthogonal();
  const std::array<Vec3, 2> sideways_b{aside, unit.cross(aside)};
  const Mat3 R_AB = X_BA.R.transpose();
  const View of_a(a, middle_a, -(R_AB * unit), {R_AB * sideways_b[0], R_AB * sideways_b[1]}),
      of_b(b, middle_b, unit, sideways_b);

  const Seen first_a = of_a.foremost(), first_b = of_b.foremost();
  Distance best;
  best.distance = infinity;
  const auto compare = [&](const Seen& i, const Seen& j) {
    const ClosestPoints points = closest_points(place(X_BA, corners(surface(a), i.triangle)),
                                                corners(surface(b), j.triangle));
    if (points.distance < best.distance)
      best = {points.distance, points.a, points.b, i.triangle, j.triangle, false};
  };
  compare(first_a, first_b);
  const double gain = rounding * apart;
  // The sum of the distances by which two triangles may lie behind the foremost ones and still be
  // nearer.
  const double slack = best.distance - gain - (apart - first_a.towards - first_b.towards);
  if (!(slack > 0)) return best;
  const Candidates all_b(of_b, first_b.towards - slack);
  Candidates(of_a, first_a.towards - slack).visit([&](const Seen& i) {
    all_b.visit([&](const Seen& j) {
      const double along = apart - i.towards - j.towards;
      const double across = std::max(0.0, (i.middle - j.middle).norm() - i.radius - j.radius);
      if (std::sqrt(along * along + across * across) < best.distance - gain) compare(i, j);
    });
  });
  return best;
}

}  // namespace sonde
