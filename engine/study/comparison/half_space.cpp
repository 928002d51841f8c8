// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/half_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"

namespace sonde {
namespace {

/// σ as a function of the turn v only, since the translation is vertical.
class TurnCost {
 public:
  TurnCost(const Body& body, const Pose& X_FM, const Plane& plane) : inertia_(body.mass.inertia) {
    up_ = body.mass.R_MP.transpose() * (X_FM.q.conjugate() * plane.normal);
    room_ = plane.height(X_FM * body.mass.com);
    for (const Vec3& x : body.soup.vertices)
      corners_.push_back(body.mass.R_MP.transpose() * (x - body.mass.com));
  }
  double operator()(const Vec3& v) const {
    const double vv = v.squaredNorm();
    if (vv > 1) return std::numeric_limits<double>::infinity();
    // The plane's normal in the frame of the turned body.
    const double w = std::sqrt(1 - vv);
    const Vec3 up = up_ - 2 * w * v.cross(up_) + 2 * v.cross(v.cross(up_));
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& c : corners_) lowest = std::min(lowest, up.dot(c));
    const double depth = std::max(0.0, -(room_ + lowest));
    return depth * depth + 4 * v.dot(inertia_.cwiseProduct(v));
  }
  /// The height by which the body must be lifted after the turn, m.
  double lift(const Vec3& v) const {
    return std::sqrt(std::max(0.0, (*this)(v)-4 * v.dot(inertia_.cwiseProduct(v))));
  }

 private:
  Vec3 inertia_;
  Vec3 up_;      ///< the plane's normal in principal axes at O
  double room_;  ///< height of the centre of mass over the plane
  std::vector<Vec3> corners_;
};

struct Point {
  Vec3 v;
  double cost;
};

/// One run of the simplex method of Nelder and Mead from a corner with the given edge.
Point simplex_search(const TurnCost& cost, const Vec3& start, double edge) {
  std::array<Point, 4> s;
  for (int i = 0; i < 4; ++i) {
    const Vec3 v = i == 0 ? start : Vec3(start + edge * Vec3::Unit(i - 1));
    s[static_cast<std::size_t>(i)] = {v, cost(v)};
  }
  const auto order = [&] {
    ordering::sort(s.begin(), s.end(),
                   [](const Point& a, const Point& b) { return a.cost < b.cost; });
  };
  const auto at = [&](const Vec3& v) { return Point{v, cost(v)}; };
  order();
  for (int i = 0; i < 600 && (s[3].v - s[0].v).norm() > 1e-13; ++i) {
    const Vec3 middle = (s[0].v + s[1].v + s[2].v) / 3, away = middle - s[3].v;
    const Point reflected = at(middle + away);
    if (reflected.cost < s[0].cost) {
      const Point further = at(middle + 2 * away);
      s[3] = further.cost < reflected.cost ? further : reflected;
    } else if (reflected.cost < s[2].cost) {
      s[3] = reflected;
    } else {
      const Point inner =
          at(reflected.cost < s[3].cost ? Vec3(middle + 0.5 * away) : Vec3(middle - 0.5 * away));
      if (inner.cost < std::min(reflected.cost, s[3].cost)) {
        s[3] = inner;
      } else {
        for (std::size_t k = 1; k < 4; ++k) s[k] = at(s[0].v + 0.5 * (s[k].v - s[0].v));
      }
    }
    order();
  }
  return s[0];
}

/// Restarts the simplex repeatedly where the last one ended, because at a kink it collapses early.
Point descend(const TurnCost& cost, Point from, double edge, int rounds) {
  for (int i = 0; i < rounds; ++i) {
    const double size = edge * elementary::pow(0.3, i % 6);
    const Point found = simplex_search(cost, from.v, i % 2 == 0 ? size : -size);
    if (found.cost < from.cost) from = found;
  }
  return from;
}

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;  // the same on every machine
}

/// Uniform in a ball, by rejection.
Vec3 in_ball(std::mt19937_64& random, double radius) {
  for (;;) {
    Vec3 x;
    for (double& c : x) c = 2 * uniform(random) - 1;
    if (x.squaredNorm() <= 1) return radius * x;
  }
}

}  // namespace

HalfSpaceSeparation half_space_separation(const Body& body, const Pose& X_FM, const Plane& plane,
                                          std::uint64_t seed, int starts) {
  const TurnCost cost(body, X_FM, plane);
  std::mt19937_64 random(seed);
  std::vector<Point> found;
  for (int i = 0; i < starts; ++i) {
    // Within the turns for which σ can be below that without a turn; small turns are the most
    // likely.
    const double part = uniform(random), most = part * part;
    const Vec3 v = i == 0 ? Vec3(Vec3::Zero()) : in_ball(random, most);
    found.push_back(descend(cost, {v, cost(v)}, 0.1, 3));
  }
  const auto cheaper = [](const Point& a, const Point& b) { return a.cost < b.cost; };
  ordering::sort(found.begin(), found.end(), cheaper);
  Point best = found.front();
  for (std::size_t i = 0; i < std::min<std::size_t>(4, found.size()); ++i)
    best = std::min(best, descend(cost, found[i], 0.05, 40), cheaper);

  Quat turn(std::sqrt(std::max(0.0, 1 - best.v.squaredNorm())), 0, 0, 0);
  turn.vec() = body.mass.R_MP * best.v;
  HalfSpaceSeparation out;
  out.depth = std::sqrt(best.cost);
  out.separated.q = X_FM.q * turn;
  // First the turn about the centre of mass, then the lift.
  out.separated.p =
      X_FM * body.mass.com - out.separated.q * body.mass.com + cost.lift(best.v) * plane.normal;
  return out;
}

std::vector<Plane> box_faces(const Body& body) {
  if (!body.solid || body.soup.vertices.size() != 8 || body.soup.triangles.size() != 12) return {};
  const double allowed = 1e-9 * body.mass.radius;
  std::vector<Plane> faces;
  for (const Triangle& t : body.soup.triangles) {
    const Vec3& a = body.soup.vertices[t[0]];
    const Vec3 normal =
        (body.soup.vertices[t[1]] - a).cross(body.soup.vertices[t[2]] - a).normalized();
    const Plane face{normal, normal.dot(a)};
    for (const Vec3& x : body.soup.vertices)
      if (face.height(x) > allowed) return {};  // not convex
    const auto same = [&](const Plane& f) { return f.normal.dot(normal) > 1 - 1e-9; };
    if (std::none_of(faces.begin(), faces.end(), same)) faces.push_back(face);
  }
  for (const Plane& f : faces)
    for (const Plane& g : faces) {
      const double cosine = std::abs(f.normal.dot(g.normal));
      if (cosine > 1e-9 && cosine < 1 - 1e-9) return {};
    }
  return faces.size() == 6 ? faces : std::vector<Plane>();
}

std::optional<Plane> half_space_below(const Body& probe, const Pose& X_FM,
                                      const std::vector<Plane>& faces) {
  const Vec3 com = X_FM * probe.mass.com;
  const double radius = probe.mass.radius;
  std::optional<Plane> top;
  for (const Plane& face : faces) {
    if (face.height(com) <= -3 * radius) continue;
    if (top) return std::nullopt;  // near an edge
    top = face;
  }
  if (!top) return std::nullopt;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& x : probe.soup.vertices) lowest = std::min(lowest, top->height(X_FM * x));
  return lowest < 0 && lowest > -radius ? top : std::nullopt;
}

}  // namespace sonde
