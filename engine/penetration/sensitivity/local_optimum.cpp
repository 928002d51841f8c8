// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/local_optimum.hpp"

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
/// Of a row: one of which the rows that hold leave no more than that free holds with them.
constexpr double held_with_others = 1e-4;
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

Quat principal_at(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) {
  Chart chart(mass, X_FO);
  chart.absorb_free_spin(X_FQ);
  return chart.principal();
}

HalfSigma half_sigma_of(const MassProperties& mass, const Quat& q_MP, const Quat& q_FP,
                        const Vec3& com_F, const Pose& X_FQ) {
  Quat turn = q_FP.conjugate() * (X_FQ.q * q_MP);
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const Vec3 t = X_FQ * mass.com - com_F, v = turn.vec();
  const TurningMoment m = turning_moment(mass.inertia, turn.w(), v);
  const Mat3 R = q_FP.toRotationMatrix();
  HalfSigma out;
  out.sigma = t.squaredNorm() + 4 * v.dot(mass.inertia.cwiseProduct(v));
  out.wrench << t, R * m.value;
  out.by_motion.topLeftCorner<3, 3>().setIdentity();
  out.by_motion.bottomRightCorner<3, 3>() = R * m.change * R.transpose();
  return out;
}

/// The directions of rows that hold, and those that they leave free, orthonormal.
class Directions {
 public:
  std::size_t held() const { return held_; }
  std::size_t free() const { return 6 - held_; }
  const Vec6& of_held(std::size_t j) const { return q_[j]; }
  const Vec6& of_free(std::size_t j) const { return q_[held_ + j]; }
  /// Row i = Σ part(i, j) of_held(j).
  double part(std::size_t i, std::size_t j) const { return parts_[i][j]; }

  /// False where the rows before hold this one, too.
  bool hold(const Vec6& row) {
    if (held_ == 6) return false;
    auto& parts = parts_[held_];
    parts.fill(0);
    Vec6 rest = row;
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t j = 0; j < held_; ++j) {
        const double part = q_[j].dot(rest);
        parts[j] += part;
        rest -= part * q_[j];
      }
    const double length = rest.norm();
    if (!(length > dependent * row.norm())) return false;
    parts[held_] = length;
    q_[held_++] = rest / length;
    return true;
  }
  /// What of a row is free.
  double free_part(Vec6 row) const {
    for (std::size_t j = 0; j < held_; ++j) row -= q_[j].dot(row) * q_[j];
    return row.norm();
  }
  /// No more rows: finds the free directions.
  void complete() {
    Vec6 left = Vec6::Ones();  // of each coordinate's axis
    for (std::size_t j = 0; j < 6; ++j) {
      if (j >= held_) {
        Eigen::Index axis;
        left.maxCoeff(&axis);
        Vec6 rest = Vec6::Unit(axis);
        for (int pass = 0; pass < 2; ++pass)
          for (std::size_t i = 0; i < j; ++i) rest -= q_[i].dot(rest) * q_[i];
        q_[j] = rest.normalized();
      }
      left -= q_[j].cwiseAbs2();
    }
  }

 private:
  std::array<Vec6, 6> q_;
  std::array<std::array<double, 6>, 6> parts_;
  std::size_t held_ = 0;
};

/// A quadratic form on the free directions, by its Cholesky factor.
class FreeCurvature {
 public:
  FreeCurvature(const Mat6& M, const Directions& directions) : directions_(directions) {
    for (std::size_t i = 0; i < directions.free(); ++i) {
      const Vec6 Mz = M * directions.of_free(i);
      for (std::size_t j = i; j < directions.free(); ++j) L_[j][i] = directions.of_free(j).dot(Mz);
    }
    for (std::size_t i = 0; i < directions.free(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = L_[i][j];
        for (std::size_t k = 0; k < j; ++k) sum -= L_[i][k] * L_[j][k];
        if (i == j) {
          strict_ = strict_ && sum > flattest;
          L_[i][i] = std::sqrt(sum);
        } else {
          L_[i][j] = sum / L_[j][j];
        }
      }
  }
  /// It rises in all of them.
  bool is_strict() const { return strict_; }
  /// Z (Zᵀ M Z)⁻¹ Zᵀ x, with the free directions as the columns of Z.
  Vec6 solve(const Vec6& x) const {
    std::array<double, 6> y;
    const std::size_t size = directions_.free();
    for (std::size_t i = 0; i < size; ++i) {
      y[i] = directions_.of_free(i).dot(x);
      for (std::size_t k = 0; k < i; ++k) y[i] -= L_[i][k] * y[k];
      y[i] /= L_[i][i];
    }
    Vec6 out = Vec6::Zero();
    for (std::size_t i = size; i-- > 0;) {
      for (std::size_t k = i + 1; k < size; ++k) y[i] -= L_[k][i] * y[k];
      y[i] /= L_[i][i];
      out += y[i] * directions_.of_free(i);
    }
    return out;
  }

 private:
  const Directions& directions_;
  std::array<std::array<double, 6>, 6> L_;
  bool strict_ = true;
};

}  // namespace

