// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/move_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "engine/base/ordering.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/offset/corner_planes.hpp"
#include "engine/offset/flat_regions.hpp"

namespace sonde {
namespace {

/// Each round joins what the round before has brought together.
constexpr int most_rounds = 64;

/// Places of corners.
class Mover {
 public:
  Mover(const Soup& soup, const Fans& fans, double by, double rounding, const Progress& progress)
      : soup_(soup),
        fans_(fans),
        planes_(soup, fans, by, rounding, progress),
        way_(planes_.way()),
        sign_(planes_.sign()),
        normal_(planes_.normals()),
        has_say_(planes_.have_say()),
        groups_(fans.count()),
        turned_over_(soup.triangles.size(), false),
        folded_(soup.triangles.size(), false) {
    out_.offset.by = by;
    out_.offset.least = way_;
  }

  MovedFaces run(const Progress& progress) {
    place_.resize(fans_.count());
    for_each_index(fans_.count(), part_of(progress, 0, 0.5), [&](std::size_t fan) {
      place_[fan] = at(fans_.vertex[fan]) + planes_.way_of(std::uint32_t(fan));
    });
    for (int round = 0; round < most_rounds && join_overtaken(); ++round)
      report(progress, 0.5 + 0.4 * round / most_rounds);
    measure();
    assemble();
    report(progress, 1);
    return std::move(out_);
  }

 private:
  const Vec3& at(std::uint32_t vertex) const { return soup_.vertices[vertex]; }
  const Vec3& corner(std::size_t t, std::size_t k) const { return at(soup_.triangles[t][k]); }
  bool is_gone(std::size_t t, Sets& groups) const {
    const auto& f = fans_.of[t];
    const std::uint32_t a = groups.of(f[0]), b = groups.of(f[1]), c = groups.of(f[2]);
    return a == b || b == c || c == a;
  }
  const Vec3& placed(std::size_t t, std::size_t k) {
    return place_[groups_.of(fans_.of[t][k % 3])];
  }
  /// Looks the other way, or is turned by half a turn: through the middle of a body.
  bool is_turned_over(std::size_t t) {
    const Vec3 v = (placed(t, 1) - placed(t, 0)).cross(placed(t, 2) - placed(t, 0));
    if (!(v.dot(normal_[t]) > 0)) return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (!is_reversed(t, k)) return false;
    return true;
  }
  bool is_reversed(std::size_t t, std::size_t k) {
    const Vec3 side = corner(t, (k + 1) % 3) - corner(t, k);
    return !((placed(t, k + 1) - placed(t, k)).dot(side) > 0);
  }

  std::vector<std::uint32_t> all_turned_over() {
    std::vector<std::uint32_t> over;
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t)
      if (has_say_[t] && !is_gone(t, groups_) && is_turned_over(t)) over.push_back(t);
    if (!over.empty() && !regions_) regions_.emplace(fans_, normal_, has_say_, planes_.tilts());
    return over;
  }

  /// The flat part of a triangle, filled anew within its outline: how it was cut may not be how it
  /// can be cut now. None where the outline itself has been turned over.
  std::optional<std::vector<std::array<std::uint32_t, 3>>> filled_again(std::uint32_t region) {
    const auto all = regions_->triangles(region);
    if (all.size() < 2) return std::nullopt;
    std::vector<std::array<std::uint32_t, 3>> before, now;
    for (const std::uint32_t t : all) {
      before.push_back(fans_.of[t]);
      now.push_back(fans_.of[t]);
      for (std::uint32_t& fan : now.back()) fan = groups_.of(fan);
    }
    double along = 0;
    for (const auto& [a, b] : outline_of(before))
      along += (place_[groups_.of(b)] - place_[groups_.of(a)])
                   .dot(at(fans_.vertex[b]) - at(fans_.vertex[a]));
    if (!(along > 0)) return std::nullopt;
    return filled(outline_of(now), place_, normal_[all.front()]);
  }

