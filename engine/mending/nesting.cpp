// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/nesting.hpp"

#include <algorithm>
#include <array>

#include "engine/base/progress.hpp"

namespace sonde {
namespace {

/// Number of sample points on a part. A part is nested in another if all of them lie inside it, and
/// its bounds within the other's. If parts cross, this may be wrong; a part wrongly taken as nested
/// keeps the orientation of the file.
constexpr std::size_t samples = 64;
/// Share of a part's size: tolerance of the test that its bounds are within another's.
constexpr double bounds_rounding = 1e-6;
/// Share of the way through a part, from a face on: how far inside it the points lie that tell what
/// its faces cannot, since they lie on another's. More than the rounding of files; walls that are
/// thinner would not be noticed.
constexpr double below_faces = 1e-4;
/// Where in a triangle a point is taken below it, as shares of its corners: within, and by each of
/// its corners. They are uneven, since middles lie on the diagonals of faces with the same middle,
/// where rounding decides what a line meets.
constexpr double within_triangle[3] = {0.4181, 0.3319, 0.25};
constexpr double by_corner[3] = {0.0317, 0.9242, 0.0441};

/// Calls use(triangle, part, triangles of that part) for triangles spread over those of each part.
template <class Use>
void each_sample(const Sealed& sealed, std::size_t parts, Use use) {
  std::vector<std::size_t> count(parts, 0), seen(parts, 0);
  for (const std::uint32_t p : sealed.part) ++count[p];
  for (std::size_t i = 0; i < sealed.part.size(); ++i) {
    const std::uint32_t p = sealed.part[i];
    const std::size_t k = seen[p]++, stride = std::max<std::size_t>(1, count[p] / samples);
    if (k % stride == 0 && k / stride < samples) use(sealed.soup.triangles[i], p, count[p]);
  }
}

/// Centroids of triangles.
std::vector<PartPoint> sample_points(const Sealed& sealed, std::size_t parts) {
  std::vector<PartPoint> points;
  const auto& x = sealed.soup.vertices;
  each_sample(sealed, parts, [&](const Triangle& t, std::uint32_t p, std::size_t) {
    points.push_back({(x[t[0]] + x[t[1]] + x[t[2]]) / 3, p});
  });
  return points;
}

/// Points within triangles, and of parts with few of them also points by their corners, which tell
/// what else is on a face.
std::vector<PartPoint> uneven_points(const Sealed& sealed, std::size_t parts) {
  std::vector<PartPoint> points;
  const auto& x = sealed.soup.vertices;
  each_sample(sealed, parts, [&](const Triangle& t, std::uint32_t p, std::size_t count) {
    const auto add = [&](const double* share, std::size_t first) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k) sum += share[k] * x[t[(first + k) % 3]];
      points.push_back({sum, p});
    };
    add(within_triangle, 0);
    if (count > samples) return;
    for (std::size_t k = 0; k < 3; ++k) add(by_corner, k);
  });
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

bool Nesting::Samples::all_inside(std::uint32_t q) const {
  const auto found = inside.find(q);
  return all > 0 && found != inside.end() && found->second == all;
}

/// By part, of points and what is around each.
std::vector<Nesting::Samples> Nesting::samples_of(const std::vector<PartPoint>& points,
                                                  const std::vector<PartWindings>& around,
                                                  std::size_t parts) {
  std::vector<Samples> out(parts);
  for (std::size_t k = 0; k < points.size(); ++k) {
    Samples& own = out[points[k].part];
    bool any = false;
    for (const auto& [part, winding] : around[k])
      if (part != points[k].part) ++own.inside[part], any = true;
    ++own.all;
    own.covered += any;
  }
  return out;
}

Nesting::Nesting(const Sealed& sealed, const std::vector<PartFacts>& facts,
                 const Progress& progress)
    : bounds_(bounds_of(sealed, facts.size())),
      filled_(facts.size(), false),
      around_(facts.size()) {
  const std::size_t parts = facts.size();
  const std::vector<PartPoint> points = sample_points(sealed, parts);
  on_faces_ = samples_of(points, part_windings(sealed, points, part_of(progress, 0, 0.3)), parts);
  const std::vector<PartPoint> below =
      points_within(sealed, uneven_points(sealed, parts), below_faces, part_of(progress, 0.3, 0.6));
  std::vector<PartWindings> around = part_windings(sealed, below, part_of(progress, 0.6, 1));
  // What is there both ways round is as much a body as a pocket, and then fills it.
  for (std::size_t k = 0; k < below.size(); ++k)
    if (facts[below[k].part].both_ways)
      std::erase_if(around[k], [&](const auto& found) { return !facts[found.first].both_ways; });
  below_ = samples_of(below, around, parts);
  find_filled(below, around, facts);
  for (std::size_t p = 0; p < parts; ++p)
    for (const std::vector<Samples>* samples : {&on_faces_, &below_})
      for (const auto& [q, count] : (*samples)[p].inside) around_[p].insert(q);
}

bool Nesting::is_in(std::uint32_t p, std::uint32_t q) const {
  const Vec3 rounding = Vec3::Constant(bounds_rounding * bounds_[p].sizes().maxCoeff());
  return (on_faces_[p].all_inside(q) ||
          (below_[p].all_inside(q) && !below_[q].all_inside(p) && !filled_[q])) &&
         (bounds_[p].min() + rounding - bounds_[q].min()).minCoeff() >= 0 &&
         (bounds_[q].max() + rounding - bounds_[p].max()).minCoeff() >= 0;
}

bool Nesting::has_faces_in_several(std::uint32_t p) const {
  return on_faces_[p].inside.size() > 1 && on_faces_[p].all_covered();
}

bool Nesting::is_in_several(std::uint32_t p) const {
  if (has_faces_in_several(p)) return true;
  return below_[p].inside.size() > 1 && below_[p].all_covered() &&
         std::ranges::any_of(below_[p].inside, [&](const auto& q) {
           return !below_[q.first].all_inside(p);  // they are not just what it is
         });
}

bool Nesting::is_outermost(std::uint32_t q, std::uint32_t but) const {
  const auto others =
      std::ranges::count_if(around_[q], [&](std::uint32_t further) { return further != but; });
  return (others < 2 || !is_in_several(q)) &&
         std::ranges::none_of(around_[q], [&](std::uint32_t further) {
           return further != but && is_in(q, further);
         });
}

/// Finds parts that others in them, the other way round, leave nothing of: these are no cavities
/// but the same body again.
void Nesting::find_filled(const std::vector<PartPoint>& below,
                          const std::vector<PartWindings>& around,
                          const std::vector<PartFacts>& facts) {
  for (std::size_t q = 0; q < filled_.size(); ++q) filled_[q] = below_[q].all_covered();
  for (std::size_t k = 0; k < below.size(); ++k) {
    const std::uint32_t q = below[k].part;
    filled_[q] =
        filled_[q] && std::ranges::any_of(around[k], [&](const auto& found) {
          const std::uint32_t p = found.first;
          return p != q && facts[p].volume * facts[q].volume < 0 && below_[p].all_inside(q);
        });
  }
}

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
  const Nesting nesting(sealed, facts, progress);
  // Nested in several parts together, as a cavity across two halves: if one of the halves is
  // mirrored and the other is not, it must still be a cavity. With faces on theirs it may also be a
  // body among bodies, and is what the file says.
  const auto turns_with_all = [&](std::uint32_t p) {
    bool any_over = false, any_not = false;
    for (const std::uint32_t q : nesting.around(p))
      if (nesting.is_outermost(q, p)) (facts[q].volume < 0 ? any_over : any_not) = true;
    return any_over && any_not   ? facts[p].volume > 0 && nesting.has_faces_in_several(p)
           : any_over || any_not ? any_over
                                 : facts[p].volume < 0;
  };
  // The outermost part around each part: it contains the part and is not nested itself.
  for (std::uint32_t p = 0; p < facts.size(); ++p) {
    if (!solid[p]) continue;
    const auto around_it = std::ranges::find_if(nesting.around(p), [&](std::uint32_t q) {
      return nesting.is_in(p, q) && nesting.is_outermost(q, p);
    });
    if (around_it != nesting.around(p).end())
      turn[p] = facts[*around_it].volume < 0;
    else if (nesting.is_in_several(p))
      turn[p] = turns_with_all(p);
    else
      turn[p] = facts[p].volume < 0;
  }
  return turn;
}

}  // namespace sonde
