// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/deadline.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/search_tuning.hpp"

namespace sonde {

/// What a static search may still spend, by the clock and in counted steps, and how it shares its
/// time out: on sketches, on all of the search, on refining what was found.
class SearchBudget {
 public:
  SearchBudget(const Budget& budget, const Deadline& deadline, const SearchTuning& tuning);

  bool is_limited() const { return budget_.microseconds > 0 || budget_.steps > 0; }
  bool is_timed() const { return budget_.microseconds > 0; }
  /// So little time that a second thread costs more than it brings.
  bool is_short() const { return short_; }
  bool counts_steps() const { return budget_.steps > 0; }
  int steps_left() const;  ///< 0 at least; where none are counted, as many as there are numbers
  int steps_spent() const { return spent_; }
  void spend(int steps) { spent_ += steps; }
  /// A start was cut short by the steps: what it took counts for nothing, and none are left.
  void spend_all() { spent_ = budget_.steps; }

  const Deadline& sketching() const { return sketching_; }
  const Deadline& searching() const { return searching_; }
  const Deadline& refining() const { return refining_; }
  /// No more starts.
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
