// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/geometry/chart.hpp"

namespace sonde {

/// Share of a row's length: if less remains after projecting out the held rows, it is rounding.
constexpr double row_dependent = 1e-6;
/// Least curvature of a strict optimum, in units in which the average curvature is 1.
constexpr double flattest_optimum = 1e-9;

/// An orthonormal basis: the directions of the held rows, and those that they leave free.
class Directions {
 public:
  std::size_t held() const { return held_; }
  std::size_t free() const { return 6 - held_; }
  const Vec6& of_held(std::size_t j) const { return q_[j]; }
  const Vec6& of_free(std::size_t j) const { return q_[held_ + j]; }
  /// Row i = Σ part(i, j) of_held(j).
  double part(std::size_t i, std::size_t j) const { return parts_[i][j]; }

  /// Adds a row. Returns false if it depends on the rows held before.
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
    if (!(length > row_dependent * row.norm())) return false;
    parts[held_] = length;
    q_[held_++] = rest / length;
    return true;
  }
  /// The part of a row in the free directions.
  Vec6 free_part(Vec6 row) const {
    for (std::size_t j = 0; j < held_; ++j) row -= q_[j].dot(row) * q_[j];
    return row;
  }
  /// The coefficients of the held rows whose sum is this row.
  std::array<double, 6> shares(const Vec6& row) const {
    std::array<double, 6> out{};
    for (std::size_t k = held_; k-- > 0;) {
      double rest = q_[k].dot(row);
      for (std::size_t j = k + 1; j < held_; ++j) rest -= parts_[j][k] * out[j];
      out[k] = rest / parts_[k][k];
    }
    return out;
  }
  /// Finds the free directions. No row may be added after it.
  void complete() {
    Vec6 left = Vec6::Ones();  // square of each axis's part outside the directions found
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

/// A quadratic form on the free directions, factorised (Cholesky).
class FreeCurvature {
 public:
  FreeCurvature(const Eigen::Matrix<double, 6, 6>& M, const Directions& directions)
      : directions_(directions) {
    for (std::size_t i = 0; i < directions.free(); ++i) {
      const Vec6 Mz = M * directions.of_free(i);
      for (std::size_t j = i; j < directions.free(); ++j) L_[j][i] = directions.of_free(j).dot(Mz);
    }
    for (std::size_t i = 0; i < directions.free(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = L_[i][j];
        for (std::size_t k = 0; k < j; ++k) sum -= L_[i][k] * L_[j][k];
        if (i == j) {
          strict_ = strict_ && sum > flattest_optimum;
          L_[i][i] = std::sqrt(sum);
        } else {
          L_[i][j] = sum / L_[j][j];
        }
      }
  }
  /// The form is positive definite.
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

}  // namespace sonde
