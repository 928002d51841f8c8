// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/penetration/descent/leap_descent.hpp"
#include "engine/penetration/descent/refinement.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// Keeps the answer that a search may return, whatever ends the search: the nearest of the refined
/// poses that pass the exact test.
class Verified {
 public:
  /// `times`: what the times of phases are added to; null: nothing.
  Verified(const Pair& pair, const Chart& chart, PhaseTimes* times = nullptr);

  /// The free pose at y, refined to the last digit by at most `steps` steps.
  Separation refined(Method method, const Vec6& y, LeapDescent& leaps, int steps,
                     const Deadline& deadline);
  /// Keeps the answer if it is nearer than the best so far and free by the exact test.
  void add(const Separation& answer);
  bool is_free(const Separation& answer) const;
  const std::optional<Separation>& best() const { return best_; }

 private:
  const Body& probe_;
  const Body& fixed_;
  const Chart& chart_;
  PhaseTimes* times_;
  std::array<std::optional<Refinement>, 2>
      refinements_;  // of each method, made when first asked for
  std::optional<Separation> best_;
};

}  // namespace sonde
