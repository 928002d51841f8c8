// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/mend.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/mending/distinct.hpp"
#include "engine/mending/nesting.hpp"
#include "engine/mending/parts.hpp"
#include "engine/mending/point_windings.hpp"
#include "engine/text/counted.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

/// Share of what is seen of a part from all around: if its openings have a smaller share, most of
/// the part bounds an inside, and the user is told that it is nevertheless treated as a surface.
constexpr double most_doubtful = 0.25;
/// Times the size of a triangle: how far beside a wall it is looked which side is inside.
constexpr double beside_wall = 1e-4;
/// Triangles of cavities that are looked at, the largest: a mouth is flat, and cut as coarsely as
/// may be. More cost some µs each.
constexpr std::size_t most_lids = 20'000;

class Mender {
 public:
  Mender(const Soup& soup, const Topology& topology, Model asked, const std::string& name)
      : soup_(soup), open_edges_(topology.open_edges), asked_(asked), name_(name) {}

  Mended run(const Progress& progress) {
    distinct_ = find_distinct(soup_, part_of(progress, 0, 0.15));
    take_distinct();
    const std::vector<EdgeUse> uses = edge_uses(once_, part_of(progress, 0.15, 0.3));
    seams_ = find_seams(once_, uses, part_of(progress, 0.3, 0.45));
    orientation_ = find_orientation(once_, seams_.uses, part_of(progress, 0.45, 0.6));
    caps_ = find_caps(once_, seams_.uses, orientation_);
    count_open_edges(uses);
    Sealed sealed = seal(once_, seams_, orientation_, caps_);
    facts_ = judge_parts(sealed, caps_, orientation_.conflicts, part_of(progress, 0.6, 0.9));
    choose(sealed, part_of(progress, 0.9, 1));
    put_out();
    hide_walls();
    count_lids();
    describe();
    find_places();
    return std::move(out_);
  }

