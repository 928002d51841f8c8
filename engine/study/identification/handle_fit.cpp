// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/handle_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"
#include "engine/study/identification/handle_residuals.hpp"
#include "engine/study/identification/student_t.hpp"

namespace sonde {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using P = HandleParameter;

/// When the largest pulse becomes visible: at a hundredth of its excursion.
double first_delay(const AxisResponse& r, const PulseWindow& w) {
  const double shows = excursion(r.positions, w) / 100;
  std::size_t i = w.first;
  while (i + 1 < w.end && std::abs(r.positions[i] - r.positions[w.begin]) < shows) ++i;
  return r.times[i] - r.times[w.first];
}

/// The inertia with which the largest pulse, without losses, has the measured excursion.
double first_inertia(const AxisResponse& r, const PulseWindow& w) {
  const std::vector<double> modelled = modelled_motion({.inertia = 1}, r);
  return excursion(modelled, w) / excursion(r.positions, w);
}

/// Relative change of the residuals, and of the parameters, at which the fit of the commands' times
/// ends. It decides whether late commands explain the residuals; where they do not it would creep
/// on for minutes, without a change in what is reported.
constexpr double times_tolerance = 1e-4;

VectorXd solved(const HandleResiduals& residuals, VectorXd p) {
  Eigen::NumericalDiff<HandleResiduals> numeric(residuals, 1e-12);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<HandleResiduals>> solver(numeric);
  solver.parameters.maxfev = 100 * (residuals.inputs() + 1);
  if (!residuals.changes.empty()) solver.parameters.ftol = solver.parameters.xtol = times_tolerance;
  solver.minimize(p);
  return p;
}

/// Starts from several values of friction and delay, because a start or a stop of the handle that
/// the model lacks is a barrier between a start value and the solution.
VectorXd best_solution(HandleResiduals& residuals) {
  constexpr double share = 0.1;  // of a start: six take most of the time
  VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const double rubs : {0.1, 0.5, 1.0})
    for (const double late : {0.5, 1.0}) {
      VectorXd start(Index{P::count});
      start << 1 / (1 + rubs), 0.3, rubs, late, 0;
      const VectorXd p = solved(residuals, start);
      const double left = residuals.at(p).squaredNorm();
      if (left < least) {
        least = left;
        best = p;
      }
      residuals.done += share;
    }
  return best;
}

/// With steps relative to each parameter, away from zero, where the model has a kink.
MatrixXd jacobian(const HandleResiduals& residuals, const VectorXd& p) {
  constexpr double step = 1e-5;
  MatrixXd J(residuals.values(), p.size());
  for (Index i = 0; i < p.size(); ++i) {
    VectorXd less = p, more = p;
    less[i] -= std::min(step, std::abs(p[i]));
    if (i < P::count || p[i] < 0.9) more[i] += step;
    J.col(i) = (residuals.at(more) - residuals.at(less)) / (more[i] - less[i]);
  }
  return J;
}

/// The solution of normal equations, scaled by each parameter's size; none if they are singular.
std::optional<VectorXd> solution_of(const MatrixXd& information, const VectorXd& pull) {
  const VectorXd sizes = information.diagonal().cwiseSqrt();
  if (!(sizes.minCoeff() > 0)) return std::nullopt;
  const VectorXd by = sizes.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> scaled(by.asDiagonal() * information *
                                                       by.asDiagonal());
  if (!(scaled.eigenvalues().minCoeff() > 1e-9 * scaled.eigenvalues().maxCoeff()))
    return std::nullopt;
  const VectorXd inner = scaled.eigenvectors().transpose() * by.cwiseProduct(pull);
  return by.cwiseProduct(scaled.eigenvectors() * inner.cwiseQuotient(scaled.eigenvalues()));
}

/// The covariance of the parameters, from the solutions that leave out one pulse each.
MatrixXd covariance(const MatrixXd& J, const VectorXd& left, const AxisResponse& response,
                    const std::vector<PulseWindow>& windows) {
  const MatrixXd information = J.transpose() * J;
  MatrixXd spread = MatrixXd::Zero(J.cols(), J.cols());
  Index at = 0;
  for (const PulseWindow& w : windows) {
    const Index size = measured_size(response, w);
    const MatrixXd own = J.middleRows(at, size);
    const auto change =
        solution_of(information - own.transpose() * own, own.transpose() * left.segment(at, size));
    if (!change)
      throw std::invalid_argument("the pulses do not tell mass, damping and friction apart");
    spread += *change * change->transpose();
    at += size;
  }
  const auto pulses = static_cast<double>(windows.size());
  return (pulses - 1) / pulses * spread;
}

