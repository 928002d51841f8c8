// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/sampled_stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

/// With more, the matrix would be large and the answer nearly zero.
constexpr double most_samples_late = 1000;

/// The loop in units of the sample time, the inertia and any length: position, velocity T ẋ, force
/// T²/m F.
struct ScaledLoop {
  double damping;          ///< b T/m
  double virtual_damping;  ///< B T/m
  Eigen::Index samples_late;
  double rest;  ///< of the delay, of a sample: 0 to 1
};

ScaledLoop scaled_loop_of(const SampledAxis& axis) {
  const auto expect = [](bool right, const char* complaint) {
    if (!right) throw std::invalid_argument(std::string("sampled axis: ") + complaint);
  };
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  const auto at_least_zero = [](double x) { return std::isfinite(x) && x >= 0; };
  expect(positive(axis.inertia), "its inertia must be above zero");
  expect(positive(axis.sample_time), "the sample time must be above zero");
  expect(at_least_zero(axis.damping) && at_least_zero(axis.virtual_damping),
         "no damping may be below zero");
  const double late = axis.delay / axis.sample_time;
  expect(at_least_zero(late) && late <= most_samples_late,
         "the delay must be between zero and 1000 samples");
  const double scale = axis.sample_time / axis.inertia;
  return {axis.damping * scale, axis.virtual_damping * scale, static_cast<Eigen::Index>(late),
          late - std::floor(late)};
}

/// The free axis over a time under a constant force: x += drift v + push F, v = decay v + drift F.
struct UnitCoast {
  double decay;  ///< e^(−a h)
  double drift;  ///< ∫ e^(−a t) dt
  double push;   ///< ∫∫ e^(−a t) dt²
};

UnitCoast coast(double a, double h) {
  const double z = a * h;
  // The series avoids the cancellation of the closed form.
  if (z < 0.01) {
    const double drift = h * (1 - z / 2 * (1 - z / 3 * (1 - z / 4 * (1 - z / 5 * (1 - z / 6)))));
    const double push = h * h / 2 * (1 - z / 3 * (1 - z / 4 * (1 - z / 5 * (1 - z / 6))));
    return {elementary::exp(-z), drift, push};
  }
  const double drift = -elementary::expm1(-z) / a;
  return {elementary::exp(-z), drift, (h - drift) / a};
}

/// One sample of the loop, on (x_k, v_k, x_{k−1}, F_{k−1}, F_{k−2}, ...), with all forces that are
/// still delayed.
Eigen::MatrixXd transition(const ScaledLoop& loop, double stiffness) {
  const Eigen::Index forces = loop.samples_late + (loop.rest > 0 ? 1 : 0);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(3 + forces, 3 + forces);
  Eigen::RowVectorXd force_now = Eigen::RowVectorXd::Zero(3 + forces);
  force_now(0) = -(stiffness + loop.virtual_damping);
  force_now(2) = loop.virtual_damping;
  const auto force = [&](Eigen::Index samples_ago) -> Eigen::RowVectorXd {
    if (samples_ago == 0) return force_now;
    return Eigen::RowVectorXd::Unit(3 + forces, 2 + samples_ago);
  };
  Eigen::RowVectorXd x = Eigen::RowVectorXd::Unit(3 + forces, 0);
  Eigen::RowVectorXd v = Eigen::RowVectorXd::Unit(3 + forces, 1);
  const auto go_on = [&](double time, Eigen::Index samples_ago) {
    const UnitCoast c = coast(loop.damping, time);
    const Eigen::RowVectorXd F = force(samples_ago);
    x += c.drift * v + c.push * F;
    v = c.decay * v + c.drift * F;
  };
  if (loop.rest > 0) go_on(loop.rest, loop.samples_late + 1);
  go_on(1 - loop.rest, loop.samples_late);
  M.row(0) = x;
  M.row(1) = v;
  M(2, 0) = 1;
  if (forces > 0) M.row(3) = force_now;
  for (Eigen::Index i = 1; i < forces; ++i) M(3 + i, 2 + i) = 1;
  return M;
}

double radius(const ScaledLoop& loop, double stiffness) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(transition(loop, stiffness), false);
  double largest = 0;
  for (const auto& value : solver.eigenvalues())
    largest = std::max(largest, elementary::size(value));
  return largest;
}

/// Rounding leaves this error of the eigenvalue of a free axis, which is 1.
bool stable(const ScaledLoop& loop, double stiffness) {
  return radius(loop, stiffness) <= 1 + 1e-12;
}

}  // namespace

double spectral_radius(const SampledAxis& axis, double stiffness) {
  if (!std::isfinite(stiffness))
    throw std::invalid_argument("sampled axis: the stiffness must be a number");
  return radius(scaled_loop_of(axis),
                stiffness * axis.sample_time * axis.sample_time / axis.inertia);
}

double largest_stable_stiffness(const SampledAxis& axis) {
  const ScaledLoop loop = scaled_loop_of(axis);
  // Far below what any damping can stabilise: if it is unstable there, it is always unstable.
  double low = 1e-6 * std::min(1.0, loop.damping + loop.virtual_damping);
  if (low == 0 || !stable(loop, low)) return 0;
  double high = 2 * low;
  while (stable(loop, high)) {
    low = high;
    high *= 2;
  }
  while (high - low > 1e-7 * high) {
    const double middle = (low + high) / 2;
    (stable(loop, middle) ? low : high) = middle;
  }
  return low * axis.inertia / (axis.sample_time * axis.sample_time);
}

double largest_passive_stiffness(const SampledAxis& axis) {
  scaled_loop_of(axis);  // for its checks
  return std::max(0.0, axis.damping - axis.virtual_damping) / (axis.sample_time / 2 + axis.delay);
}

}  // namespace sonde
