// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_budget.hpp"

#include <algorithm>
#include <limits>

namespace sonde {

SearchBudget::SearchBudget(const Budget& budget, const Deadline& deadline,
                           const SearchTuning& tuning)
    : budget_(budget),
      short_(budget.microseconds > 0 && budget.microseconds < tuning.shortest_for_two_threads),
      sketching_(deadline.part(tuning.share_for_sketches)),
      searching_(deadline.part(tuning.share_for_search)),
      refining_(deadline.part(tuning.share_for_refining)) {}

int SearchBudget::steps_left() const {
  return counts_steps() ? std::max(0, budget_.steps - spent_) : std::numeric_limits<int>::max();
}

}  // namespace sonde
