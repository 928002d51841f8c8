// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/clash.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <tuple>

#include "engine/base/threads.hpp"
#include "engine/penetration/search/clearance_of.hpp"
#include "engine/penetration/search/pose_seed.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/violation.hpp"
#include "engine/study/assembly/box_pairs.hpp"
#include "engine/study/assembly/fit.hpp"

namespace sonde {
namespace {

/// Allowances: parts of which a lower bound says that they overlap by so much are not asked whether
/// they fit. Where the sides of a corner stand out by the allowance, the corner does by more: by √3
/// of it, if they are square to each other.
constexpr double plainly_more = 4;

/// The box of a part in the world, larger on every side by a margin.
AxisBox box_of(const AssemblyPart& part, double margin) {
  const Transform X(part.X_WM);
  AxisBox out{Vec3::Constant(std::numeric_limits<double>::infinity()),
              Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (const Vec3& x : surface(*part.body).vertices) {
    out.low = out.low.cwiseMin(X * x);
    out.high = out.high.cwiseMax(X * x);
  }
  // Adds the rounding of the placing, so that no pair is missed because of it.
  const double more = margin + rounding_guard(extent(*part.body), 0, part.X_WM.p);
  return {out.low - Vec3::Constant(more), out.high + Vec3::Constant(more)};
}

/// The centroid of the contacts, weighted by their multipliers, in the fixed frame.
std::optional<Vec3> middle_of(const ContactSet& contacts) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (const Contact& c : contacts) {
    sum += c.multiplier * c.on_fixed;
    weight += c.multiplier;
  }
  if (!(weight > 0)) return std::nullopt;
  return sum / weight;
}

/// A point in the middle of where triangles touch, in the fixed frame: where two parts touch in an
/// area, no contact need hold the way out.
std::optional<Vec3> middle_of_touching(const Body& probe, const Body& fixed, const Pose& X_FM,
                                       double touching) {
  std::vector<Violation> found(256);  // a place to look at needs no more of them
  Effort unlimited;
  const Transform X(X_FM);
  found.resize(find_violations(probe, fixed, X, touching, found, unlimited));
  if (found.empty()) return std::nullopt;
  std::vector<Vec3> at;
  Vec3 sum = Vec3::Zero();
  for (const Violation& v : found) {
    const ClosestPoints points = closest_points(place(X, corners(surface(probe), v.triangle_a)),
                                                corners(surface(fixed), v.triangle_b));
    sum += at.emplace_back(0.5 * (points.a + points.b));
  }
  // The middle of a ring would be where nothing is.
  const Vec3 middle = sum / static_cast<double>(at.size());
  return *std::ranges::min_element(at, {},
                                   [&](const Vec3& x) { return (x - middle).squaredNorm(); });
}

/// The depth of the probe moved into contact. A separated pose keeps a clearance of 1e-4 of the
/// depth; the correction is of first order in that, since λ is the derivative of σ/2 with respect
/// to a gap.
double without_gaps(const Separation& found) {
  double less = 0;
  for (const Contact& c : found.contacts) less += c.multiplier * std::max(0.0, c.gap);
  if (!(found.depth > 0) || !found.converged) return found.depth;
  return std::clamp(found.depth - less / found.depth, found.lower_bound.value_or(0), found.depth);
}

/// A depth above the allowance may be the way out of a fit.
void judge_fit(Clash& out, Fits::Answer answer, bool allowance_asked) {
  out.fit = answer == Fits::Answer::fit;
  if (out.fit) out.kind = Clash::Kind::touching;
  if (answer == Fits::Answer::unknown && allowance_asked)
    out.reason =
        "the overlap was not compared with the allowance: neither part can be taken smaller by it "
        "(too thin, or a surface)";
}

/// The smaller of the two parts is the probe: it is the one that a person would move.
Clash clash_of(const std::vector<AssemblyPart>& parts, std::array<std::size_t, 2> pair,
               const ClashOptions& options, Fits& fits) {
  Clash out;
  out.parts = pair;
  const bool second = parts[pair[1]].body->mass.radius < parts[pair[0]].body->mass.radius;
  out.moved = pair[second ? 1 : 0];
  const AssemblyPart &probe = parts[out.moved], &fixed = parts[pair[second ? 0 : 1]];
  const Pose X_FM = inverse(fixed.X_WM) * probe.X_WM;
  const double rounding = rounding_guard(extent(*probe.body), extent(*fixed.body), X_FM.p);
  const double touching = std::max(options.allowance, 4 * rounding);

  const FreeTest test = test_free(*probe.body, *fixed.body, X_FM);
  if (test.fault) {
    out.reason = test.fault;
    return out;
  }
  if (test.free) {
    const Clearance clearance = clearance_of(*probe.body, *fixed.body, X_FM, false);
    out.clearance = clearance.distance;
    out.place = fixed.X_WM * Vec3(0.5 * (clearance.on_probe + clearance.on_fixed));
    out.kind = clearance.distance <= touching ? Clash::Kind::touching : Clash::Kind::clear;
    return out;
  }
  StaticOptions search = options.search;
  search.seed = seed_of_pose(options.search.seed, X_FM);
  const Separation found = separate_static(Pair(probe.body, fixed.body), X_FM, search);
  if (found.status == Status::failed) {
    out.reason = found.reason;
    return out;
  }
  out.depth = without_gaps(found);
  out.lower_bound = found.lower_bound;
  out.separated = fixed.X_WM * found.separated;
  auto middle = middle_of(found.contacts);
  if (!middle) middle = middle_of_touching(*probe.body, *fixed.body, X_FM, touching);
  if (middle) out.place = fixed.X_WM * *middle;
  out.kind = found.depth <= touching ? Clash::Kind::touching : Clash::Kind::overlapping;
  if (out.kind == Clash::Kind::overlapping &&
      !(found.lower_bound.value_or(0) > plainly_more * touching))
    judge_fit(out, fits.ask(*probe.body, *fixed.body, X_FM, touching), options.allowance > 0);
  return out;
}

}  // namespace

const char* name_of(Clash::Kind kind) {
  switch (kind) {
    case Clash::Kind::overlapping:
      return "overlapping";
    case Clash::Kind::touching:
      return "touching";
    case Clash::Kind::clear:
      return "clear";
    case Clash::Kind::failed:
      break;
  }
  return "failed";
}

std::vector<Clash> clashes(const std::vector<AssemblyPart>& parts, const ClashOptions& options,
                           const Progress& progress) {
  std::vector<AxisBox> boxes;
  boxes.reserve(parts.size());
  const double margin = 0.5 * std::max(options.within, options.allowance);
  for (const AssemblyPart& part : parts) boxes.push_back(box_of(part, margin));
  const auto pairs = pairs_that_meet(boxes);
  report(progress, 0);

  Fits fits;
  std::vector<Clash> all;
  all.reserve(pairs.size());
  std::size_t done = 0;
  run_in_order(
      pairs.size(), options.threads,
      [&](std::size_t i) { return clash_of(parts, pairs[i], options, fits); },
      [&](std::size_t, const Clash& clash) {
        all.push_back(clash);
        report(progress, static_cast<double>(++done) / static_cast<double>(pairs.size()));
      });
  std::erase_if(all, [&](const Clash& clash) {
    return clash.kind == Clash::Kind::clear && *clash.clearance > options.within;
  });
  std::ranges::stable_sort(all, {}, [](const Clash& clash) {
    return std::tuple(clash.kind == Clash::Kind::failed ? -1 : static_cast<int>(clash.kind),
                      -clash.depth.value_or(0), clash.clearance.value_or(0));
  });
  return all;
}

}  // namespace sonde
