// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/local_optimum.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/contact/least_distance.hpp"

namespace sonde {
namespace {

using Mat6 = LocalOptimum::Mat6;

/// Of a row, where all coordinates are lengths: what the held rows leave of it is rounding.
constexpr double dependent = 1e-6;
/// Of a curvature of one: no optimum is flatter.
constexpr double flattest = 1e-9;
/// Rounds of an active set and Newton steps for it. Two are enough where the first set is right.
constexpr int most_rounds = 4;
/// Of the depth: rows are satisfied to this.
constexpr double solved_to = 1e-10;
/// Of the depth: after a longer Newton step there is another one.
constexpr double short_step = 1e-3;

/// The pose after a small motion about the centre of mass.
Pose moved(const MassProperties& mass, const Pose& X, const Vec6& motion) {
  const Vec3 com = X * mass.com + motion.head<3>();
  const Quat q = (rotation_by(motion.tail<3>()) * X.q).normalized();
  return {q, com - q * mass.com};
}

/// 2(wÎv + v × Îv), and its change with a turn θ of the rotation (w, v) from the left.
struct TurningMoment {
  Vec3 value;
  Mat3 change;
};
TurningMoment turning_moment(const Vec3& inertia, double w, const Vec3& v) {
  const Vec3 Iv = inertia.cwiseProduct(v);
  const Mat3 dv = 0.5 * (w * Mat3::Identity() - cross_matrix(v)), Idv = inertia.asDiagonal() * dv;
  return {2 * (w * Iv + v.cross(Iv)),
          -Iv * v.transpose() + 2 * (w * Idv - cross_matrix(Iv) * dv + cross_matrix(v) * Idv)};
}

HalfSigma half_sigma_of(const Chart& chart, const Pose& X_FQ) {
  const MassProperties& mass = chart.mass();
  Quat turn = chart.principal().conjugate() * (X_FQ.q * Quat(mass.R_MP));
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const Vec3 t = X_FQ * mass.com - chart.com(), v = turn.vec();
  const TurningMoment m = turning_moment(mass.inertia, turn.w(), v);
  const Mat3 R = chart.principal().toRotationMatrix();
  HalfSigma out;
  out.sigma = t.squaredNorm() + 4 * v.dot(mass.inertia.cwiseProduct(v));
  out.wrench << t, R * m.value;
  out.by_motion.topLeftCorner<3, 3>().setIdentity();
  out.by_motion.bottomRightCorner<3, 3>() = R * m.change * R.transpose();
  return out;
}

Chart chart_at(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) {
  Chart out(mass, X_FO);
  out.absorb_free_spin(X_FQ);
  return out;
}

}  // namespace

HalfSigma half_sigma(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) noexcept {
  return half_sigma_of(chart_at(mass, X_FO, X_FQ), X_FQ);
}

bool LocalOptimum::Held::add(const Vec6& row) noexcept {
  if (size == 6) return false;
  auto& along = r[static_cast<std::size_t>(size)];
  along = {};
  Vec6 rest = row;
  for (int pass = 0; pass < 2; ++pass)
    for (std::size_t j = 0; j < static_cast<std::size_t>(size); ++j) {
      const double part = q[j].dot(rest);
      along[j] += part;
      rest -= part * q[j];
    }
  const double length = rest.norm();
  if (!(length > dependent * row.norm())) return false;
  along[static_cast<std::size_t>(size)] = length;
  q[static_cast<std::size_t>(size++)] = rest / length;
  return true;
}

Vec6 LocalOptimum::Held::free_part(Vec6 x) const noexcept {
  for (std::size_t j = 0; j < static_cast<std::size_t>(size); ++j) x -= q[j].dot(x) * q[j];
  return x;
}

LocalOptimum::LocalOptimum(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
                           std::span<const FeatureRow> rows) noexcept
    : mass_(mass),
      chart_(chart_at(mass, X_FO, X_FQ)),
      start_(X_FQ),
      X_FQ_(X_FQ),
      rows_(rows.first(std::min(rows.size(), most_rows))),
      turn_(std::sqrt(mass.inertia.maxCoeff())) {
  if (!(turn_ > 0)) turn_ = mass.radius > 0 ? mass.radius : 1;
  look();
}

void LocalOptimum::look() noexcept {
  at_ = half_sigma_of(chart_, X_FQ_);
  const Transform X(X_FQ_);
  for (std::size_t i = 0; i < rows_.size(); ++i) row_[i] = row_at(rows_[i], X, mass_.com);
}

Vec6 LocalOptimum::scaled(const FeatureRowAt& row) const noexcept {
  Vec6 out;
  out << row.normal, row.arm.cross(row.normal) / turn_;
  return out;
}

/// The rows that hold the probe, as they are linearised here.
bool LocalOptimum::choose() noexcept {
  const Vec6 y = chart_.coordinates(X_FQ_);
  const Vec3 com = X_FQ_ * mass_.com;
  std::array<HalfSpace, most_rows> rows;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows[i].normal = chart_.row(y, com + row_[i].arm, row_[i].normal);
    rows[i].bound = rows[i].normal.dot(y) - row_[i].gap;
  }
  const LeastDistance nearest =
      least_distance({rows.data(), rows_.size()}, solved_to * y.norm());
  active_ = 0;
  if (!nearest.feasible) return false;
  Held held;
  for (std::size_t k = 0; k < static_cast<std::size_t>(nearest.active_count); ++k) {
    const int i = nearest.active[k];
    if (!held.add(scaled(row_[static_cast<std::size_t>(i)]))) continue;
    of_[static_cast<std::size_t>(active_)] = i;
    lambda_[static_cast<std::size_t>(active_++)] = nearest.multiplier[k];
  }
  return true;
}

