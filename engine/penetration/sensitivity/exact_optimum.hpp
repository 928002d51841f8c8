// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/sensitivity/directions.hpp"
#include "engine/penetration/sensitivity/facing_features.hpp"
#include "engine/penetration/sensitivity/feature_row.hpp"

namespace sonde {

/// U = ½σ(O, Q) and its first and second derivatives. Motions (displacement of the centre of mass,
/// rotation vector) of O or Q are in the fixed frame F; lengths m.
struct HalfSigma {
  double sigma = 0;
  Vec6 wrench = Vec6::Zero();  ///< (F, τ) at k = 1: ∂U/∂Q, and −∂U/∂O
  /// Derivative of the wrench with respect to Q. Negated, it is the derivative with respect to O,
  /// but without the term for the wrench's turning with O.
  Eigen::Matrix<double, 6, 6> by_motion = Eigen::Matrix<double, 6, 6>::Zero();
};
/// If a turn about a principal axis moves no mass, O takes over Q's turn about that axis.
HalfSigma half_sigma(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) noexcept;

/// Finds the pose nearest to O, in the neighbourhood of a given pose, at which the probe rests on
/// feature rows with zero gap. (The separated pose of a separation keeps a clearance from this
/// pose.) min U subject to the gaps ≥ 0, solved by an active set (least_distance) and Newton steps
/// with the curvature of the active gaps.
class ExactOptimum {
 public:
  static constexpr std::size_t most_rows = FacingFeatures::capacity;

  ExactOptimum(const MassProperties& mass, const Pose& X_FO) noexcept;

  /// Starts at X_FQ. Keeps a reference to the rows.
  void begin(const Pose& X_FQ, std::span<const FeatureRow> rows) noexcept;
  /// Moves to the optimum. Returns false if it is further than `most` (m), or is not found.
  bool move_to_optimum(double most) noexcept;

  const Pose& pose() const noexcept { return X_FQ_; }
  /// The rows that hold the probe there, as contacts without a gap.
  ContactSet contacts() const noexcept;
  double depth() const noexcept { return std::sqrt(at_.sigma); }
  const Vec6& wrench() const noexcept { return at_.wrench; }

  /// Finds the weak rows: those for which rounding or the clearance decides whether they hold the
  /// probe. They are the active rows with a multiplier λ of at most `push` (m) and the inactive
  /// rows with a gap of at most `gap` (m), except those that cannot open. Returns their number.
  /// Call it before the functions below.
  int find_weak(double push, double gap) noexcept;

  /// Derivatives with respect to O's motion.
  struct Change {
    Mat6 wrench;      ///< of (F, τ)
    Mat6 separated;   ///< of Q, as (ξ, ψ)
    Mat6 in_lengths;  ///< the same in coordinates that are all lengths
    int held;         ///< number of independent rows that hold the probe
  };
  /// The derivative if weak rows hold, or if they do not. Returns false if the optimum is not
  /// strict.
  bool derivative(bool weak_hold, Change& out) const noexcept;
  /// The derivative of the first weak row's gap with respect to O's motion, by the derivative if no
  /// weak row holds; 0 if there is no weak row.
  Vec6 weak_gap_rate(const Change& without_weak) const noexcept;

 private:
  void look() noexcept;
  static bool can_open(std::span<HalfSpace> free, std::size_t i) noexcept;
  Directions held_directions(bool weak_hold) const noexcept;
  bool choose() noexcept;
  double step() noexcept;
  bool response(bool weak_hold, Change& out) const noexcept;
  Mat6 curvature() const noexcept;
  const FeatureRowAt& active_row(std::size_t k) const { return row_[of_[k]]; }
  Vec6 in_lengths(const FeatureRowAt& row) const noexcept;

  const MassProperties& mass_;
  Pose X_FO_;
  Quat q_MP_, q_FP_;  // principal axes: in M, and at O in F
  Vec3 com_F_;        // com_F_ at O
  Pose X_FQ_;
  std::span<const FeatureRow> rows_;
  double turn_;  ///< m: factor of rotations that makes all coordinates lengths
  HalfSigma at_;
  std::array<FeatureRowAt, most_rows> row_;
  std::size_t active_ = 0;
  std::array<std::size_t, 6> of_;  ///< active rows
  std::array<double, 6> lambda_;   ///< their multipliers, m
  std::size_t strong_count_ = 0, weak_count_ = 0;
  std::array<std::size_t, most_rows> strong_, weak_;
  Mat6 curvature_;  ///< at the optimum
};

}  // namespace sonde
