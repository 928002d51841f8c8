// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/sensitivity/facing_features.hpp"
#include "engine/penetration/sensitivity/feature_row.hpp"

namespace sonde {

/// U = ½σ(O, Q) and its first and second derivatives. Motions (displacement of the centre of mass,
/// rotation vector) of O or Q are in the fixed frame F; lengths m.
struct HalfSigma {
  double sigma = 0;
  Vec6 wrench = Vec6::Zero();  ///< (F, τ) at k = 1: ∂U/∂Q, and −∂U/∂O
  /// The change of the wrench with Q, and (negative) with O, O's turning of F's axes left out.
  Eigen::Matrix<double, 6, 6> by_motion = Eigen::Matrix<double, 6, 6>::Zero();
};
/// Where a turn about a principal axis moves nothing, O is turned about it as Q is.
HalfSigma half_sigma(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) noexcept;

/// The nearest pose to O, near a given one, that feature rows let the probe come to without a gap:
/// a separation lies above it by its clearance. min U subject to the gaps ≥ 0, solved by an active
/// set (least_distance) and Newton steps with the curvature of the active gaps.
class LocalOptimum {
 public:
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  static constexpr std::size_t most_rows = FacingFeatures::capacity;

  LocalOptimum(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
               std::span<const FeatureRow> rows) noexcept;

  /// Goes there. False where it is further than `most` (m), or is not found.
  bool settle(double most) noexcept;

  double depth() const noexcept { return std::sqrt(at_.sigma); }
  const Vec6& wrench() const noexcept { return at_.wrench; }
  int active() const noexcept { return static_cast<int>(active_); }

  /// Rows of which rounding or the clearance decides whether they hold: those that are held by at
  /// most `push` (m, λ), and those that are not held and within `gap` (m). Returns how many. (Not
  /// those that the held rows hold with them.)
  int find_weak(double push, double gap) noexcept;

  /// The change of the wrench with O's motion, where weak rows hold, or where they do not. False
  /// where there is no strict optimum.
  bool derivative(bool weak_hold, Mat6& out) const noexcept;
  /// The change of the first weak row's gap with O's motion, where no weak row holds.
  Vec6 weak_gap_rate() const noexcept;

 private:
  void look() noexcept;
  bool choose() noexcept;
  double step() noexcept;
  bool response(bool weak_hold, Mat6& out) const noexcept;
  Mat6 curvature() const noexcept;
  const FeatureRowAt& active_row(std::size_t k) const { return row_[of_[k]]; }
  bool is_active(std::size_t row) const noexcept;
  Vec6 in_lengths(const FeatureRowAt& row) const noexcept;

  const MassProperties& mass_;
  Quat q_MP_, q_FP_;  // principal axes: in M, and at O in F
  Vec3 com_F_;        // at O
  Pose X_FQ_;
  std::span<const FeatureRow> rows_;
  double turn_;  ///< m: that a rotation is multiplied by, so that all coordinates are lengths
  HalfSigma at_;
  std::array<FeatureRowAt, most_rows> row_;
  std::size_t active_ = 0;
  std::array<std::size_t, 6> of_;  ///< active rows
  std::array<double, 6> lambda_;   ///< their multipliers, m
  std::array<bool, 6> is_weak_;    ///< of the active rows
  std::size_t weak_count_ = 0;
  std::array<std::size_t, most_rows> weak_;
};

}  // namespace sonde
