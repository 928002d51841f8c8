// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/contact_stability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unsupported/Eigen/MatrixFunctions>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Rows = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Without damping, a direction without resistance has the double eigenvalue 1, which rounding
/// splits by its square root.
constexpr double rounding = 1e-7;
constexpr double slowest_growth = std::numbers::ln2 / 60;  // 1/s

/// The part of the wrench that the device's motors can render.
Mat6 rendered(const SimulatedDeviceParameters& device, Mat6 felt) {
  if (!(device.translation.limit > 0)) felt.topRows<3>().setZero();
  if (!(device.rotation.limit > 0)) felt.bottomRows<3>().setZero();
  return felt;
}

/// Replaces the off-diagonal blocks by their mean, if they are known to be each other's transpose.
Mat6 as_gradient(Mat6 felt) {
  const Mat3 mean = (felt.topRightCorner<3, 3>() + felt.bottomLeftCorner<3, 3>().transpose()) / 2;
  felt.topRightCorner<3, 3>() = mean;
  felt.bottomLeftCorner<3, 3>() = mean.transpose();
  return felt;
}

SampledContact rendered(SampledContact contact) {
  if (contact.gradient)
    for (Mat6* each : {&contact.stiffness, &contact.held_stiffness}) *each = as_gradient(*each);
  contact.stiffness = rendered(contact.device, contact.stiffness);
  contact.held_stiffness = rendered(contact.device, contact.held_stiffness);
  contact.damping = rendered(contact.device, contact.damping);
  return contact;
}

/// The motion of the handle and the hand over a time under a constant force, along each axis: new x
/// and v from the old and the force.
struct Coast {
  Vec6 x_x, x_v, x_f, v_x, v_v, v_f;
};

Mat3 coast_of(const HandleMotion& m, double time) {
  Mat3 rates = Mat3::Zero();
  rates(0, 1) = 1;
  rates(1, 0) = -m.hand_stiffness / m.inertia;
  rates(1, 1) = -(m.damping + m.hand_damping) / m.inertia;
  rates(1, 2) = 1 / m.inertia;
  return (rates * time).exp();
}

Coast coast(const SimulatedDeviceParameters& device, double time) {
  const Mat3 t = coast_of(device.translation, time), r = coast_of(device.rotation, time);
  const auto both = [&](Index row, Index column) {
    Vec6 out;
    out << Vec3::Constant(t(row, column)), Vec3::Constant(r(row, column));
    return out;
  };
  return {both(0, 0), both(0, 1), both(0, 2), both(1, 0), both(1, 1), both(1, 2)};
}

/// Where the motions along several axes are all but the same, the iteration may not converge, and
/// what it then holds are no eigenvalues. Those of the transposed matrix are the same. No value if
/// neither converges, as for what is not a number.
std::optional<Eigen::VectorXcd> eigenvalues_of(const MatrixXd& matrix) {
  const Eigen::EigenSolver<MatrixXd> solver(matrix, false);
  if (solver.info() == Eigen::Success) return solver.eigenvalues();
  const Eigen::EigenSolver<MatrixXd> transposed(matrix.transpose(), false);
  if (transposed.info() == Eigen::Success) return transposed.eigenvalues();
  return std::nullopt;
}

/// One sample of the loop, with K times a factor, on (x_k, v_k, x_{k−1}, F_{k−1}, F_{k−2}, ...).
class Loop {
 public:
  explicit Loop(const SampledContact& contact) : contact_(rendered(contact)) {
    const double late = contact.device.delay / contact.sample_time;
    samples_late_ = static_cast<Index>(late);
    const double rest = late - std::floor(late);
    forces_ = samples_late_ + (rest > 0 ? 1 : 0);
    split_ = rest > 0;
    older_ = coast(contact.device, rest * contact.sample_time);
    newer_ = coast(contact.device, (1 - rest) * contact.sample_time);
  }

  /// The spectral radius for oscillations of at least `slowest` Hz; infinite if it is not known.
  double radius(double factor, double slowest = 0) const {
    const double least = 2 * std::numbers::pi * slowest * contact_.sample_time;
    const auto values = eigenvalues_of(transition(factor));
    if (!values) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const auto& value : *values)
      if ((value.imag() != 0 || value.real() < 0) &&
          std::abs(elementary::atan2(value.imag(), value.real())) >= least)
        largest = std::max(largest, elementary::size(value));
    return largest;
  }
  bool stable(double factor, double slowest) const {
    return radius(factor, slowest) <= 1 + rounding;
  }
  /// Whether every swing needs at least a minute to double. What grows by more than e while it
  /// turns by a radian, to 23 times in half a swing, does not swing but slides away, on a bent way.
  bool no_swing_grows(double factor) const {
    const double most = 1 + std::max(rounding, slowest_growth * contact_.sample_time);
    const auto values = eigenvalues_of(transition(factor));
    return values && std::ranges::none_of(*values, [&](const auto& value) {
             const double size = elementary::size(value);
             const double turn = std::abs(elementary::atan2(value.imag(), value.real()));
             return size > most && turn > 0 && turn >= elementary::log(size);
           });
  }

 private:
  Rows unit(Index block) const {
    Rows out = Rows::Zero(6, 18 + 6 * forces_);
    out.middleCols<6>(6 * block).setIdentity();
    return out;
  }

  MatrixXd transition(double factor) const {
    const Mat6 per_sample = contact_.damping / contact_.sample_time;
    const Rows force_now =
        per_sample * unit(2) -
        (factor * contact_.stiffness + contact_.held_stiffness + per_sample) * unit(0);
    const auto force = [&](Index samples_ago) -> Rows {
      return samples_ago == 0 ? force_now : unit(2 + samples_ago);
    };
    Rows x = unit(0), v = unit(1);
    const auto go_on = [&](const Coast& c, const Rows& F) {
      const Rows before = x;
      x = c.x_x.asDiagonal() * before + c.x_v.asDiagonal() * v + c.x_f.asDiagonal() * F;
      v = c.v_x.asDiagonal() * before + c.v_v.asDiagonal() * v + c.v_f.asDiagonal() * F;
    };
    if (split_) go_on(older_, force(samples_late_ + 1));
    go_on(newer_, force(samples_late_));

    MatrixXd M = MatrixXd::Zero(18 + 6 * forces_, 18 + 6 * forces_);
    M.topRows<6>() = x;
    M.middleRows<6>(6) = v;
    M.middleRows<6>(12) = unit(0);
    if (forces_ > 0) M.middleRows<6>(18) = force_now;
    for (Index i = 1; i < forces_; ++i) M.middleRows<6>(18 + 6 * i) = unit(2 + i);
    return M;
  }

  SampledContact contact_;
  Index samples_late_ = 0, forces_ = 0;
  bool split_ = false;
  Coast older_, newer_;
};

