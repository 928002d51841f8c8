// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/engine/penetration/separation_checks.hpp"

namespace sonde::test {

/// A box of 0.1 × 0.08 × 0.06, flat in a plate of 2 × 2 × 1.
inline const Vec3 brick(0.1, 0.08, 0.06), plate(2, 2, 1);

/// Searches and compares with a depth that is known by hand. Beyond the clearance that an answer
/// may keep it is off by no more than 1e-6 of that; the bound is not above; and the pose is free
/// by the exact test. Prints the line of the table.
inline Separation expect_depth(const std::string& what, const Pair& pair, const Pose& X_FM,
                               double reference) {
  const Separation s = separate_static(pair, X_FM);
  EXPECT_EQ(s.status, Status::penetrating) << what << ": " << s.reason;
  const double clearance = promised_clearance(pair.probe().mass.radius, reference);
  const double above = s.depth - reference;
  EXPECT_TRUE(std::isfinite(s.depth)) << what;
  EXPECT_GE(s.depth, reference * (1 - 1e-6)) << what;
  EXPECT_LE(above, clearance + 1e-6 * reference) << what;
  EXPECT_LE(s.lower_bound.value_or(0), reference * (1 + 1e-9)) << what;
  EXPECT_FALSE(overlap(pair.probe(), pair.fixed(), Transform(s.separated), Doubt::exact)) << what;
  std::printf("  %-44s %10.3g %10.2g %10.2g\n", what.c_str(), reference, above / reference,
              s.lower_bound.value_or(0) / reference);
  return s;
}

}  // namespace sonde::test
