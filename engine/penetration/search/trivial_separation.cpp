// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/trivial_separation.hpp"

#include "engine/penetration/descent/result.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

constexpr double largest_rounding = 0.01;  // share of the probe's radius

bool is_too_large(const Body& probe, double rounding) {
  return !(rounding <= largest_rounding * probe.mass.radius);
}

/// Whether the probe's ball about its centre of mass is clear of the box around the fixed body.
bool ball_is_clear(const Body& probe, const Body& fixed, const Transform& X, double rounding) {
  const Vec3 com = X * probe.mass.com;
  const Vec3 nearest = com.cwiseMax(fixed.tree.low).cwiseMin(fixed.tree.high);
  return (com - nearest).stableNorm() > probe.mass.radius + rounding;
}

}  // namespace

bool is_rough(const Body& probe, const Body& fixed, const Vec3& farthest) noexcept {
  return is_too_large(probe, rounding_guard(extent(probe), extent(fixed), farthest));
}

FreeTest test_free(const Body& probe, const Body& fixed, const Pose& X_FM) {
  if (const char* fault = fault_of(X_FM)) return {.fault = fault};
  // This test does not use the trees: if rounding is as large as a body, all boxes overlap.
  const double rounding = rounding_guard(extent(probe), extent(fixed), X_FM.p);
  const Transform X(X_FM);
  if (ball_is_clear(probe, fixed, X, rounding)) return {.free = true};
  if (is_too_large(probe, rounding))
    return {.fault = "too far from the origin for the size of the probe"};
  return {.free = !overlap(probe, fixed, X, Doubt::exact)};
}

std::optional<Separation> trivial_separation(const Body& probe, const Body& fixed,
                                             const Pose& X_FM) {
  const FreeTest test = test_free(probe, fixed, X_FM);
  if (test.fault) return failed(X_FM, test.fault);
  if (test.free) return separated_at(X_FM);
  return std::nullopt;
}

}  // namespace sonde