 private:
  void take_distinct() {
    once_.vertices = soup_.vertices;
    number_.assign(soup_.triangles.size(), Distinct::none);
    for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i) {
      if (distinct_.by[i] != i) continue;
      number_[i] = static_cast<std::uint32_t>(once_.triangles.size());
      once_.triangles.push_back(soup_.triangles[i]);
    }
  }

  /// Of each part: the edges that are open in the file.
  void count_open_edges(const std::vector<EdgeUse>& uses) {
    open_of_.assign(orientation_.parts, 0);
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 1) ++open_of_[orientation_.part[edge[0].triangle()]];
    });
  }

  void choose(Sealed& sealed, const Progress& progress) {
    solid_.resize(facts_.size());
    for (std::size_t p = 0; p < facts_.size(); ++p)
      solid_[p] = asked_ == Model::solid ? !facts_[p].flat : facts_[p].looks_solid();
    const bool any = std::find(solid_.begin(), solid_.end(), true) != solid_.end();
    turn_.assign(facts_.size(), false);
    if (!any) {
      if (asked_ == Model::solid)
        throw InputError::in(name_, "cannot be a solid: " + why_surface(open_edges_));
      return;
    }
    const bool all = std::find(solid_.begin(), solid_.end(), false) == solid_.end();
    out_.solid = all ? std::move(sealed) : parts_of(sealed, solid_);
    note_both_ways();
    turn_ = parts_to_turn(out_.solid, facts_, solid_, progress);
    for (std::size_t i = 0; i < out_.solid.part.size(); ++i)
      if (turn_[out_.solid.part[i]])
        std::swap(out_.solid.soup.triangles[i][1], out_.solid.soup.triangles[i][2]);
  }

  void note_both_ways() {
    for (PartFacts& part : facts_) part.both_ways = true;
    for (std::size_t i = 0; i < soup_.triangles.size(); ++i)
      if (distinct_.by[i] == i && !distinct_.both_ways[i])
        facts_[orientation_.part[number_[i]]].both_ways = false;
  }

  /// Outputs the triangles used for contact.
  void put_out() {
    for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i) {
      if (distinct_.backs[i] || repeats_solid(i)) continue;
      Triangle t = soup_.triangles[i];
      TriangleKind kind = TriangleKind::bounds;  // a pair that cancels bounds nothing in any case
      std::uint32_t own = Mended::no_part;
      if (const std::uint32_t by = distinct_.by[i]; by != Distinct::none) {
        const std::uint32_t k = number_[by], part = own = orientation_.part[k];
        if (!solid_[part]) kind = TriangleKind::loose;
        // Triangles that bound nothing keep their orientation.
        if (solid_[part] && orientation_.turned[k] != turn_[part]) {
          std::swap(t[1], t[2]);
          out_.as_given = false;
        }
      }
      add(t, kind, own);
    }
    out_.as_given = out_.as_given && out_.triangles.size() == soup_.triangles.size();
    for (const Cap& cap : caps_) {
      if (!solid_[cap.part]) continue;
      ++out_.repairs.caps;
      out_.repairs.cap_area += cap.area;
      for (Triangle t : cap.triangles) {
        if (turn_[cap.part]) std::swap(t[1], t[2]);
        add(t, TriangleKind::cap, cap.part);
        out_.as_given = false;
      }
    }
  }

  /// Whether it is a copy of a triangle that stays, in a solid. With both, a shell that occurs more
  /// often than others would have another winding number than that used for the mass.
  bool repeats_solid(std::uint32_t i) const {
    const std::uint32_t by = distinct_.by[i];
    return by != i && by != Distinct::none && solid_[orientation_.part[number_[by]]];
  }

  void add(const Triangle& t, TriangleKind kind, std::uint32_t part) {
    out_.triangles.push_back(t);
    out_.kinds.push_back(kind);
    out_.parts.push_back(part);
  }

  /// Of pairs that cancel, those with the inside on both sides are unreachable walls; the others
  /// can be touched, and are fins if both of their sides are outside.
  void hide_walls() {
    out_.fins.assign(out_.triangles.size(), false);
    std::vector<std::size_t> walls;
    for (std::size_t i = 0; i < out_.triangles.size(); ++i)
      if (out_.parts[i] == Mended::no_part) walls.push_back(i);
    const std::vector<Sides> sides = sides_of(walls);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (sides[k].on) {
        out_.kinds[walls[k]] = TriangleKind::hidden;
        out_.as_given = false;
      } else {
        out_.fins[walls[k]] = !sides[k].above && !sides[k].below;
      }
    }
  }

  /// Counts triangles of cavities that bound nothing: what is beyond them is outside too. (Of the
  /// body's face that they lie on, only a part of each triangle may be such.)
  void count_lids() {
    std::vector<std::size_t> of_cavities;
    for (std::size_t i = 0; i < out_.triangles.size(); ++i) {
      const std::uint32_t part = out_.parts[i];
      if (part != Mended::no_part && solid_[part] && (facts_[part].volume < 0) != turn_[part])
        of_cavities.push_back(i);
    }
    if (of_cavities.size() > most_lids) {
      const auto last = of_cavities.begin() + static_cast<std::ptrdiff_t>(most_lids);
      ordering::nth_element(of_cavities.begin(), last, of_cavities.end(),
                            [&](std::size_t i, std::size_t j) {
                              const double a = area_of(i), b = area_of(j);
                              return a != b ? a > b : i < j;
                            });
      of_cavities.erase(last, of_cavities.end());
    }
    out_.lids = static_cast<std::size_t>(std::ranges::count_if(
        sides_of(of_cavities), [](const Sides& s) { return !s.above && !s.below; }));
  }

  double area_of(std::size_t i) const {
    const Triangle& t = out_.triangles[i];
    const auto& x = soup_.vertices;
    return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
  }

  /// Whether the inside is at the middle of a triangle, and a little above and below it.
  struct Sides {
    bool on, above, below;
  };

  /// Of each of some triangles; empty where nothing has an inside.
  std::vector<Sides> sides_of(const std::vector<std::size_t>& triangles) const {
    if (triangles.empty() || out_.solid.soup.triangles.empty()) return {};
    std::vector<PartPoint> points;
    const auto& x = soup_.vertices;
    for (const std::size_t i : triangles) {
      const Triangle& t = out_.triangles[i];
      const Vec3 middle = (x[t[0]] + x[t[1]] + x[t[2]]) / 3,
                 normal = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
      const Vec3 off = beside_wall * normal / std::sqrt(std::max(normal.norm(), 1e-300));
      for (const Vec3& at : {middle, Vec3(middle + off), Vec3(middle - off)})
        points.push_back({at, Mended::no_part});
    }
    const std::vector<PartWindings> around = part_windings(out_.solid, points);
    const auto is_inside = [&](std::size_t k) {
      int winding = 0;
      for (const auto& [part, times] : around[k]) winding += times;
      return winding != 0;
    };
    std::vector<Sides> out;
    for (std::size_t k = 0; k < triangles.size(); ++k)
      out.push_back({is_inside(3 * k), is_inside(3 * k + 1), is_inside(3 * k + 2)});
    return out;
  }

  void describe() {
    Repairs& r = out_.repairs;
    const bool any = !out_.solid.soup.triangles.empty();
    r.parts = facts_.size();
    if (any) {  // a surface stays as given: the attempts are not counted
      r.joined = seams_.joined;
      r.on_edges = seams_.on_edges;
      r.reach = r.joined + r.on_edges > 0 ? seams_.reach : 0;
      r.repeated = distinct_.repeated;
      r.hidden = static_cast<std::size_t>(
          std::count(out_.kinds.begin(), out_.kinds.end(), TriangleKind::hidden));
    }
    r.unsearched = seams_.unsearched;
    for (std::size_t k = 0; k < once_.triangles.size(); ++k)
      r.turned_triangles += solid_[orientation_.part[k]] && orientation_.turned[k];
    for (std::size_t p = 0; p < facts_.size(); ++p) {
      r.solid_parts += solid_[p];
      r.turned_parts += turn_[p];
      r.torn_parts += facts_[p].torn > 0;
      if (solid_[p]) r.widest_cap = std::max(r.widest_cap, facts_[p].mouth);
    }
    if (const PartFacts* open = largest_open()) {
      r.widest_mouth = open->mouth;
      r.could_be_solid = !open->flat && open->torn == 0 && open->open <= most_doubtful;
    }
    for (const TriangleKind kind : out_.kinds) r.cap_triangles += kind == TriangleKind::cap;
    out_.cracked = any && (r.joined + r.on_edges > 0);
    if (!any)
      out_.why = why_surface(open_edges_) + ": the inside does not count";
    else if (r.solid_parts < r.parts)
      out_.why = std::to_string(r.solid_parts) + " of " + counted(r.parts, "part") +
                 (r.solid_parts == 1 ? " is closed: its inside counts"
                                     : " are closed: their inside counts") +
                 (r.could_be_solid ? "; the largest other has " + why_largest_other() : "");
    else if (r.any())
      out_.why = "closed once mended: the inside counts";
    else
      out_.why = "closed: the inside counts";
    if (r.unsearched > 0)
      out_.why += "; corners on open edges were not looked for, which may leave it in pieces";
  }

  /// Finds the places of repairs, by the labels of corners: cracked parts are connected by these.
  void find_places() {
    if (out_.solid.soup.triangles.empty() || !out_.repairs.any()) return;
    const auto& x = soup_.vertices;
    const auto at = [&](const Triangle& t, bool over) {
      const auto& label = seams_.label;
      return over ? Triangle{label[t[0]], label[t[2]], label[t[1]]}
                  : Triangle{label[t[0]], label[t[1]], label[t[2]]};
    };
    std::vector<Triangle> turned, repeated;
    std::map<std::uint32_t, std::vector<Triangle>> inside_out;  // by part
    for (std::uint32_t k = 0; k < once_.triangles.size(); ++k) {
      const std::uint32_t part = orientation_.part[k];
      if (!solid_[part]) continue;
      const Triangle t = at(once_.triangles[k], orientation_.turned[k] != turn_[part]);
      if (orientation_.turned[k]) turned.push_back(t);
      if (turn_[part]) inside_out[part].push_back(t);
    }
    for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i)
      if (distinct_.by[i] != i) repeated.push_back(at(soup_.triangles[i], false));
    for (const Cap& cap : caps_)
      if (solid_[cap.part]) add_cap_place(cap);
    add_places(out_.places, RepairKind::turned, x, turned);
    for (const auto& [part, triangles] : inside_out)
      add_place(out_.places, RepairKind::inside_out, x, triangles);
    add_places(out_.places, RepairKind::repeated, x, repeated);
    if (seams_.joined + seams_.on_edges > 0) add_seam_places(at);
  }

  void add_cap_place(const Cap& cap) {
    std::vector<Triangle> triangles = cap.triangles;
    if (turn_[cap.part])
      for (Triangle& t : triangles) std::swap(t[1], t[2]);
    add_place(out_.places, RepairKind::cap, soup_.vertices, triangles);
  }

  template <class At>
  void add_seam_places(At at) {
    std::vector<bool> marked(soup_.vertices.size(), false);
    for (std::uint32_t v = 0; v < seams_.label.size(); ++v)
      if (seams_.label[v] != v) marked[seams_.label[v]] = true;
    for (const Seams::Cut& cut : seams_.cuts) {
      for (const std::uint32_t v : cut.at) marked[v] = true;
      // Also marks the ends of the side: cuts in sides that meet are one seam.
      const Triangle& t = once_.triangles[cut.side / 3];
      for (const std::uint32_t k : {cut.side % 3, (cut.side + 1) % 3})
        marked[seams_.label[t[k]]] = true;
    }
    std::vector<Triangle> triangles;
    for (std::uint32_t k = 0; k < once_.triangles.size(); ++k) {
      const Triangle t =
          at(once_.triangles[k], orientation_.turned[k] != turn_[orientation_.part[k]]);
      if (std::ranges::any_of(t, [&](std::uint32_t v) { return bool(marked[v]); }))
        triangles.push_back(t);
    }
    add_corner_places(out_.places, RepairKind::seam, soup_.vertices, triangles, marked);
  }

  /// The largest part that is no solid; null if there is none.
  const PartFacts* largest_open() const {
    const PartFacts* largest = nullptr;
    for (std::size_t p = 0; p < facts_.size(); ++p)
      if (!solid_[p] && (largest == nullptr || facts_[p].area > largest->area))
        largest = &facts_[p];
    return largest;
  }

  std::string why_largest_other() const {
    const auto p = static_cast<std::size_t>(largest_open() - facts_.data());
    return why_surface(open_of_[p]);
  }

  std::string why_surface(std::size_t open_edges) const {
    const PartFacts* largest = largest_open();
    if (largest == nullptr) return "no triangles";
    if (largest->torn > 0 && !largest->flat)
      return "one side only (non-orientable along " + counted(largest->torn, "edge") + ")";
    const std::string edges = open_edges == 0 ? "" : counted(open_edges, "open edge");
    if (largest->flat) return open_edges == 0 ? "closed but flat (no volume)" : edges;
    return edges + (open_edges == 0 ? "" : ", ") +
           (largest->mouth > part_tuning.widest_mouth
                ? "open mouth " + number_text(100 * largest->mouth, 2)
                : "openings " + number_text(100 * largest->open, 2)) +
           " % (model solid closes it)";
  }

  const Soup& soup_;
  std::size_t open_edges_;
  Model asked_;
  const std::string& name_;
  Distinct distinct_;
  Soup once_;                          // the triangles that stay
  std::vector<std::uint32_t> number_;  // index in once_ of each triangle of the soup
  Seams seams_;
  Orientation orientation_;
  std::vector<Cap> caps_;
  std::vector<PartFacts> facts_;
  std::vector<bool> solid_, turn_;    // by part
  std::vector<std::size_t> open_of_;  // by part
  Mended out_;
};

}  // namespace

Mended mend(const Soup& soup, const Topology& topology, Model asked, const std::string& name,
            const Progress& progress) {
  return Mender(soup, topology, asked, name).run(progress);
}

}  // namespace sonde