/// The largest factor at which `holds`, to 1e-4 of itself, searched from the lowest upwards.
template <class Holds>
double largest_factor(const Holds& holds) {
  constexpr double lowest = 1e-9, highest = 1e12;
  if (!holds(lowest)) return 0;
  double low = lowest;
  while (holds(2 * low)) {
    low *= 2;
    if (low > highest) return std::numeric_limits<double>::infinity();
  }
  double high = 2 * low;
  while (high - low > 1e-4 * high) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// The condition D − |B| ⪰ (T/2 + t_d) K, by the symmetric parts.
double largest_dissipated_factor(const SampledContact& contact) {
  const SimulatedDeviceParameters& device = contact.device;
  // In units in which the device's damping is 1, so that every direction has equal weight.
  const auto per_root = [](double x) { return x > 0 ? 1 / std::sqrt(x) : 1e9; };
  Vec6 scale;
  scale << Vec3::Constant(per_root(device.translation.damping)),
      Vec3::Constant(per_root(device.rotation.damping));
  const auto in_units = [&](const Mat6& A) -> Mat6 {
    return scale.asDiagonal() * (A + A.transpose()) / 2 * scale.asDiagonal();
  };
  const double time = contact.sample_time / 2 + device.delay;
  const Mat6 K = time * in_units(contact.stiffness);
  const Mat6 held = time * in_units(contact.held_stiffness) + in_units(contact.damping);
  return largest_factor([&](double factor) {
    const Mat6 taken = factor * K + held;
    const Eigen::SelfAdjointEigenSolver<Mat6> solver(taken, Eigen::EigenvaluesOnly);
    return solver.info() == Eigen::Success && solver.eigenvalues().maxCoeff() <= 1;
  });
}

double lever_of(const Mat6& K) {
  const Mat3 coupling = K.topRightCorner<3, 3>() - K.bottomLeftCorner<3, 3>().transpose();
  return Eigen::JacobiSVD<Mat3>(coupling).singularValues()[0];
}

/// Differences of a solver's answers are symmetric to some thousandths: a lever below this share of
/// the handle's radius of gyration counts as none.
constexpr double no_lever = 0.01;

/// Whether the rendered contact conserves energy.
bool conserves(const SampledContact& contact) {
  const SimulatedDeviceParameters& device = contact.device;
  const double radius = std::sqrt(device.rotation.inertia / device.translation.inertia);
  return std::ranges::all_of(
      std::array{&contact.stiffness, &contact.held_stiffness}, [&](const Mat6* K) {
        const double size = std::max(K->topLeftCorner<3, 3>().norm(),
                                     K->bottomRightCorner<3, 3>().norm() / (radius * radius));
        return lever_of(*K) <= no_lever * radius * size;
      });
}

SampledContact released(SampledContact contact) {
  for (HandleMotion* motion : {&contact.device.translation, &contact.device.rotation})
    motion->hand_stiffness = motion->hand_damping = 0;
  return contact;
}

}  // namespace

double buzz_radius(const SampledContact& contact) { return Loop(contact).radius(1); }

double largest_stable_factor(const SampledContact& contact, double slowest) {
  const Loop loop(contact);
  return largest_factor([&](double factor) { return loop.stable(factor, slowest); });
}

double largest_released_factor(const SampledContact& contact) {
  return largest_stable_factor(released(contact), slowest_buzz);
}

double largest_released_factor_of_any_swing(const SampledContact& contact) {
  const Loop loop(released(contact));
  const double factor = largest_factor([&](double each) { return loop.no_swing_grows(each); });
  return std::min(factor, largest_released_factor(contact));
}

double largest_passive_factor(const SampledContact& contact) {
  const SampledContact wall = rendered(contact);
  return conserves(wall) ? largest_dissipated_factor(wall) : 0;
}

double largest_passive_factor_in_translation(const SampledContact& contact) {
  SampledContact held = rendered(contact);
  for (Mat6* each : {&held.stiffness, &held.held_stiffness, &held.damping}) {
    const Mat3 force = each->topLeftCorner<3, 3>();
    each->setZero();
    each->topLeftCorner<3, 3>() = force;
  }
  return largest_dissipated_factor(held);
}

double cycle_lever(const SampledContact& contact) { return lever_of(rendered(contact).stiffness); }

}  // namespace sonde
