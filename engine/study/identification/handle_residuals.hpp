// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/study/identification/free_handle.hpp"
#include "engine/study/identification/pulse_windows.hpp"

namespace sonde {

/// What a fit of a handle looks for, in the order of its vector of parameters.
struct HandleParameter {
  enum Index : Eigen::Index { inertia, damping, friction, delay, offset, count };
};

/// Scales of the parameters, so that the solver works with numbers near one.
using HandleScale = std::array<double, HandleParameter::count>;

/// Number of samples of the window that were measured.
Eigen::Index measured_size(const AxisResponse& response, const PulseWindow& window);
/// Of the samples of the window that were measured.
Eigen::VectorXd measured_within(const AxisResponse& response, const std::vector<double>& of,
                                const PulseWindow& window);
Eigen::VectorXd without_mean(const Eigen::VectorXd& x);
/// Of the measured motion about its mean in each window, m | rad.
double motion_rms(const AxisResponse& response, const std::vector<PulseWindow>& windows);

/// The motion of the model under the recorded commands, in parts that each begin at rest. `early`:
/// see free_motion.
std::vector<double> modelled_motion(const FreeHandle& handle, const AxisResponse& response,
                                    std::span<const double> early = {});

/// Measured minus modelled motion, in shares of the motion's rms, as Eigen's solver takes it. If
/// the times of commands are parameters too (as shares of the sample before), their prior follows.
struct HandleResiduals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const AxisResponse* response;
  const std::vector<PulseWindow>* windows;
  HandleScale scale;
  double unit;  ///< m | rad
  /// Samples with a new command; empty: at the logged times.
  std::vector<std::size_t> changes = {};
  double prior = 0;        ///< weight of the logged time
  Progress progress = {};  ///< called with `done` at each evaluation
  double done = 0;

  int inputs() const;
  int values() const;
  std::vector<double> modelled_by(const Eigen::VectorXd& p) const;
  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& out) const;
  Eigen::VectorXd at(const Eigen::VectorXd& p) const;
};

}  // namespace sonde
