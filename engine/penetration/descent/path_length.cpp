// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/path_length.hpp"

#include <algorithm>

#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {

void PathLength::gave_up(double length, bool by_itself) noexcept {
  longest_ = descent_tuning.longest_after_giving_up * length;
  if (by_itself) given_up_ = length;
}

void PathLength::went() noexcept {
  given_up_ *= descent_tuning.given_up_growth;
  longest_ = std::min(2 * longest_, descent_tuning.most_of_given_up * given_up_);
}

}  // namespace sonde