HalfSigma half_sigma(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) noexcept {
  return half_sigma_of(mass, Quat(mass.R_MP), principal_at(mass, X_FO, X_FQ), X_FO * mass.com,
                       X_FQ);
}

LocalOptimum::LocalOptimum(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
                           std::span<const FeatureRow> rows) noexcept
    : mass_(mass),
      q_MP_(mass.R_MP),
      q_FP_(principal_at(mass, X_FO, X_FQ)),
      com_F_(X_FO * mass.com),
      X_FQ_(X_FQ),
      rows_(rows.first(std::min(rows.size(), most_rows))),
      turn_(std::sqrt(mass.inertia.maxCoeff())) {
  if (!(turn_ > 0)) turn_ = mass.radius > 0 ? mass.radius : 1;
  look();
}

void LocalOptimum::look() noexcept {
  at_ = half_sigma_of(mass_, q_MP_, q_FP_, com_F_, X_FQ_);
  const Transform X(X_FQ_);
  for (std::size_t i = 0; i < rows_.size(); ++i) row_[i] = row_at(rows_[i], X, mass_.com);
}

bool LocalOptimum::is_active(std::size_t row) const noexcept {
  const auto end = of_.begin() + static_cast<std::ptrdiff_t>(active_);
  return std::find(of_.begin(), end, row) != end;
}

Vec6 LocalOptimum::in_lengths(const FeatureRowAt& row) const noexcept {
  Vec6 out;
  out << row.normal, row.arm.cross(row.normal) / turn_;
  return out;
}

/// The rows that hold the probe here. At the optimum its wrench is theirs, in whatever metric the
/// way there is measured.
bool LocalOptimum::choose() noexcept {
  Vec6 wrench = at_.wrench;
  wrench.tail<3>() /= turn_;
  std::array<HalfSpace, most_rows> rows;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows[i].normal = in_lengths(row_[i]);
    rows[i].bound = rows[i].normal.dot(wrench) - row_[i].gap;
  }
  const LeastDistance nearest = least_distance({rows.data(), rows_.size()}, solved_to * depth());
  active_ = 0;
  if (!nearest.feasible) return false;
  Directions directions;
  for (std::size_t k = 0; k < static_cast<std::size_t>(nearest.active_count); ++k) {
    const auto i = static_cast<std::size_t>(nearest.active[k]);
    if (!directions.hold(rows[i].normal)) continue;
    of_[active_] = i;
    lambda_[active_++] = nearest.multiplier[k];
  }
  return true;
}

/// ∂²(U − Σλg)/∂Q², where all coordinates are lengths.
Mat6 LocalOptimum::curvature() const noexcept {
  Mat6 out = at_.by_motion;
  for (std::size_t k = 0; k < active_; ++k) {
    const FeatureRowAt& row = active_row(k);
    out.topRows<3>() -= lambda_[k] * row.d_normal;
    for (Eigen::Index i = 0; i < 6; ++i)
      out.col(i).tail<3>() -= lambda_[k] * (row.arm.cross(row.d_normal.col(i)) -
                                            row.normal.cross(row.d_arm.col(i)));
  }
  out.rightCols<3>() /= turn_;
  out.bottomRows<3>() /= turn_;
  // Symmetric where the wrench is that of the rows: what is not is how far it is from that.
  const Mat6 transposed = out.transpose();
  return 0.5 * (out + transposed);
}

