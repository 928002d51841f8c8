// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/least_distance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/penetration/contact/contact_tuning.hpp"

namespace sonde {
namespace {

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using Normals = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;

/// A normal in terms of the active ones: n = Σ of[i] Nᵢ + rest, where rest is orthogonal to all of
/// them.
struct Parts {
  std::array<double, 6> of;
  std::array<double, 6> along;  // the columns of Q
  Vec6 rest;
};

/// The active rows. Their normals are kept as N = QR, with orthonormal columns in Q and R upper
/// triangular: adding or dropping a row costs at most two hundred multiplications.
class ActiveSet {
 public:
  int size() const { return static_cast<int>(size_); }
  int row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  double& multiplier(int i) { return multipliers_[static_cast<std::size_t>(i)]; }

  void add(int row, const Vec6& normal, double multiplier) {
    add(row, normal, parts(normal), multiplier);
  }
  void add(int row, const Vec6& normal, const Parts& parts, double multiplier) {
    const double length = parts.rest.norm();
    for (std::size_t j = 0; j < size_; ++j) R_[size_][j] = parts.along[j];
    R_[size_][size_] = length;
    Q_[size_] = parts.rest / length;
    normals_[size_] = normal;
    rows_[size_] = row;
    multipliers_[size_++] = multiplier;
  }
  void drop(int i) {
    --size_;
    for (auto j = static_cast<std::size_t>(i); j < size_; ++j) {
      rows_[j] = rows_[j + 1];
      multipliers_[j] = multipliers_[j + 1];
      normals_[j] = normals_[j + 1];
      R_[j] = R_[j + 1];
      turn(j);
    }
  }
  /// In the least-squares sense. The projection is removed twice, so that the rest is orthogonal to
  /// rounding.
  Parts parts(const Vec6& n) const {
    Parts out{{}, {}, n};
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t j = 0; j < size_; ++j) {
        const double along = Q_[j].dot(out.rest);
        out.along[j] += along;
        out.rest -= along * Q_[j];
      }
    for (std::size_t i = size_; i-- > 0;) {
      double sum = out.along[i];
      for (std::size_t j = i + 1; j < size_; ++j) sum -= R_[j][i] * out.of[j];
      out.of[i] = sum / R_[i][i];
    }
    return out;
  }
  Vec6 point() const {
    Vec6 y = Vec6::Zero();
    for (std::size_t i = 0; i < size_; ++i) y += multipliers_[i] * normals_[i];
    return y;
  }

 private:
  /// Rotates columns j and j + 1 of Q in their plane, so that column j of R ends on its diagonal
  /// (Givens).
  void turn(std::size_t j) {
    const double length = std::sqrt(R_[j][j] * R_[j][j] + R_[j][j + 1] * R_[j][j + 1]);
    const double c = R_[j][j] / length, s = R_[j][j + 1] / length;
    const Vec6 first = c * Q_[j] + s * Q_[j + 1];
    Q_[j + 1] = c * Q_[j + 1] - s * Q_[j];
    Q_[j] = first;
    for (std::size_t k = j; k < size_; ++k) {
      std::array<double, 6>& column = k == j ? R_[j] : R_[k + 1];
      const double upper = c * column[j] + s * column[j + 1];
      column[j + 1] = c * column[j + 1] - s * column[j];
      column[j] = upper;
    }
    R_[j][j] = length;
  }

  std::array<Vec6, 6> normals_, Q_;
  std::array<std::array<double, 6>, 6> R_{};  // by columns
  std::array<int, 6> rows_{};
  std::array<double, 6> multipliers_{};
  std::size_t size_ = 0;
};

/// Makes these rows active if they are independent and the nearest point on their common flat has
/// only positive multipliers: such a set and its optimum are a valid state of the dual method.
/// Otherwise makes none of them active.
void begin_with(ActiveSet& active, std::span<const int> start, std::span<const HalfSpace> rows) {
  const auto size = static_cast<Eigen::Index>(start.size());
  if (size == 0 || size > 6) return;
  Normals N(6, size);
  Coefficients bound(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const HalfSpace& row = rows[static_cast<std::size_t>(start[static_cast<std::size_t>(i)])];
    N.col(i) = row.normal;
    bound[i] = row.bound;
  }
  using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
  const Gram G = N.transpose() * N;
  const Eigen::LLT<Gram> factor(G);
  if (factor.info() != Eigen::Success) return;
  const auto pivots = factor.matrixLLT().diagonal();
  if (!(pivots.minCoeff() > contact_tuning.start_dependent * pivots.maxCoeff())) return;
  Coefficients multipliers = factor.solve(bound);
  const Coefficients rest = bound - N.transpose() * (N * multipliers);
  multipliers += factor.solve(rest);
  if (!(multipliers.minCoeff() > 0)) return;
  for (Eigen::Index i = 0; i < size; ++i)
    active.add(start[static_cast<std::size_t>(i)], N.col(i), multipliers[i]);
}

/// Adds row p to the active set, and drops rows whose multipliers would become negative. Returns
/// false if the problem is infeasible.
bool bring_in(ActiveSet& active, int p, const HalfSpace& row, Vec6& y) {
  double multiplier = 0;
  const double normal2 = row.normal.squaredNorm();
  for (int guard = 0; guard < contact_tuning.most_leaving; ++guard) {
    const Parts parts = active.parts(row.normal);
    const Vec6& z = parts.rest;
    const double z2 = z.squaredNorm();
    const bool dependent = active.size() == 6 || z2 <= contact_tuning.dependent * normal2;
    const double full = dependent ? infinity : (row.bound - row.normal.dot(y)) / z2;
    double partial = infinity;
    int leaving = -1;
    for (int i = 0; i < active.size(); ++i)
      if (const double r = parts.of[static_cast<std::size_t>(i)];
          r > contact_tuning.least_influence && active.multiplier(i) / r < partial)
        partial = active.multiplier(i) / r, leaving = i;
    const double step = std::min(full, partial);
    if (step == infinity) return false;
    for (int i = 0; i < active.size(); ++i)
      active.multiplier(i) -= step * parts.of[static_cast<std::size_t>(i)];
    multiplier += step;
    if (!dependent) y += step * z;
    if (full <= partial) {
      active.add(p, row.normal, parts, multiplier);
      return true;
    }
    active.drop(leaving);
  }
  return false;
}

}  // namespace

LeastDistance least_distance(std::span<const HalfSpace> rows, double tolerance,
                             std::span<const int> start) {
  LeastDistance out;
  ActiveSet active;
  begin_with(active, start, rows);
  Vec6 y = active.point();
  for (int round = 0; round < contact_tuning.most_rounds; ++round) {
    int worst = -1;
    double violation = tolerance;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double v = rows[i].bound - rows[i].normal.dot(y);
      if (v > violation) violation = v, worst = static_cast<int>(i);
    }
    if (worst < 0) break;
    bool already = false;  // an active row is violated again: rounding, no more to gain
    for (int i = 0; i < active.size(); ++i) already = already || active.row(i) == worst;
    if (already) break;
    if (!bring_in(active, worst, rows[static_cast<std::size_t>(worst)], y)) {
      out.feasible = false;
      break;
    }
    y = active.point();
  }
  out.y = y;
  for (int i = 0; i < active.size(); ++i) {
    const auto at = static_cast<std::size_t>(out.active_count++);
    out.active[at] = active.row(i);
    out.multiplier[at] = active.multiplier(i);
  }
  return out;
}

}  // namespace sonde
