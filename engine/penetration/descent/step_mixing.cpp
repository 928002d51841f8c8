// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/step_mixing.hpp"

#include <utility>

namespace sonde {
namespace {

/// Share of the squared changes: keeps the two weights apart where the changes are parallel.
constexpr double regularisation = 1e-10;

}  // namespace

void StepMixing::note(const Vec6& y, const Vec6& wanted) noexcept {
  ++waited_;
  if (std::exchange(taken_, false) && wanted.norm() > wanted_.norm())
    poses_ = waited_ = 0, wait_ *= 2;
  if (poses_ > 0) {
    moved_[1] = moved_[0], change_[1] = change_[0];
    moved_[0] = y - y_, change_[0] = wanted - wanted_;
  }
  y_ = y, wanted_ = wanted;
  ++poses_;
}

std::optional<Vec6> StepMixing::mixed() const noexcept {
  if (poses_ < 3 || waited_ < wait_) return std::nullopt;
  // The weights w of the changes minimise |wanted − Σ w change|.
  const double a = (1 + regularisation) * change_[0].squaredNorm(),
               d = (1 + regularisation) * change_[1].squaredNorm(), b = change_[0].dot(change_[1]);
  const double first = change_[0].dot(wanted_), second = change_[1].dot(wanted_);
  const double size = a * d - b * b;
  if (!(size > 0)) return std::nullopt;
  const double w0 = (d * first - b * second) / size, w1 = (a * second - b * first) / size;
  const Vec6 step = wanted_ - w0 * (moved_[0] + change_[0]) - w1 * (moved_[1] + change_[1]);
  if (!step.allFinite()) return std::nullopt;
  return step;
}

}  // namespace sonde