/// ∂²(U − Σλg)/∂Q², where all coordinates are lengths.
Mat6 LocalOptimum::curvature() const noexcept {
  Mat6 out = at_.by_motion;
  for (std::size_t k = 0; k < static_cast<std::size_t>(active_); ++k) {
    const FeatureRowAt& row = row_[static_cast<std::size_t>(of_[k])];
    out.topRows<3>() -= lambda_[k] * row.d_normal;
    out.bottomRows<3>() -= lambda_[k] * (cross_matrix(row.arm) * row.d_normal -
                                         cross_matrix(row.normal) * row.d_arm);
  }
  out.rightCols<3>() /= turn_;
  out.bottomRows<3>() /= turn_;
  // Symmetric where the wrench is that of the rows: what is not is how far it is from that.
  return 0.5 * (out + out.transpose());
}

/// A Newton step to where the active rows have no gap and hold the wrench. Returns its length, m;
/// infinite where there is none.
double LocalOptimum::step() noexcept {
  Held held;
  std::array<double, 6> along{};  // the step, along the directions of the rows
  const auto size = static_cast<std::size_t>(active_);
  Vec6 to = Vec6::Zero();
  for (std::size_t k = 0; k < size; ++k) {
    const FeatureRowAt& row = row_[static_cast<std::size_t>(of_[k])];
    if (!held.add(scaled(row))) return infinity;
    double rest = -row.gap;
    for (std::size_t j = 0; j < k; ++j) rest -= held.r[k][j] * along[j];
    along[k] = rest / held.r[k][k];
    to += along[k] * held.q[k];
  }
  const Mat6 M = curvature();
  Vec6 wrench = at_.wrench;
  wrench.tail<3>() /= turn_;
  Mat6 P = Mat6::Identity(), H = Mat6::Zero();
  for (std::size_t k = 0; k < size; ++k) P -= held.q[k] * held.q[k].transpose();
  H = P * M * P + (Mat6::Identity() - P);
  const Eigen::LLT<Mat6> factor(H);
  if (factor.info() != Eigen::Success) return infinity;
  to -= P * factor.solve(P * (wrench + M * to));
  const Vec6 pull = wrench + M * to;
  for (std::size_t k = size; k-- > 0;) {
    double rest = held.q[k].dot(pull);
    for (std::size_t j = k + 1; j < size; ++j) rest -= held.r[j][k] * lambda_[j];
    lambda_[k] = rest / held.r[k][k];
  }
  const double length = to.norm();
  to.tail<3>() /= turn_;
  X_FQ_ = moved(mass_, X_FQ_, to);
  look();
  return length;
}

