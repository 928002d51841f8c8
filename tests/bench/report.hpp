// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/bench/plot.hpp"
#include "tests/bench/result.hpp"
#include "tests/bench/table.hpp"

namespace sonde::bench {

/// One row for each library of each result: what the CSV and the JSON file hold.
Table long_table(const std::vector<Result>& results);

/// One table for each query, one row for each result, the libraries side by side: what is printed.
std::string wide_tables(const std::vector<Result>& results);

/// The curves over the number of triangles, by the name of their file.
std::map<std::string, Plot> plots(const std::vector<Result>& results);

}  // namespace sonde::bench
