// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/geometry/chart.hpp"

namespace sonde {

/// Mixes the steps of a slow descent. Where the contacts bend about as much as the sphere of equal
/// |y|, each step covers a small part of the way, and several such parts overlay each other: some
/// go on, some return. The step wanted at a pose is then nearly a linear function of the pose, and
/// the last ones tell where it vanishes (Anderson's mixing of depth two; Walker and Ni, Anderson
/// acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49, 2011). Lengths in m of y.
class StepMixing {
 public:
  /// Notes the step that the rows want at the pose y, one pose after the other. If the last step
  /// was a mixed one and the wanted step grew, that function is not linear: what is known is
  /// forgotten, and the next mixed step waits for twice as many steps.
  void note(const Vec6& y, const Vec6& wanted) noexcept;
  /// The step from the last pose noted to where the wanted step vanishes, as far as the last three
  /// poses tell; none before that, or while waiting.
  std::optional<Vec6> mixed() const noexcept;
  /// The mixed step is taken.
  void take() noexcept { taken_ = true; }

 private:
  Vec6 y_, wanted_;            // at the last pose
  Vec6 moved_[2], change_[2];  // between poses, newest first: of y, and of the wanted step
  int poses_ = 0;              // noted since the last time that all was forgotten
  int wait_ = 2, waited_ = 0;  // steps
  bool taken_ = false;
};

}  // namespace sonde