bool LocalOptimum::settle(double most) noexcept {
  for (int round = 0; round < most_rounds; ++round) {
    if (!choose()) return false;
    const double first = step();
    if (!(first <= short_step * depth()) && !(step() <= most)) return false;
    const Vec6 way = chart_.coordinates(X_FQ_) - chart_.coordinates(start_);
    if (!(way.norm() <= most)) return false;
    const double enough = 1e-6 * depth();
    bool holds = true;
    for (std::size_t k = 0; k < static_cast<std::size_t>(active_); ++k)
      holds = holds && lambda_[k] > -enough;
    for (std::size_t i = 0; i < rows_.size(); ++i) holds = holds && row_[i].gap > -enough;
    if (holds) return true;
  }
  return false;
}

int LocalOptimum::find_weak(double push, double gap) noexcept {
  weak_count_ = 0;
  Held held;
  const auto size = static_cast<std::size_t>(active_);
  for (std::size_t k = 0; k < size; ++k) {
    held.add(scaled(row_[static_cast<std::size_t>(of_[k])]));
    weak_active_[k] = lambda_[k] <= push;
    if (weak_active_[k]) weak_[static_cast<std::size_t>(weak_count_++)] = of_[k];
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (row_[i].gap > gap) continue;
    const auto end = of_.begin() + active_;
    if (std::find(of_.begin(), end, static_cast<int>(i)) != end) continue;
    const Vec6 row = scaled(row_[i]);
    if (held.free_part(row).norm() > 1e-4 * row.norm())
      weak_[static_cast<std::size_t>(weak_count_++)] = static_cast<int>(i);
  }
  return weak_count_;
}

/// The change of Q with O, where all coordinates are lengths.
bool LocalOptimum::response(bool weak_hold, Mat6& out) const noexcept {
  Held held;
  for (std::size_t k = 0; k < static_cast<std::size_t>(active_); ++k)
    if (!weak_active_[k]) held.add(scaled(row_[static_cast<std::size_t>(of_[k])]));
  for (std::size_t k = 0; weak_hold && k < static_cast<std::size_t>(weak_count_); ++k)
    held.add(scaled(row_[static_cast<std::size_t>(weak_[k])]));
  Mat6 P = Mat6::Identity();
  for (std::size_t k = 0; k < static_cast<std::size_t>(held.size); ++k)
    P -= held.q[k] * held.q[k].transpose();
  const Mat6 H = P * curvature() * P + (Mat6::Identity() - P);
  const Eigen::LLT<Mat6> factor(H);
  if (factor.info() != Eigen::Success) return false;
  if (!(factor.matrixLLT().diagonal().cwiseAbs2().minCoeff() > flattest)) return false;
  Mat6 A = at_.by_motion;
  A.bottomRightCorner<3, 3>() += cross_matrix(at_.wrench.tail<3>());
  A.bottomRightCorner<3, 3>() /= turn_ * turn_;
  out = P * factor.solve(P * A);
  return true;
}

bool LocalOptimum::derivative(bool weak_hold, Mat6& out) const noexcept {
  Mat6 way;
  if (!response(weak_hold, way)) return false;
  way.topRightCorner<3, 3>() *= turn_;
  way.bottomLeftCorner<3, 3>() /= turn_;
  // As O turns, the wrench turns with it.
  out = at_.by_motion * (way - Mat6::Identity());
  out.bottomRightCorner<3, 3>() -= cross_matrix(at_.wrench.tail<3>());
  return true;
}

Vec6 LocalOptimum::weak_gap_rate() const noexcept {
  Mat6 way;
  if (weak_count_ == 0 || !response(false, way)) return Vec6::Zero();
  Vec6 out = way.transpose() * scaled(row_[static_cast<std::size_t>(weak_[0])]);
  out.tail<3>() *= turn_;
  return out;
}

}  // namespace sonde
