// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/wrench_derivative.hpp"

#include <algorithm>
#include <array>

#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/free_region.hpp"
#include "engine/penetration/sensitivity/exact_optimum.hpp"
#include "engine/penetration/sensitivity/facing_features.hpp"
#include "engine/proximity/queries/near_pairs.hpp"

namespace sonde {
namespace {

/// Clearances: features further apart do not touch. (A search leaves at most one.)
constexpr double reach_of_clearance = 4;
/// Share of the depth: largest distance of the exact optimum from Q. (A search has a residual of
/// 1e-4.)
constexpr double most_off = 5e-3;
constexpr std::size_t most_pairs = 1024;
/// Maximum number of further searches for features, each from the pose found by the last one.
constexpr int most_looks = 2;
/// Share of the depth: a contact with a smaller multiplier may break under any small motion.
constexpr double weak_push = 1e-4;

constexpr const char* too_many = "there are too many contacts";

WrenchDerivative without(const char* reason) {
  WrenchDerivative out;
  out.reason = reason;
  return out;
}

/// The exact optimum, and the features that it refers to. (60 KB that must not be zeroed, as g++ 12
/// does with an empty std::optional.)
struct Place {
  Place(const Pair& pair, const Pose& X_FO) noexcept
      : features(pair.probe(), pair.fixed()), optimum(pair.probe().mass, X_FO) {}
  FacingFeatures features;
  ExactOptimum optimum;
};

/// Finds the exact optimum near a separation.
class OptimumFinder {
 public:
  OptimumFinder(const Pair& pair, const Separation& now, Neighbours neighbours) noexcept
      : probe_(pair.probe()),
        fixed_(pair.fixed()),
        now_(now),
        neighbours_(neighbours),
        clearance_(allowed_clearance(probe_.mass.radius, now.depth)) {}

  /// Returns null, or the reason why there is no optimum.
  const char* find(Place& place) const noexcept {
    const double reach = reach_of_clearance * clearance_;
    Look look{now_.separated, now_.contacts, reach, Where::at_contacts};
    const char* problem = find_from_either(look, place);
    // After a longer move, other features may face each other.
    for (int round = 0; !problem && moved(look.from, place.optimum) > reach; ++round) {
      if (round == most_looks) return "the search ended too far from an optimum";
      look = {place.optimum.pose(), place.optimum.contacts(), reach, Where::at_contacts};
      problem = find_from_either(look, place);
    }
    if (problem || neighbours_ == Neighbours::of_contacts) return problem;
    // The probe has moved nearer to other features, which may hold it as well. They are searched
    // for from the separated pose, which is free.
    const double far = moved(now_.separated, place.optimum);
    if (!(far > clearance_)) return nullptr;
    look = {now_.separated, now_.contacts, reach + far, look.where};
    return find_from(look, place);
  }
  double clearance() const { return clearance_; }

 private:
  enum class Where { at_contacts, in_hollows };
  struct Look {
    Pose from;
    ContactSet contacts;
    double reach;  ///< m
    Where where;
  };

  /// m: upper bound of the displacement of any point of the probe.
  double moved(const Pose& from, const ExactOptimum& optimum) const noexcept {
    return farthest_move(probe_.mass, from, optimum.pose());
  }
  const char* find_from_either(Look& look, Place& place) const noexcept {
    const char* problem = find_from(look, place);
    if (!problem || problem == too_many) return problem;
    look.where = Where::in_hollows;
    return find_from(look, place);
  }
  const char* find_from(const Look& look, Place& place) const noexcept {
    FacingFeatures& features = place.features;
    features.begin(Transform(look.from), look.reach);
    for (const Contact& c : look.contacts) {
      features.add_around(c.on_probe, c.on_fixed, c.normal);
      if (look.where == Where::in_hollows) features.add_hollow(c.on_probe, c.on_fixed, c.normal);
    }
    if (neighbours_ == Neighbours::all && !add_near(look, features)) return too_many;
    if (features.overflowed()) return too_many;
    place.optimum.begin(look.from, features.rows());
    const double most = std::max(most_off * now_.depth, reach_of_clearance * clearance_);
    return place.optimum.move_to_optimum(most) ? nullptr
                                               : "the contacts found do not hold the probe";
  }

  /// Returns false if there are more pairs than there is room for.
  bool add_near(const Look& look, FacingFeatures& features) const noexcept {
    std::array<NearPair, most_pairs> pairs;
    const NearPairs near = near_pairs(probe_, fixed_, Transform(look.from), look.reach, pairs);
    for (std::size_t i = 0; i < near.count; ++i)
      features.add_pair(pairs[i].triangle_a, pairs[i].triangle_b, pairs[i].normal);
    return near.reach >= look.reach;
  }

  const Body &probe_, &fixed_;
  const Separation& now_;
  Neighbours neighbours_;
  double clearance_;  ///< m: largest clearance that a search leaves
};

}  // namespace

WrenchDerivative wrench_derivative(const Pair& pair, const Separation& now,
                                   Neighbours neighbours) noexcept {
  const RoundToNearest round_to_nearest;
  if (now.status == Status::failed) return without("there is no separation");
  WrenchDerivative out;
  if (now.status == Status::separated) {
    out.sides = WrenchDerivative::Sides::all;
    out.d_separated.setIdentity();
    return out;
  }
  if (!now.converged) return without("the search has not converged");
  const OptimumFinder finder(pair, now, neighbours);
  if (!(now.depth > finder.clearance())) return without("the probe only touches");
  Place place(pair, now.device);
  if (const char* problem = finder.find(place)) return without(problem);
  ExactOptimum& optimum = place.optimum;
  const int weak = optimum.find_weak(weak_push * now.depth, finder.clearance());
  ExactOptimum::Change left, held;
  const bool strict =
      optimum.derivative(false, left) && (weak == 0 || optimum.derivative(true, held));
  if (!strict) return without("the optimum is not strict");
  out.sides = weak > 0 ? WrenchDerivative::Sides::two : WrenchDerivative::Sides::all;
  if (weak > 0) out.reason = "a contact is about to begin or to end";
  out.rows = left.held;
  out.d_depth = -optimum.wrench() / optimum.depth();
  out.d_separated = left.separated;
  out.d_wrench = left.wrench;
  out.d_wrench_held = weak > 0 ? held.wrench : left.wrench;
  out.leaves = optimum.weak_gap_rate(left);
  return out;
}

}  // namespace sonde