/// The effect of the encoder's rounding on the parameters: it depends on where the handle stands
/// between two steps, which may be much the same in all pulses of a recording.
MatrixXd covariance_of_encoder(const MatrixXd& J, const HandleResiduals& residuals,
                               const VectorXd& p, double step) {
  constexpr int phases = 16;
  const std::vector<double> motion = residuals.modelled_by(p);
  const Eigen::LDLT<MatrixXd> information(J.transpose() * J);
  MatrixXd spread = MatrixXd::Zero(J.cols(), J.cols());
  for (int phase = 0; phase < phases && step > 0; ++phase) {
    const double shift = (phase + 0.5) / phases;
    VectorXd error = VectorXd::Zero(J.rows());
    Index at = 0;
    for (const PulseWindow& w : *residuals.windows) {
      const Eigen::ArrayXd steps =
          measured_within(*residuals.response, motion, w).array() / step + shift;
      const VectorXd rounded = without_mean((steps.round() - steps).matrix());
      error.segment(at, rounded.size()) = rounded * (step / residuals.unit);
      at += rounded.size();
    }
    const VectorXd change = information.solve(J.transpose() * error);
    spread += change * change.transpose() / phases;
  }
  return spread;
}

/// Ratio of the residuals to their white part or the encoder's rounding: after von Neumann (1941),
/// by second differences, which are insensitive to slow errors.
double excess_of(const HandleResiduals& residuals, const VectorXd& left, double encoder_step) {
  double squares = 0, bends = 0, samples = 0;
  Index at = 0;
  for (const PulseWindow& w : *residuals.windows) {
    const Index size = measured_size(*residuals.response, w);
    squares += left.segment(at, size).squaredNorm();
    for (Index i = at + 1; i + 1 < at + size; ++i) {
      const double bend = left[i - 1] - 2 * left[i] + left[i + 1];
      bends += bend * bend / 6;
    }
    samples += static_cast<double>(size);
    at += size;
  }
  const double rounding = encoder_step / residuals.unit;
  // Share of the motion: residual of a valid model for exact poses.
  constexpr double nothing = 1e-5;
  const double expected = std::max({bends / samples, rounding * rounding / 12, nothing * nothing});
  return std::sqrt(squares / samples / expected);
}

/// The samples of the pulses with a command different from the one before.
std::vector<std::size_t> changes_of_command(const AxisResponse& r,
                                            const std::vector<PulseWindow>& windows) {
  std::vector<std::size_t> out;
  for (const PulseWindow& w : windows)
    for (std::size_t k = std::max<std::size_t>(w.first, 1); k <= w.last && k < w.end; ++k)
      if (r.commands[k] != r.commands[k - 1]) out.push_back(k);
  return out;
}

/// How far the solutions of parts of the pulses differ from that of all, linearised.
VectorXd spread_of_parts(const MatrixXd& J, const VectorXd& left,
                         const HandleResiduals& residuals) {
  std::vector<double> sizes;
  for (const PulseWindow& w : *residuals.windows) sizes.push_back(w.amplitude);
  ordering::nth_element(sizes.begin(), sizes.begin() + std::ssize(sizes) / 2, sizes.end());
  const double middle = sizes[sizes.size() / 2];
  const auto& commands = residuals.response->commands;
  VectorXd out = VectorXd::Zero(J.cols());
  for (const int part : {0, 1, 2, 3}) {
    MatrixXd information = MatrixXd::Zero(J.cols(), J.cols());
    VectorXd pull = VectorXd::Zero(J.cols());
    Index at = 0;
    for (const PulseWindow& w : *residuals.windows) {
      const Index size = measured_size(*residuals.response, w);
      const bool in = part < 2 ? (w.amplitude >= middle) == (part == 0)
                               : (commands[w.first] > 0) == (part == 2);
      if (in) {
        information += J.middleRows(at, size).transpose() * J.middleRows(at, size);
        pull += J.middleRows(at, size).transpose() * left.segment(at, size);
      }
      at += size;
    }
    const auto rest = J.bottomRows(J.rows() - at);  // rows of the prior
    information += rest.transpose() * rest;
    if (const auto change = solution_of(information, pull)) out = out.cwiseMax(change->cwiseAbs());
  }
  return out;
}

