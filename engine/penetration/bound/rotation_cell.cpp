// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/rotation_cell.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {
namespace {

/// Index of the quaternion component that a cell's i-th number stands for.
int component_of(int face, int i) { return i < face ? i : i + 1; }

}  // namespace

Eigen::Vector4d RotationCell::middle() const {
  Eigen::Vector4d q;
  q[face] = 1;
  for (int i = 0; i < 3; ++i) q[component_of(face, i)] = at[static_cast<std::size_t>(i)];
  return q;
}

double RotationCell::least_cost(const Vec3& inertia) const {
  // A ratio of two sums over the squares s of the components, Σ J s / Σ s. It is least at a corner
  // of the box of s: each s is largest where J is below the ratio, and least elsewhere.
  const double J[4] = {0, inertia[0], inertia[1], inertia[2]};
  double low[4], high[4];
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double near = std::max(0.0, std::abs(at[k]) - half[k]), far = std::abs(at[k]) + half[k];
    low[component_of(face, i)] = near * near, high[component_of(face, i)] = far * far;
  }
  low[face] = high[face] = 1;
  double least = std::numeric_limits<double>::infinity();
  for (int largest = 0; largest <= 4; ++largest) {  // J is ascending
    double above = 0, below = 0;
    for (int k = 0; k < 4; ++k) {
      const double s = k < largest ? high[k] : low[k];
      above += J[k] * s, below += s;
    }
    least = std::min(least, above / below);
  }
  return 4 * least;
}

RotationCell::Least RotationCell::least_quotient(const Eigen::Matrix4d& S,
                                                 const Eigen::Vector4d& guess) const {
  // With l the quotient at the guess and Q = S − l: qᵀSq / qᵀq = l + qᵀQq / qᵀq, where the last
  // term is nearly 0 at the minimum. From the middle m to m + e the form is mᵀQm + 2 (Qm)·e + eᵀQe.
  // With 2 |eᵢ eⱼ| ≤ eᵢ² hⱼ/hᵢ + eⱼ² hᵢ/hⱼ, each component can be minimised by itself.
  const Eigen::Vector4d m = middle();
  const double quotient = guess.dot(S * guess) / guess.squaredNorm();
  const Eigen::Matrix4d Q = S - quotient * Eigen::Matrix4d::Identity();
  const Eigen::Vector4d slope = Q * m;
  Eigen::Vector4d at = m, most = m.cwiseAbs();
  double form = m.dot(slope), shortest = 1, longest = 1;  // lower bound of qᵀQq; bounds of |q|²
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int a = component_of(face, i);
    double bend = Q(a, a);
    for (int j = 0; j < 3; ++j)
      if (j != i)
        bend -= std::abs(Q(a, component_of(face, j))) * half[static_cast<std::size_t>(j)] / half[k];
    const double side = slope[a] > 0 ? -half[k] : half[k];
    const double e = bend > 0 ? std::clamp(-slope[a] / bend, -half[k], half[k]) : side;
    form += e * (2 * slope[a] + bend * e);
    at[a] += e, most[a] += half[k];
    const double near = std::max(0.0, std::abs(this->at[k]) - half[k]);
    shortest += near * near, longest += most[a] * most[a];
  }
  form -= 1e-14 * most.dot(Q.cwiseAbs() * most);
  return {quotient + form / (form > 0 ? longest : shortest), at};
}

double RotationCell::cost_along(int component, const Vec3& inertia) const {
  const Eigen::Vector4d q = middle();
  const Eigen::Vector4d J(0, inertia[0], inertia[1], inertia[2]);
  const double square = q.squaredNorm(), mean = q.cwiseAbs2().dot(J) / square;
  const int k = component_of(face, component);
  return 8 * std::abs((J[k] - mean) * q[k]) * half[static_cast<std::size_t>(component)] / square;
}

std::array<RotationCell, 2> RotationCell::halves(int component) const {
  const auto k = static_cast<std::size_t>(component);
  RotationCell low = *this, high = *this;
  low.half[k] = high.half[k] = half[k] / 2;
  low.at[k] -= half[k] / 2, high.at[k] += half[k] / 2;
  return {low, high};
}

Eigen::Matrix4d distance_form(const Vec3& r, const Vec3& p) {
  // For quaternion products, |q r − p q| = |R r − p| |q|, and that is linear in q = (w, v):
  // (−v·(r − p), w (r − p) + v×(r + p)).
  const Vec3 d = r - p, s = r + p, across = s.cross(d);
  Eigen::Matrix4d G;
  G(0, 0) = d.squaredNorm();
  G.block<1, 3>(0, 1) = across.transpose();
  G.block<3, 1>(1, 0) = across;
  G.block<3, 3>(1, 1) = d * d.transpose() - s * s.transpose() + s.squaredNorm() * Mat3::Identity();
  return G;
}

CellSpread::CellSpread(const RotationCell& cell) {
  const Eigen::Vector4d m = cell.middle();
  const Quat q(m[0], m[1], m[2], m[3]);
  R_ = q.normalized().toRotationMatrix();
  double least = 1;  // lower bound of |q|² over the cell
  for (std::size_t k = 0; k < 3; ++k) {
    const double near = std::max(0.0, std::abs(cell.at[k]) - cell.half[k]);
    least += near * near;
  }
  // From the middle q to q + e, the relative turn is that of q*(q + e). Its vector part equals that
  // of q*e, which is linear in e. A turn with the vector part u displaces r by 2|u×r|, for any
  // angle.
  const double scale = 2 / std::sqrt(m.squaredNorm() * least);
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector4d e = Eigen::Vector4d::Zero();
    e[component_of(cell.face, i)] = cell.half[static_cast<std::size_t>(i)];
    axis_[i] = scale * (q.conjugate() * Quat(e[0], e[1], e[2], e[3])).vec();
  }
}

double CellSpread::reach(const Vec3& r) const {
  // The longest of ±a ± b ± c.
  const Vec3 a = axis_[0].cross(r), b = axis_[1].cross(r), c = axis_[2].cross(r);
  return std::sqrt(a.squaredNorm() + b.squaredNorm() + c.squaredNorm() +
                   2 * (std::abs(a.dot(b)) + std::abs(b.dot(c)) + std::abs(c.dot(a))));
}

}  // namespace sonde
