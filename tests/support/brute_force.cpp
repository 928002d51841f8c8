// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/brute_force.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

using Real = long double;
using RealVec = Eigen::Matrix<Real, 3, 1>;
using RealMatrix = Eigen::Matrix<Real, 3, Eigen::Dynamic, 0, 3, 4>;

/// The corners of one feature of a triangle: bit i of `mask` takes corner i.
std::vector<RealVec> feature(const Corners& t, unsigned mask) {
  std::vector<RealVec> out;
  for (unsigned i = 0; i < 3; ++i)
    if (mask >> i & 1u) out.push_back(t[i].cast<Real>());
  return out;
}

/// The point of a feature with these coordinates along its edges from its first corner, drawn into
/// it; false where it lies outside by more than rounding.
bool point_of(const std::vector<RealVec>& f, const Real* along, RealVec& x) {
  std::array<Real, 3> weight{};
  Real sum = 0;
  for (std::size_t i = 1; i < f.size(); ++i) sum += along[i - 1], weight[i] = along[i - 1];
  weight[0] = 1 - sum;
  sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (weight[i] < -1e-9L) return false;
    sum += weight[i] = std::max<Real>(0, weight[i]);
  }
  x = RealVec::Zero();
  for (std::size_t i = 0; i < f.size(); ++i) x += weight[i] / sum * f[i];
  return true;
}

Vec3 any_vertex(const Body& body, std::uint32_t triangle, std::size_t corner) {
  return surface(body).vertices[surface(body).triangles[triangle][corner]];
}

bool a_vertex_is_inside(const Body& body, const Body& solid, const Transform& X) {
  for (std::uint32_t i = 0; i < surface(body).triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (std::lround(solid_angle_winding(solid, X * any_vertex(body, i, k))) != 0) return true;
  return false;
}

}  // namespace

std::vector<Corners> placed_triangles(const Body& body, const Transform& X) {
  std::vector<Corners> out;
  for (std::uint32_t i = 0; i < surface(body).triangles.size(); ++i)
    out.push_back(
        {X * any_vertex(body, i, 0), X * any_vertex(body, i, 1), X * any_vertex(body, i, 2)});
  return out;
}

bool any_pair_meets(const Body& a, const Body& b, const Transform& X_BA) {
  const auto of_b = placed_triangles(b, {});
  for (const Corners& ta : placed_triangles(a, X_BA))
    for (const Corners& tb : of_b)
      if (meet_exactly(ta, tb)) return true;
  return false;
}

double solid_angle_winding(const Body& body, const Vec3& x) {
  double sum = 0;
  for (std::uint32_t i = 0; i < surface(body).triangles.size(); ++i) {
    const Vec3 a = any_vertex(body, i, 0) - x, b = any_vertex(body, i, 1) - x,
               c = any_vertex(body, i, 2) - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.cross(b).dot(c), la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
  }
  return sum / (2 * std::numbers::pi);
}

bool is_free(const Body& a, const Body& b, const Transform& X_BA) {
  if (any_pair_meets(a, b, X_BA)) return false;
  if (b.solid && a_vertex_is_inside(a, b, X_BA)) return false;
  const Transform X_AB(X_BA.R.transpose(), -(X_BA.R.transpose() * X_BA.p));
  return !(a.solid && a_vertex_is_inside(b, a, X_AB));
}

double least_distance_of_pairs(const Body& a, const Body& b, const Transform& X_BA) {
  double best = std::numeric_limits<double>::infinity();
  const auto of_b = placed_triangles(b, {});
  for (const Corners& ta : placed_triangles(a, X_BA))
    for (const Corners& tb : of_b) best = std::min(best, closest_points(ta, tb).distance);
  return best;
}

DistanceBounds triangle_distance_bounds(const Corners& a, const Corners& b) {
  Real upper = std::numeric_limits<Real>::infinity(), lower = 0;
  for (unsigned ma = 1; ma < 8; ++ma)
    for (unsigned mb = 1; mb < 8; ++mb) {
      const auto fa = feature(a, ma), fb = feature(b, mb);
      const auto na = static_cast<Eigen::Index>(fa.size()) - 1,
                 nb = static_cast<Eigen::Index>(fb.size()) - 1;
      Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 4, 1> along(na + nb);
      if (na + nb > 0) {
        RealMatrix edges(3, na + nb);
        for (Eigen::Index i = 0; i < na; ++i)
          edges.col(i) = fa[static_cast<std::size_t>(i) + 1] - fa[0];
        for (Eigen::Index i = 0; i < nb; ++i)
          edges.col(na + i) = fb[0] - fb[static_cast<std::size_t>(i) + 1];
        along = edges.colPivHouseholderQr().solve(fb[0] - fa[0]);
      }
      RealVec x, y;
      if (!point_of(fa, along.data(), x) || !point_of(fb, along.data() + na, y)) continue;
      const RealVec way = x - y;
      const Real distance = way.norm();
      if (distance < upper) upper = distance;
      if (!(distance > 0)) continue;
      Real low = std::numeric_limits<Real>::infinity(), high = -low;
      for (const Vec3& p : a) low = std::min(low, way.dot(p.cast<Real>() - y) / distance);
      for (const Vec3& p : b) high = std::max(high, way.dot(p.cast<Real>() - y) / distance);
      lower = std::max(lower, low - high);
    }
  return {static_cast<double>(lower), static_cast<double>(upper)};
}

Moments moments(const Body& body) {
  Moments m;
  Mat3 second = Mat3::Zero();
  Vec3 first = Vec3::Zero();
  // About a point of the body, so that nothing cancels far from the origin.
  const Vec3 base = any_vertex(body, 0, 0);
  for (std::uint32_t i = 0; i < surface(body).triangles.size(); ++i) {
    const std::array<Vec3, 3> v = {any_vertex(body, i, 0) - base, any_vertex(body, i, 1) - base,
                                   any_vertex(body, i, 2) - base};
    const Vec3 sum = v[0] + v[1] + v[2];
    Mat3 squares = sum * sum.transpose();
    for (const Vec3& x : v) squares += x * x.transpose();
    if (body.solid) {
      const double volume = v[0].dot(v[1].cross(v[2])) / 6;
      m.measure += volume;
      first += volume / 4 * sum;
      second += volume / 20 * squares;
    } else {
      const double area = (v[1] - v[0]).cross(v[2] - v[0]).norm() / 2;
      m.measure += area;
      first += area / 3 * sum;
      second += area / 12 * squares;
    }
  }
  const Vec3 com = first / m.measure;
  m.com = base + com;
  m.covariance = second / m.measure - com * com.transpose();
  return m;
}

double mean_squared_displacement(const Moments& m, const Pose& O, const Pose& Q) {
  const Mat3 turn = Q.q.toRotationMatrix() - O.q.toRotationMatrix();
  const Vec3 t = Q.p - O.p + turn * m.com;
  return t.squaredNorm() + (turn * m.covariance * turn.transpose()).trace();
}

Pose random_pose(std::mt19937_64& random, const Body& a, const Body& b, double spread) {
  const Quat q = random_rotation(random);
  const Vec3 apart = random_in_ball(random, spread * (a.mass.radius + b.mass.radius));
  return {q, b.mass.com + apart - q * a.mass.com};
}

}  // namespace sonde::test
