// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "engine/geometry/chart.hpp"

namespace sonde {

/// One linear constraint n·y ≥ bound.
struct HalfSpace {
  Vec6 normal;
  double bound;
};

/// The point nearest to the origin in an intersection of half-spaces: y = Σ multiplierᵢ normalᵢ,
/// all multipliers positive.
struct LeastDistance {
  Vec6 y = Vec6::Zero();
  std::array<int, 6> active{};         ///< indices of the rows that hold y
  std::array<double, 6> multiplier{};  ///< in the unit of y per unit of the normals
  int active_count = 0;
  bool feasible = true;  ///< false: the half-spaces have no common point, and y is meaningless
};

/// min |y|² subject to the rows, by the dual active-set method of Goldfarb and Idnani (1983). With
/// the identity as Hessian it starts at the origin and adds the most violated row, until no row is
/// violated. At most six rows are active. It accepts violations below `tolerance` (in the unit of
/// bound). Never allocates.
///
/// `start`: rows that are probably active, because they were in a similar problem. If they are
/// independent and have positive multipliers, the search begins there instead of at the origin. The
/// answer is the same to rounding. The fewer of these rows are inactive at the solution, the fewer
/// iterations are needed.
LeastDistance least_distance(std::span<const HalfSpace> rows, double tolerance,
                             std::span<const int> start = {});

}  // namespace sonde
