// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/wrench_derivative.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/sensitivity/facing_features.hpp"
#include "engine/penetration/sensitivity/local_optimum.hpp"
#include "engine/proximity/queries/near_pairs.hpp"

namespace sonde {
namespace {

/// Clearances: features further apart do not touch. (A search leaves one at the most.)
constexpr double reach_of_clearance = 4;
/// Of the depth: the exact optimum is no further from Q. (The residual of a search is 1e-4.)
constexpr double most_off = 5e-3;
constexpr std::size_t most_pairs = 256;

WrenchDerivative without(const char* reason) {
  WrenchDerivative out;
  out.reason = reason;
  return out;
}

/// False where there are more pairs than there is room for.
bool add_near(const Body& probe, const Body& fixed, const Transform& X, double reach,
              FacingFeatures& features) noexcept {
  std::array<NearPair, most_pairs> pairs;
  const NearPairs near = near_pairs(probe, fixed, X, reach, pairs);
  for (std::size_t i = 0; i < near.count; ++i)
    features.add_pair(pairs[i].triangle_a, pairs[i].triangle_b, pairs[i].normal);
  return near.reach >= reach;
}

}  // namespace

WrenchDerivative wrench_derivative(const Pair& pair, const Separation& now,
                                   Neighbours neighbours) noexcept {
  if (now.status == Status::failed) return without("there is no separation");
  WrenchDerivative out;
  if (now.status == Status::separated) {
    out.sides = WrenchDerivative::Sides::all;
    return out;
  }
  if (!now.converged) return without("the search has not converged");
  const Body &probe = pair.probe(), &fixed = pair.fixed();
  const double clearance = allowed_clearance(probe.mass.radius, now.depth),
               reach = reach_of_clearance * clearance;
  const Transform X(now.separated);
  FacingFeatures features(probe, fixed, X, reach);
  const double most = std::max(most_off * now.depth, reach);
  std::optional<LocalOptimum> optimum;
  const auto settles = [&] {
    if (features.overflowed()) return false;
    optimum.emplace(probe.mass, now.device, now.separated, features.rows());
    return optimum->settle(most);
  };
  bool named = true;
  for (const Contact& c : now.contacts)
    named = features.add_around(c.on_probe, c.on_fixed, c.normal) > 0 && named;
  if (neighbours == Neighbours::all && !add_near(probe, fixed, X, reach, features))
    return without("there are too many contacts");
  if (!named || !settles()) {
    for (const Contact& c : now.contacts) features.add_hollow(c.on_probe, c.on_fixed, c.normal);
    if (features.overflowed()) return without("there are too many contacts");
    if (!settles()) return without("the contacts found do not hold the probe");
  }
  const int weak = optimum->find_weak(1e-4 * now.depth, clearance);
  out.rows = optimum->active();
  LocalOptimum::Mat6 left, held;
  if (!optimum->derivative(false, left)) return without("the optimum is not strict");
  held = left;
  if (weak > 0 && !optimum->derivative(true, held)) return without("the optimum is not strict");
  out.sides = weak > 0 ? WrenchDerivative::Sides::two : WrenchDerivative::Sides::all;
  if (weak > 0) out.reason = "a contact is about to begin or to end";
  out.d_depth = -optimum->wrench() / optimum->depth();
  out.d_wrench = left;
  out.d_wrench_held = held;
  out.leaves = optimum->weak_gap_rate();
  return out;
}

}  // namespace sonde
