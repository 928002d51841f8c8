// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "engine/sonde.hpp"

namespace sonde::app {

/// The motions that a query is among, where they are fewer than those of a method: one of three
/// kinds, or none. Numbers as given, three to a vector, in the fixed body's mesh frame.
struct QueryMotions {
  std::vector<double> along;     ///< directions
  std::vector<double> about;     ///< a point (m) and an axis
  std::vector<double> in_plane;  ///< the plane's normal
  bool sliding = false;          ///< in the plane without turns

  bool any() const { return !along.empty() || !about.empty() || !in_plane.empty(); }
  /// The answer does not depend on a seed or a budget.
  bool exact() const { return !along.empty() || !about.empty(); }
  /// All numbers, for what parts of one run have in common.
  std::vector<std::vector<double>> numbers() const;
};
void add_flags(CLI::App& parser, QueryMotions& motions);

/// @throws UsageError where kinds are mixed, or a vector is not whole or 0.
void check(const QueryMotions& motions);

/// The least of the motions that sets the probe free. @pre check(), and there are motions.
Separation separate_within(const Pair& pair, const Pose& X_FM, const QueryMotions& motions,
                           const StaticOptions& options);

}  // namespace sonde::app
