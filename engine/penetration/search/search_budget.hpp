// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/deadline.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/search_tuning.hpp"

namespace sonde {

/// The remaining budget of a static search, in time and in counted steps, and the deadlines of its
/// parts: the search on sketches, the whole search, and the refinement of the results.
class SearchBudget {
 public:
  SearchBudget(const Budget& budget, const Deadline& deadline, const SearchTuning& tuning);

  bool is_limited() const { return budget_.microseconds > 0 || budget_.steps > 0; }
  bool is_timed() const { return budget_.microseconds > 0; }
  /// The time is so short that a second thread costs more than it gains.
  bool is_short() const { return short_; }
  bool counts_steps() const { return budget_.steps > 0; }
  int steps_left() const;  ///< at least 0; if steps are not counted, the largest int
  int steps_spent() const { return spent_; }
  void spend(int steps) { spent_ += steps; }
  /// Call it if the steps cut a start short: its result is discarded, and no steps are left.
  void spend_all() { spent_ = budget_.steps; }

  const Deadline& sketching() const { return sketching_; }
  const Deadline& searching() const { return searching_; }
  const Deadline& refining() const { return refining_; }
  /// No more starts are allowed.
  bool search_is_over() const { return searching_.passed() || steps_left() == 0; }
  /// Nothing is left for refining either.
  bool is_over() const { return refining_.passed() || steps_left() == 0; }

 private:
  Budget budget_;
  bool short_;
  Deadline sketching_, searching_, refining_;
  int spent_ = 0;
};

}  // namespace sonde
