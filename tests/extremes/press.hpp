// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "engine/geometry/transform.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {

/// A box of 0.1 × 0.08 × 0.06, flat in a plate of 2 × 2 × 1.
inline const Vec3 brick(0.1, 0.08, 0.06), plate(2, 2, 1);

/// The brick flat in the plate's top face, so deep, all lengths times `scale`.
inline Pose flat_in_plate(double deep, double scale = 1) {
  return {Quat::Identity(), scale * Vec3(0.02, -0.01, 0.5 + 0.03 - deep)};
}

inline PolygonSoup scaled(PolygonSoup soup, double scale, const Vec3& offset = Vec3::Zero()) {
  for (Vec3& x : soup.points) x = scale * x + offset;
  return soup;
}

/// Brick and plate, all lengths times `size`.
inline Pair brick_and_plate(double size = 1) {
  return {body(scaled(box(brick), size)), body(scaled(box(plate), size))};
}

/// A line of the table in resources/docs/understand/extremes.md: relative to the reference, how far
/// above it the depth is, and the lower bound.
inline void print_line(const std::string& what, double reference, double above,
                       std::optional<double> bound) {
  std::printf("  %-44s %10.3g %10.2g", what.c_str(), reference, above / reference);
  if (bound)
    std::printf(" %10.2g\n", *bound / reference);
  else
    std::printf("       none\n");
}

/// What a depth that is known by hand to lie between two values allows of an answer: beyond the
/// clearance that it may keep, it is off by no more than 1e-6; the bound is not above; and the pose
/// is free by the exact test. `rounding` is what the reference itself is worth, m. Prints the line
/// of the table.
inline void expect_answer(const std::string& what, const Pair& pair, const Separation& s,
                          double least, double most, double rounding = 0) {
  ASSERT_EQ(s.status, Status::penetrating) << what << ": " << s.reason;
  ASSERT_TRUE(std::isfinite(s.depth)) << what;
  const double clearance = promised_clearance(pair.probe().mass.radius, most);
  EXPECT_GE(s.depth, least * (1 - 1e-6) - rounding) << what;
  EXPECT_LE(s.depth, most * (1 + 1e-6) + clearance + rounding) << what;
  EXPECT_LE(s.lower_bound.value_or(0), most * (1 + 1e-9) + rounding) << what;
  EXPECT_FALSE(overlap(pair.probe(), pair.fixed(), Transform(s.separated), Doubt::exact)) << what;
  print_line(what, most, s.depth - most, s.lower_bound);
}

/// Searches by translation alone.
inline Separation translate(const Pair& pair, const Pose& X_FM) {
  StaticOptions options;
  options.method = Method::pdt;
  return separate_static(pair, X_FM, options);
}

/// Searches, with all six degrees and by translation alone, and compares with a depth that is known
/// by hand and needs no turn.
inline void expect_depth(const std::string& what, const Pair& pair, const Pose& X_FM,
                         double reference) {
  expect_answer(what, pair, separate_static(pair, X_FM), reference, reference);
  expect_answer(what + ", PD_t", pair, translate(pair, X_FM), reference, reference);
}

/// The same with one that is known to lie between two values.
inline void expect_between(const std::string& what, const Pair& pair, const Pose& X_FM,
                           double least, double most) {
  expect_answer(what, pair, separate_static(pair, X_FM), least, most);
}

}  // namespace sonde::test
