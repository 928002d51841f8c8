// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/penetration/descent/leap_descent.hpp"
#include "engine/penetration/descent/refinement.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// Keeps the best answer that a search may return at any time: the nearest of the refined poses
/// that pass the exact test.
class Verified {
 public:
  /// `times`: receives the times of phases; null: they are not recorded.
  Verified(const Pair& pair, const Chart& chart, PhaseTimes* times = nullptr);

  /// Refines the free pose at y to full accuracy with at most `steps` steps.
  Separation refined(Method method, const Vec6& y, LeapDescent& leaps, int steps,
                     const Deadline& deadline);
  /// Keeps the answer if it is nearer than the best so far and free by the exact test.
  void add(const Separation& answer);
  bool is_free(const Separation& answer) const;
  const std::optional<Separation>& best() const { return best_; }

 private:
  /// Whether it is a refinement of the same optimum, to the accuracy of one.
  bool is_beside_best(const Separation& answer) const;

  const Body& probe_;
  const Body& fixed_;
  const Chart& chart_;
  PhaseTimes* times_;
  std::array<std::optional<Refinement>, 2>
      refinements_;  // for each method, constructed on first use
  std::optional<Separation> best_;
};

}  // namespace sonde
