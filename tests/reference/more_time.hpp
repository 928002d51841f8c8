// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "tests/bench/table.hpp"
#include "tests/reference/measure.hpp"

namespace sonde::reference {

/// What the searches of the same rows make of more and more time.
struct MoreTime {
  double budget_us = 0;
  std::vector<Measured> all;
};

/// A line for each budget: how many are within 1 % and 5 %, and how many are deeper than with some
/// budget before it, by more than 5 % and by more than half.
bench::Table more_time(std::span<const MoreTime> budgets);

}  // namespace sonde::reference
