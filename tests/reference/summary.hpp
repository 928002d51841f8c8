// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/table.hpp"
#include "tests/reference/measure.hpp"

namespace sonde::reference {

/// One line for each pair; then all rows, those of each kind, and those whose reference is agreed
/// and is not. `budget_us` 0: no column for the time beside it.
bench::Table summary(const std::vector<Measured>& all, double budget_us);

/// One line for each row.
bench::Table details(const std::vector<Measured>& all);

/// The rows furthest above their reference by more than 1 %, the worst first.
bench::Table worst(const std::vector<Measured>& all, std::size_t most);

/// The rows that are better than their reference by more than the reference repeats to.
bench::Table better(const std::vector<Measured>& all);

}  // namespace sonde::reference
