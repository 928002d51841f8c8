// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/exact_optimum.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/contact/least_distance.hpp"

namespace sonde {
namespace {

/// Share of a row's length: if no more remains after projecting out the held rows, these hold the
/// row too.
constexpr double held_with_others = 1e-4;
/// Share of find_weak's `gap`: a row with a larger gap does not touch.
constexpr double touching = 1e-2;
/// m: a motion that opens a row by 1 m and closes no other is no longer; a longer one is rounding.
constexpr double longest_motion = 1e4;
/// Rounds, each an active set and Newton steps for it. Two are enough if the first set is right.
constexpr int most_rounds = 4;
/// Share of the depth: tolerance of the rows.
constexpr double solved_to = 1e-10;
/// Share of the depth: after a longer Newton step a second one follows.
constexpr double short_step = 1e-3;

/// The pose after a small motion about the centre of mass.
Pose pose_after(const MassProperties& mass, const Pose& X, const Vec6& motion) {
  const Vec3 com = X * mass.com + motion.head<3>();
  const Quat q = (rotation_by(motion.tail<3>()) * X.q).normalized();
  return {q, com - q * mass.com};
}

/// 2(wÎv + v × Îv), and its derivative for a turn θ of the rotation (w, v) from the left.
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

}  // namespace

HalfSigma half_sigma(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) noexcept {
  return half_sigma_of(mass, Quat(mass.R_MP), principal_at(mass, X_FO, X_FQ), X_FO * mass.com,
                       X_FQ);
}

ExactOptimum::ExactOptimum(const MassProperties& mass, const Pose& X_FO) noexcept
    : mass_(mass),
      X_FO_(X_FO),
      q_MP_(mass.R_MP),
      com_F_(X_FO * mass.com),
      turn_(std::sqrt(mass.inertia.maxCoeff())) {
  if (!(turn_ > 0)) turn_ = mass.radius > 0 ? mass.radius : 1;
}

void ExactOptimum::begin(const Pose& X_FQ, std::span<const FeatureRow> rows) noexcept {
  q_FP_ = principal_at(mass_, X_FO_, X_FQ);
  X_FQ_ = X_FQ;
  rows_ = rows.first(std::min(rows.size(), most_rows));
  active_ = strong_count_ = weak_count_ = 0;
  look();
}

void ExactOptimum::look() noexcept {
  at_ = half_sigma_of(mass_, q_MP_, q_FP_, com_F_, X_FQ_);
  const Transform X(X_FQ_);
  for (std::size_t i = 0; i < rows_.size(); ++i) row_[i] = row_at(rows_[i], X, mass_.com);
}

Vec6 ExactOptimum::in_lengths(const FeatureRowAt& row) const noexcept {
  Vec6 out;
  out << row.normal, row.arm.cross(row.normal) / turn_;
  return out;
}

/// Finds the rows that hold the probe here. At the optimum, the wrench is a combination of theirs,
/// independent of the metric in which the distance to it is measured.
bool ExactOptimum::choose() noexcept {
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

/// ∂²(U − Σλg)/∂Q², in coordinates that are all lengths.
Mat6 ExactOptimum::curvature() const noexcept {
  Mat6 out = at_.by_motion;
  const Transform X(X_FQ_);
  for (std::size_t k = 0; k < active_; ++k) {
    const FeatureRowAt& row = active_row(k);
    const FeatureRowChange change = row_change(rows_[of_[k]], row, X);
    out.topRows<3>() -= lambda_[k] * change.normal;
    for (Eigen::Index i = 0; i < 6; ++i)
      out.col(i).tail<3>() -=
          lambda_[k] * (row.arm.cross(change.normal.col(i)) - row.normal.cross(change.arm.col(i)));
  }
  out.rightCols<3>() /= turn_;
  out.bottomRows<3>() /= turn_;
  // The exact matrix is symmetric if the wrench is a combination of the rows; the asymmetry is the
  // error of that.
  const Mat6 transposed = out.transpose();
  return 0.5 * (out + transposed);
}

/// A Newton step to the pose at which the active rows have no gap and hold the wrench. Returns its
/// length, m; infinite if there is no such step.
double ExactOptimum::step() noexcept {
  Directions directions;
  std::array<double, 6> along;  // components of the step along the directions of the rows
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
  lambda_ = directions.shares(pull);
  const double length = to.norm();
  to.tail<3>() /= turn_;
  X_FQ_ = pose_after(mass_, X_FQ_, to);
  look();
  return length;
}

bool ExactOptimum::move_to_optimum(double most) noexcept {
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

ContactSet ExactOptimum::contacts() const noexcept {
  ContactSet out;
  const Vec3 com = X_FQ_ * mass_.com;
  for (std::size_t k = 0; k < active_; ++k) {
    const FeatureRowAt& row = active_row(k);
    out.push({com + row.arm, com + row.arm, row.normal, 0, lambda_[k]});
  }
  return out;
}

/// Two opposite corners of four of a face may bear all of the load. The other two bear some as soon
/// as the face moves, so they cannot open. A row can open if some motion opens it and closes no
/// other (Farkas). `free` holds the rows in question, without the components held by rows that bear
/// a load.
bool ExactOptimum::can_open(std::span<HalfSpace> free, std::size_t i) noexcept {
  const double length = free[i].normal.norm();
  free[i].bound = length;
  const LeastDistance motion = least_distance(free, solved_to * length);
  free[i].bound = 0;
  return motion.feasible && motion.y.norm() < longest_motion;
}

int ExactOptimum::find_weak(double push, double gap) noexcept {
  weak_count_ = strong_count_ = 0;
  curvature_ = curvature();
  std::array<std::size_t, most_rows> candidates;
  std::size_t count = 0;
  Directions directions;
  for (std::size_t k = 0; k < active_; ++k) {
    if (!(lambda_[k] > push)) continue;
    directions.hold(in_lengths(active_row(k)));
    strong_[strong_count_++] = of_[k];
  }
  std::array<HalfSpace, most_rows> free;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto end = strong_.begin() + static_cast<std::ptrdiff_t>(strong_count_);
    if (row_[i].gap > gap || std::find(strong_.begin(), end, i) != end) continue;
    const Vec6 row = in_lengths(row_[i]), left = directions.free_part(row);
    if (!(left.norm() > held_with_others * row.norm())) continue;
    if (row_[i].gap > touching * gap) {
      weak_[weak_count_++] = i;
      continue;
    }
    free[count] = {left, 0};
    candidates[count++] = i;
  }
  for (std::size_t c = 0; c < count; ++c)
    if (can_open({free.data(), count}, c))
      weak_[weak_count_++] = candidates[c];
    else
      strong_[strong_count_++] = candidates[c];
  return static_cast<int>(weak_count_);
}

Directions ExactOptimum::held_directions(bool weak_hold) const noexcept {
  Directions out;
  for (std::size_t k = 0; k < strong_count_; ++k) out.hold(in_lengths(row_[strong_[k]]));
  for (std::size_t k = 0; weak_hold && k < weak_count_; ++k) out.hold(in_lengths(row_[weak_[k]]));
  return out;
}

/// The derivative of Q with respect to O, in coordinates that are all lengths.
bool ExactOptimum::response(bool weak_hold, Change& out) const noexcept {
  Directions directions = held_directions(weak_hold);
  directions.complete();
  out.held = static_cast<int>(directions.held());
  const FreeCurvature free(curvature_, directions);
  if (!free.is_strict()) return false;
  Mat6 pull = at_.by_motion;
  pull.bottomRightCorner<3, 3>() += cross_matrix(at_.wrench.tail<3>());
  pull.bottomRightCorner<3, 3>() /= turn_ * turn_;
  for (Eigen::Index i = 0; i < 6; ++i) out.in_lengths.col(i) = free.solve(pull.col(i));
  return true;
}

bool ExactOptimum::derivative(bool weak_hold, Change& out) const noexcept {
  if (!response(weak_hold, out)) return false;
  out.separated = out.in_lengths;
  out.separated.topRightCorner<3, 3>() *= turn_;
  out.separated.bottomLeftCorner<3, 3>() /= turn_;
  Mat6 relative = out.separated;
  relative.diagonal().array() -= 1;
  out.wrench.topRows<3>() = relative.topRows<3>();
  const Mat3 by_turn = at_.by_motion.bottomRightCorner<3, 3>();
  for (Eigen::Index i = 0; i < 6; ++i)
    out.wrench.col(i).tail<3>() = by_turn * relative.col(i).tail<3>();
  // The wrench turns with O.
  out.wrench.bottomRightCorner<3, 3>() -= cross_matrix(at_.wrench.tail<3>());
  return true;
}

Vec6 ExactOptimum::weak_gap_rate(const Change& without_weak) const noexcept {
  if (weak_count_ == 0) return Vec6::Zero();
  Vec6 out = without_weak.in_lengths.transpose() * in_lengths(row_[weak_[0]]);
  out.tail<3>() *= turn_;
  return out;
}

}  // namespace sonde
