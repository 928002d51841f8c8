// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/least_distance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "engine/penetration/contact/contact_tuning.hpp"

namespace sonde {
namespace {

constexpr const ContactTuning& tuned = contact_tuning;
constexpr double infinity = std::numeric_limits<double>::infinity();
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using Normals = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;

/// The active rows and what they make of a further normal.
class ActiveSet {
 public:
  int size() const { return size_; }
  int row(int i) const { return rows_[static_cast<std::size_t>(i)]; }
  double& multiplier(int i) { return multipliers_[static_cast<std::size_t>(i)]; }

  void add(int row, const Vec6& normal, double multiplier) {
    normals_.col(size_) = normal;
    rows_[static_cast<std::size_t>(size_)] = row;
    multipliers_[static_cast<std::size_t>(size_++)] = multiplier;
  }
  void drop(int i) {
    const auto from = static_cast<std::size_t>(i);
    for (std::size_t j = from; j + 1 < static_cast<std::size_t>(size_); ++j) {
      rows_[j] = rows_[j + 1];
      multipliers_[j] = multipliers_[j + 1];
    }
    for (int j = i; j + 1 < size_; ++j) normals_.col(j) = normals_.col(j + 1).eval();
    --size_;
  }
  /// n in terms of the active normals, in the least-squares sense.
  Coefficients project(const Vec6& n) const {
    const Normals N = normals_.leftCols(size_);
    return N.colPivHouseholderQr().solve(n);
  }
  Vec6 combine(const Coefficients& c) const { return normals_.leftCols(size_) * c; }
  Vec6 point() const {
    Vec6 y = Vec6::Zero();
    for (int i = 0; i < size_; ++i)
      y += multipliers_[static_cast<std::size_t>(i)] * normals_.col(i);
    return y;
  }

 private:
  Eigen::Matrix<double, 6, 6> normals_ = Eigen::Matrix<double, 6, 6>::Zero();
  std::array<int, 6> rows_{};
  std::array<double, 6> multipliers_{};
  int size_ = 0;
};

/// Holds the point nearest to the origin on the flat of these rows, if that is what pushes it there
/// alone: the pair of a set and its optimum that the dual method goes on from. Else none of them.
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
  if (!(pivots.minCoeff() > tuned.start_dependent * pivots.maxCoeff())) return;
  Coefficients multipliers = factor.solve(bound);
  const Coefficients rest = bound - N.transpose() * (N * multipliers);
  multipliers += factor.solve(rest);
  if (!(multipliers.minCoeff() > 0)) return;
  for (Eigen::Index i = 0; i < size; ++i)
    active.add(start[static_cast<std::size_t>(i)], N.col(i), multipliers[i]);
}

/// Brings in row p, dropping rows whose multipliers would turn negative. False: infeasible.
bool bring_in(ActiveSet& active, int p, const HalfSpace& row, Vec6& y) {
  double multiplier = 0;
  const double normal2 = row.normal.squaredNorm();
  for (int guard = 0; guard < tuned.most_leaving; ++guard) {
    Vec6 z = row.normal;
    Coefficients r(active.size());
    if (active.size() > 0) {
      r = active.project(row.normal);
      z -= active.combine(r);
    }
    const double z2 = z.squaredNorm();
    const bool dependent = active.size() == 6 || z2 <= tuned.dependent * normal2;
    const double full = dependent ? infinity : (row.bound - row.normal.dot(y)) / z2;
    double partial = infinity;
    int leaving = -1;
    for (int i = 0; i < active.size(); ++i)
      if (r[i] > tuned.least_influence && active.multiplier(i) / r[i] < partial)
        partial = active.multiplier(i) / r[i], leaving = i;
    const double step = std::min(full, partial);
    if (step == infinity) return false;
    for (int i = 0; i < active.size(); ++i) active.multiplier(i) -= step * r[i];
    multiplier += step;
    if (!dependent) y += step * z;
    if (full <= partial) {
      active.add(p, row.normal, multiplier);
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
  for (int round = 0; round < tuned.most_rounds; ++round) {
    int worst = -1;
    double violation = tolerance;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double v = rows[i].bound - rows[i].normal.dot(y);
      if (v > violation) violation = v, worst = static_cast<int>(i);
    }
    if (worst < 0) break;
    bool already = false;  // an active row violated again: rounding, nothing more to gain
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
