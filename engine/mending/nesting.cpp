// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/nesting.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "engine/base/progress.hpp"
#include "engine/mending/point_windings.hpp"

namespace sonde {
namespace {

/// Number of sample points on a part. A part is nested in another if all of them lie inside it, and
/// its bounds within the other's. If parts cross, this may be wrong; a part wrongly taken as nested
/// keeps the orientation of the file.
constexpr std::size_t samples = 64;
/// Share of a part's size: tolerance of the test that its bounds are within another's.
constexpr double bounds_rounding = 1e-6;

/// Centroids of triangles, spread over those of a part.
std::vector<PartPoint> sample_points(const Sealed& sealed, const std::vector<PartFacts>& facts) {
  std::vector<std::size_t> count(facts.size(), 0), seen(facts.size(), 0);
  for (const std::uint32_t p : sealed.part) ++count[p];
  std::vector<PartPoint> points;
  const auto& x = sealed.soup.vertices;
  for (std::size_t i = 0; i < sealed.part.size(); ++i) {
    const std::uint32_t p = sealed.part[i];
    const std::size_t k = seen[p]++, stride = std::max<std::size_t>(1, count[p] / samples);
    if (k % stride != 0 || k / stride >= samples) continue;
    const Triangle& t = sealed.soup.triangles[i];
    points.push_back({(x[t[0]] + x[t[1]] + x[t[2]]) / 3, p});
  }
  return points;
}

std::vector<Eigen::AlignedBox3d> bounds_of(const Sealed& sealed, std::size_t parts) {
  std::vector<Eigen::AlignedBox3d> bounds(parts);
  for (std::size_t i = 0; i < sealed.part.size(); ++i)
    for (const std::uint32_t corner : sealed.soup.triangles[i])
      bounds[sealed.part[i]].extend(sealed.soup.vertices[corner]);
  return bounds;
}

}  // namespace

std::vector<bool> parts_to_turn(const Sealed& sealed, const std::vector<PartFacts>& facts,
                                const std::vector<bool>& solid, const Progress& progress) {
  std::vector<bool> turn(facts.size(), false);
  std::size_t solids = 0, negative = 0;
  for (std::size_t p = 0; p < facts.size(); ++p)
    if (solid[p]) {
      ++solids;
      negative += facts[p].volume < 0;
    }
  if (negative == 0) return turn;
  if (solids == 1) {
    for (std::size_t p = 0; p < facts.size(); ++p) turn[p] = solid[p];
    return turn;
  }
  const std::vector<PartPoint> points = sample_points(sealed, facts);
  const std::vector<PartWindings> around = part_windings(sealed, points, progress);
  // For each part: how many of its points were tested, and how many lie inside which others, and
  // inside any other.
  std::vector<std::map<std::uint32_t, std::size_t>> inside(facts.size());
  std::vector<std::size_t> asked(facts.size(), 0), covered(facts.size(), 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::uint32_t p = points[k].part;
    bool any = false;
    ++asked[p];
    for (const auto& [part, winding] : around[k])
      if (winding != 0 && part != p) ++inside[p][part], any = true;
    covered[p] += any;
  }
  const std::vector<Eigen::AlignedBox3d> bounds = bounds_of(sealed, facts.size());
  const auto nested_in = [&](std::uint32_t p, std::uint32_t q) {
    const Vec3 rounding = Vec3::Constant(bounds_rounding * bounds[p].sizes().maxCoeff());
    const auto found = inside[p].find(q);
    return found != inside[p].end() && found->second == asked[p] &&
           (bounds[p].min() + rounding - bounds[q].min()).minCoeff() >= 0 &&
           (bounds[q].max() + rounding - bounds[p].max()).minCoeff() >= 0;
  };
  const auto is_outermost = [&](std::uint32_t q, std::uint32_t but) {
    const auto others =
        std::ranges::count_if(inside[q], [&](const auto& further) { return further.first != but; });
    return (others < 2 || covered[q] < asked[q]) &&
           std::ranges::none_of(inside[q], [&](const auto& further) {
             return further.first != but && nested_in(q, further.first);
           });
  };
  // Nested in several parts together, as a cavity across two halves: if one of the halves is
  // mirrored and the other is not, it must still be a cavity.
  const auto turns_with_all = [&](std::uint32_t p) {
    bool any_over = false, any_not = false;
    for (const auto& [q, count] : inside[p])
      if (is_outermost(q, p)) (facts[q].volume < 0 ? any_over : any_not) = true;
    return any_over && any_not   ? facts[p].volume > 0
           : any_over || any_not ? any_over
                                 : facts[p].volume < 0;
  };
  // The outermost part around each part: it contains the part and is not nested itself.
  for (std::uint32_t p = 0; p < facts.size(); ++p) {
    if (!solid[p]) continue;
    const auto around_it = std::ranges::find_if(inside[p], [&](const auto& found) {
      return nested_in(p, found.first) && is_outermost(found.first, p);
    });
    if (around_it != inside[p].end())
      turn[p] = facts[around_it->first].volume < 0;
    else if (inside[p].size() > 1 && covered[p] == asked[p])
      turn[p] = turns_with_all(p);
    else
      turn[p] = facts[p].volume < 0;
  }
  return turn;
}

}  // namespace sonde
