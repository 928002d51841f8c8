// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/result.hpp"
#include "tests/bench/table.hpp"

namespace sonde::bench {

/// A figure that is asked of Sonde: a query at some kinds of poses, over all pairs that are not of
/// the curves.
struct Figure {
  std::string name;
  std::string query;
  std::vector<std::string> poses;
  std::string against;        ///< the library that the ratio is with; "" where there is none
  double at_most_us = 0;      ///< asked of the median; 0: nothing
  double at_least_ratio = 0;  ///< asked of the ratio of medians; 0: nothing
};
std::vector<Figure> figures();

/// Their median / ours over the poses of all pairs together; nothing where it was not measured.
std::optional<double> ratio_of(const std::vector<Result>& results, const Figure& figure);

/// One row for each figure that was measured: the medians over the poses of all pairs together, the
/// worst pair by itself, and how many pairs meet what is asked.
Table figures_table(const std::vector<Result>& results, const std::vector<Figure>& figures);

}  // namespace sonde::bench
