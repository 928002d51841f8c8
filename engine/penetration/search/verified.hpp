// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/penetration/descent/leap_descent.hpp"
#include "engine/penetration/descent/refinement.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// What a search may return: the nearest of the poses that were taken to the last digit and stand
/// the exact test, whatever ends the search.
class Verified {
 public:
  Verified(const Pair& pair, const Chart& chart);

  /// The free pose at y to the last digit, by so many steps at most.
  Separation refined(Method method, const Vec6& y, LeapDescent& leaps, int steps,
                     const Deadline& deadline);
  /// Takes an answer over where it is nearer than the best so far, and free by the exact test.
  void add(const Separation& answer);
  bool is_free(const Separation& answer) const;
  const std::optional<Separation>& best() const { return best_; }

 private:
  const Body& probe_;
  const Body& fixed_;
  const Chart& chart_;
  std::array<std::optional<Refinement>, 2>
      refinements_;  // of each method, made when first asked for
  std::optional<Separation> best_;
};

}  // namespace sonde
