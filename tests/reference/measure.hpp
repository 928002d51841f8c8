// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/penetration/search/search_tuning.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/reference/depths_file.hpp"

namespace sonde::reference {

/// What the static search made of one row.
struct Measured {
  Row row;
  double reference = 0;  ///< the depth to compare with, m: the row's best, or its PD_t
  Separation got;
  /// Of the search alone: of the processor, or by the wall's clock where there is a budget of time
  /// or a second thread.
  double time_us = 0;
  std::optional<double> lower_bound;  ///< m
  double bound_us = 0;                ///< of the lower bound, by the same clock
  bool free = false;                  ///< the pose returned, by the exact test
  /// √σ / reference − 1; infinite where the search failed.
  double excess() const;
};

/// The search, and then the bound by itself; or, where the options do not ask for the whole bound,
/// the search again with what bound it makes, which takes so much more.
Measured measure(const Row& row, const Pair& pair, const StaticOptions& options,
                 const SearchTuning& tuning = search_tuning);

/// The row with what is better than its reference taken over; false where nothing is.
bool mend(Row& row, const Measured& by, Method method);

}  // namespace sonde::reference