struct Solution {
  HandleResiduals residuals;
  VectorXd p, left;
  double excess;
};

constexpr double most_excess = 2;

constexpr double least_apart = 0.1;  // of a sample: if less, all are equally late, which is a delay

/// Fits the times of the commands too, if that explains the residuals.
void doubt_times(Solution& found, double encoder_step) {
  Solution freed = found;
  HandleResiduals& r = freed.residuals;
  r.changes = changes_of_command(*r.response, *r.windows);
  if (r.changes.empty()) return;
  // The prior of a share between 0 and 1, relative to residuals of the expected size.
  constexpr double deviation = 0.29;
  r.prior = std::max(encoder_step / r.unit / std::sqrt(12.0), 1e-5) / deviation;
  freed.p = VectorXd::Zero(r.inputs());
  freed.p.head(Index{P::count}) = found.p;
  freed.p = solved(r, freed.p);
  freed.left = r.at(freed.p);
  freed.excess = excess_of(r, freed.left, encoder_step);
  const VectorXd shares = without_mean(freed.p.tail(std::ssize(r.changes)));
  const double apart = std::sqrt(shares.squaredNorm() / static_cast<double>(shares.size()));
  if (freed.excess <= most_excess && apart > least_apart) found = freed;
}

}  // namespace

HandleFit fit_handle(const AxisResponse& response, const std::vector<PulseWindow>& windows,
                     double encoder_step, const Progress& progress) {
  if (windows.size() < 8) throw std::invalid_argument("fewer than eight pulses");
  const PulseWindow& largest = *std::ranges::max_element(windows, {}, &PulseWindow::amplitude);
  const double seen = first_inertia(response, largest);
  const double lasts = response.times[largest.last - 1] - response.times[largest.first];
  const double sample = lasts / static_cast<double>(largest.last - 1 - largest.first);
  const double least = std::ranges::min_element(windows, {}, &PulseWindow::amplitude)->amplitude;
  const HandleScale scale{seen, seen / lasts, least / 2,
                          std::max(first_delay(response, largest), sample), least / 10};
  Solution found{{.response = &response,
                  .windows = &windows,
                  .scale = scale,
                  .unit = motion_rms(response, windows),
                  .progress = progress},
                 {},
                 {},
                 1};
  found.p = best_solution(found.residuals);
  found.left = found.residuals.at(found.p);
  found.excess = excess_of(found.residuals, found.left, encoder_step);
  const VectorXd as_logged = found.p;
  if (found.excess > most_excess) doubt_times(found, encoder_step);
  const auto& [residuals, parameters, left, excess] = found;
  const VectorXd& p = parameters;  // a lambda cannot capture a structured binding
  const bool widened = excess > most_excess, between = !residuals.changes.empty();
  const MatrixXd J = jacobian(residuals, p);
  VectorXd apart = VectorXd::Zero(p.size());
  if (widened) apart = spread_of_parts(J, left, residuals);
  if (between) apart.head(as_logged.size()) = (p.head(as_logged.size()) - as_logged).cwiseAbs();
  const MatrixXd C =
      covariance(J, left, response, windows) + covariance_of_encoder(J, residuals, p, encoder_step);
  const double t = student_t_99(static_cast<double>(windows.size() - 1));
  const auto estimate = [&](P::Index i) {
    const double unit = scale[static_cast<std::size_t>(i)];
    const double value = std::abs(p[i]) * unit;
    // All commands may be equally late, which is indistinguishable from a delay.
    const double late = i == P::delay && between ? sample / 2 : 0;
    const double half = (t * std::sqrt(std::max(0.0, C(i, i))) + apart[i]) * unit + late;
    return Estimate{value, std::max(0.0, value - half), value + half};
  };
  return {.inertia = estimate(P::inertia),
          .damping = estimate(P::damping),
          .friction = estimate(P::friction),
          .delay = estimate(P::delay),
          .offset = p[P::offset] * scale[P::offset],
          .misfit = std::sqrt(left.squaredNorm() / static_cast<double>(left.size())),
          .excess = excess,
          .between = between,
          .widened = widened};
}

}  // namespace sonde