/// A Newton step to where the active rows have no gap and hold the wrench. Returns its length, m;
/// infinite where there is none.
double LocalOptimum::step() noexcept {
  Directions directions;
  std::array<double, 6> along;  // the step, along the directions of the rows
  Vec6 to = Vec6::Zero();
  for (std::size_t k = 0; k < active_; ++k) {
    if (!directions.hold(in_lengths(active_row(k)))) return infinity;
    double rest = -active_row(k).gap;
    for (std::size_t j = 0; j < k; ++j) rest -= directions.part(k, j) * along[j];
    along[k] = rest / directions.part(k, k);
    to += along[k] * directions.of_held(k);
  }
  directions.complete();
  const Mat6 M = curvature();
  const FreeCurvature free(M, directions);
  if (!free.is_strict()) return infinity;
  Vec6 wrench = at_.wrench;
  wrench.tail<3>() /= turn_;
  to -= free.solve(wrench + M * to);
  const Vec6 pull = wrench + M * to;
  for (std::size_t k = active_; k-- > 0;) {
    double rest = directions.of_held(k).dot(pull);
    for (std::size_t j = k + 1; j < active_; ++j) rest -= directions.part(j, k) * lambda_[j];
    lambda_[k] = rest / directions.part(k, k);
  }
  const double length = to.norm();
  to.tail<3>() /= turn_;
  X_FQ_ = moved(mass_, X_FQ_, to);
  look();
  return length;
}

bool LocalOptimum::settle(double most) noexcept {
  double way = 0;
  for (int round = 0; round < most_rounds; ++round) {
    if (!choose()) return false;
    const double first = step();
    way += first;
    if (!(first <= short_step * depth())) way += step();
    if (!(way <= most)) return false;
    const double enough = 1e-6 * depth();
    bool holds = true;
    for (std::size_t k = 0; k < active_; ++k) holds = holds && lambda_[k] > -enough;
    for (std::size_t i = 0; i < rows_.size(); ++i) holds = holds && row_[i].gap > -enough;
    if (holds) return true;
  }
  return false;
}

int LocalOptimum::find_weak(double push, double gap) noexcept {
  weak_count_ = 0;
  Directions directions;
  for (std::size_t k = 0; k < active_; ++k) {
    directions.hold(in_lengths(active_row(k)));
    is_weak_[k] = lambda_[k] <= push;
    if (is_weak_[k]) weak_[weak_count_++] = of_[k];
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (row_[i].gap > gap || is_active(i)) continue;
    const Vec6 row = in_lengths(row_[i]);
    if (directions.free_part(row) > held_with_others * row.norm()) weak_[weak_count_++] = i;
  }
  return static_cast<int>(weak_count_);
}

/// The change of Q with O, where all coordinates are lengths.
bool LocalOptimum::response(bool weak_hold, Mat6& out) const noexcept {
  Directions directions;
  for (std::size_t k = 0; k < active_; ++k)
    if (!is_weak_[k]) directions.hold(in_lengths(active_row(k)));
  for (std::size_t k = 0; weak_hold && k < weak_count_; ++k)
    directions.hold(in_lengths(row_[weak_[k]]));
  directions.complete();
  const FreeCurvature free(curvature(), directions);
  if (!free.is_strict()) return false;
  Mat6 pull = at_.by_motion;
  pull.bottomRightCorner<3, 3>() += cross_matrix(at_.wrench.tail<3>());
  pull.bottomRightCorner<3, 3>() /= turn_ * turn_;
  for (Eigen::Index i = 0; i < 6; ++i) out.col(i) = free.solve(pull.col(i));
  return true;
}

bool LocalOptimum::derivative(bool weak_hold, Mat6& out) const noexcept {
  Mat6 way;
  if (!response(weak_hold, way)) return false;
  way.topRightCorner<3, 3>() *= turn_;
  way.bottomLeftCorner<3, 3>() /= turn_;
  way.diagonal().array() -= 1;
  out.topRows<3>() = way.topRows<3>();
  const Mat3 by_turn = at_.by_motion.bottomRightCorner<3, 3>();
  for (Eigen::Index i = 0; i < 6; ++i) out.col(i).tail<3>() = by_turn * way.col(i).tail<3>();
  // As O turns, the wrench turns with it.
  out.bottomRightCorner<3, 3>() -= cross_matrix(at_.wrench.tail<3>());
  return true;
}

Vec6 LocalOptimum::weak_gap_rate() const noexcept {
  Mat6 way;
  if (weak_count_ == 0 || !response(false, way)) return Vec6::Zero();
  Vec6 out = way.transpose() * in_lengths(row_[weak_[0]]);
  out.tail<3>() *= turn_;
  return out;
}

}  // namespace sonde