  /// Joins the corners of triangles that are inside out, and finds their places anew. False where
  /// there are none.
  bool join_overtaken() {
    std::vector<std::uint32_t> over = all_turned_over();
    std::map<std::uint32_t, bool> can_be_filled;
    std::erase_if(over, [&](std::uint32_t t) {
      if (turned_over_[t] || folded_[t]) return true;
      const auto [found, is_new] = can_be_filled.emplace(regions_->of(t), false);
      if (is_new) found->second = filled_again(found->first).has_value();
      return found->second;
    });
    while (!over.empty()) {
      Sets joined = groups_;
      std::vector<std::uint32_t> changed;
      for (const std::uint32_t t : over) join_sides(t, joined, changed);
      if (changed.empty()) return false;
      for (std::uint32_t& fan : changed) fan = joined.of(fan);
      ordering::sort(changed);
      changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
      if (move_groups(joined, changed, over)) return true;
    }
    return false;
  }

  /// Those that are the other way round. Where the corners are common points of planes, the sides
  /// keep their directions, so that a face vanishes through some that are; where they are not, a
  /// corner of a flat triangle may go over the side opposite.
  void join_sides(std::uint32_t t, Sets& joined, std::vector<std::uint32_t>& changed) {
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_reversed(t, k)) continue;
      joined.join(fans_.of[t][k], fans_.of[t][(k + 1) % 3]);
      changed.push_back(fans_.of[t][k]);
      any = true;
    }
    if (!any && regions_->triangles(regions_->of(t)).size() == 1) join_or_fold(t, joined, changed);
  }

  /// A small triangle loses its shortest side. A long one is left folded, and the corner that went
  /// over a side has to be far enough from the face that it comes to lie over.
  void join_or_fold(std::uint32_t t, Sets& joined, std::vector<std::uint32_t>& changed) {
    constexpr double small = 4;  // times the way: what corners go as a rule
    const auto length = [&](std::size_t k) {
      return (corner(t, (k + 1) % 3) - corner(t, k)).norm();
    };
    std::size_t longest = 0, shortest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (length(k) > length(longest)) longest = k;
      if (length(k) < length(shortest)) shortest = k;
    }
    if (length(shortest) <= small * way_) {
      joined.join(fans_.of[t][shortest], fans_.of[t][(shortest + 1) % 3]);
      changed.push_back(fans_.of[t][shortest]);
      return;
    }
    folded_[t] = true;
    const std::uint32_t tip = fans_.of[t][(longest + 2) % 3];
    if (const auto other = regions_->across(t, longest)) over_.emplace(tip, *other);
    changed.push_back(tip);
  }

  /// Takes over the groups with their places. Where one has none, its triangles are left turned
  /// over and out of `over`, nothing else has changed, and it returns false.
  bool move_groups(Sets& joined, const std::vector<std::uint32_t>& roots,
                   std::vector<std::uint32_t>& over) {
    std::vector<std::vector<std::uint32_t>> members(roots.size());
    const auto index = [&](std::uint32_t root) {
      return std::size_t(std::ranges::lower_bound(roots, root) - roots.begin());
    };
    for (std::uint32_t fan = 0; fan < fans_.count(); ++fan)
      if (const std::size_t i = index(joined.of(fan));
          i < roots.size() && roots[i] == joined.of(fan))
        members[i].push_back(fan);
    std::vector<Vec3> places;
    std::vector<bool> nowhere(roots.size(), false);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const std::optional<Vec3> place = place_of(members[i]);
      nowhere[i] = !place;
      places.push_back(place.value_or(Vec3::Zero()));
    }
    const std::size_t before = over.size();
    std::erase_if(over, [&](std::uint32_t t) {
      const auto lost = [&](std::uint32_t fan) {
        const std::size_t i = index(joined.of(fan));
        return i < roots.size() && roots[i] == joined.of(fan) && nowhere[i];
      };
      if (!std::ranges::any_of(fans_.of[t], lost)) return false;
      turned_over_[t] = true;
      return true;
    });
    if (over.size() < before) return false;
    groups_ = std::move(joined);
    for (std::size_t i = 0; i < roots.size(); ++i) place_[groups_.of(roots[i])] = places[i];
    return true;
  }

  /// The place of several corners as one: far enough from all their faces, and nearest to the mean
  /// of where they were.
  std::optional<Vec3> place_of(const std::vector<std::uint32_t>& members) {
    Vec3 mean = Vec3::Zero();
    for (const std::uint32_t fan : members) mean += at(fans_.vertex[fan]) / double(members.size());
    std::vector<HalfSpace3> spaces;
    double size = way_;
    for (const std::uint32_t fan : members) {
      const Vec3 from = at(fans_.vertex[fan]) - mean;
      size = std::max(size, from.norm());
      for (const HalfSpace3& plane : planes_.planes_of(fan))
        spaces.push_back({plane.normal, plane.least + plane.normal.dot(from)});
      const auto [begin, end] = over_.equal_range(fan);
      for (auto face = begin; face != end; ++face) {
        const Vec3 normal = sign_ * normal_[face->second];
        spaces.push_back({normal, way_ + normal.dot(corner(face->second, 0) - mean)});
      }
    }
    const std::optional<Vec3> found = nearest_in(spaces, Vec3::Zero(), 1e-12 * size);
    const double most = sign_ > 0 ? most_outward_way : most_inward_way;
    if (!found || found->norm() > most * way_ + size) return std::nullopt;
    return mean + *found;
  }

  /// What could not be done.
  void measure() {
    constexpr double rounding = 10;  // times the tilt of planes that are one: and a long way
    for (std::uint32_t fan = 0; fan < fans_.count(); ++fan) {
      const Vec3 way = place_[groups_.of(fan)] - at(fans_.vertex[fan]);
      out_.offset.furthest = std::max(out_.offset.furthest, way.norm());
      const double exact = 1e-15 * at(fans_.vertex[fan]).cwiseAbs().maxCoeff();
      double least = way_;
      planes_.for_faces(fan, [&](std::uint32_t t) {
        const double along = sign_ * normal_[t].dot(way);
        if (along < way_ * (1 - rounding * planes_.tilts()[t]) - exact)
          least = std::min(least, along);
      });
      if (least == way_) continue;
      ++out_.offset.held_back;
      out_.offset.least = std::min(out_.offset.least, least);
    }
  }

  void assemble() {
    std::vector<char> replaced(soup_.triangles.size(), 0);
    std::map<std::uint32_t, bool> seen;
    for (const std::uint32_t t : all_turned_over()) {
      const auto [found, is_new] = seen.emplace(regions_->of(t), false);
      if (is_new)
        if (const auto again = filled_again(found->first)) {
          found->second = true;
          for (const std::uint32_t old : regions_->triangles(found->first)) replaced[old] = 1;
          for (const auto& triangle : *again) add(triangle, t);
        }
      if (found->second) continue;
      if (folded_[t])
        out_.folded.push_back(t);
      else
        out_.turned_over.push_back(t);
    }
    for (std::uint32_t t = 0; t < soup_.triangles.size(); ++t) {
      if (is_gone(t, groups_)) ++out_.offset.vanished;
      if (replaced[t] || is_gone(t, groups_)) continue;
      Triangle moved = fans_.of[t];
      for (std::uint32_t& fan : moved) fan = groups_.of(fan);
      add(moved, t);
    }
    out_.offset.folded = out_.folded.size();
    if (out_.offset.by > 0) out_.offset.filled = out_.turned_over.size();
    out_.soup.vertices = std::move(place_);
    out_.soup = compacted(std::move(out_.soup));
  }
  void add(const Triangle& triangle, std::uint32_t from) {
    if (is_degenerate(place_[triangle[0]], place_[triangle[1]], place_[triangle[2]])) return;
    out_.soup.triangles.push_back(triangle);
    out_.from.push_back(from);
  }

  const Soup& soup_;
  const Fans& fans_;
  CornerPlanes planes_;
  double way_;
  double sign_;
  const std::vector<Vec3>& normal_;
  const std::vector<char>& has_say_;
  std::vector<Vec3> place_;  // of each fan; that of a group at its least
  Sets groups_;
  std::vector<bool> turned_over_;  // and left so
  std::vector<bool> folded_;
  std::multimap<std::uint32_t, std::uint32_t> over_;  // of a fan, faces it lies over
  std::optional<FlatRegions> regions_;                // once something is turned over
  MovedFaces out_;
};

}  // namespace

MovedFaces move_faces(const Soup& soup, const Fans& fans, double by, double rounding,
                      const Progress& progress) {
  return Mover(soup, fans, by, rounding, part_of(progress, 0, 0.2)).run(part_of(progress, 0.2, 1));
}

}  // namespace sonde
