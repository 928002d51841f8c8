// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/components.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/geometry/union_find.hpp"
#include "engine/mending/nesting.hpp"

namespace sonde {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// For each polygon, the number of its piece; pieces are in the order of their first polygons.
std::vector<std::uint32_t> pieces(const PolygonSoup& soup, const std::vector<std::uint32_t>& place,
                                  const Progress& progress) {
  UnionFind sets(soup.points.size());
  for_each_index(soup.polygons.size(), part_of(progress, 0, 0.5), [&](std::size_t i) {
    for (const std::size_t corner : soup.polygons[i])
      sets.join(place[soup.polygons[i].front()], place[corner]);
  });
  std::vector<std::uint32_t> number(soup.points.size(), none), piece(soup.polygons.size(), none);
  std::uint32_t count = 0;
  for_each_index(soup.polygons.size(), part_of(progress, 0.5, 1), [&](std::size_t i) {
    if (soup.polygons[i].empty()) return;
    std::uint32_t& of_set = number[sets.find(place[soup.polygons[i].front()])];
    if (of_set == none) of_set = count++;
    piece[i] = of_set;
  });
  return piece;
}

/// The polygons of each piece, with the points that they use.
std::vector<PolygonSoup> taken_apart(const PolygonSoup& soup,
                                     const std::vector<std::uint32_t>& piece) {
  std::vector<PolygonSoup> out;
  std::vector<std::size_t> index(soup.points.size(), none);  // a point may belong to several pieces
  std::vector<std::uint32_t> index_in(soup.points.size(), none);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] == none) continue;
    out.resize(std::max<std::size_t>(out.size(), piece[i] + 1));
    PolygonSoup& own = out[piece[i]];
    Polygon polygon = soup.polygons[i];
    for (std::size_t& corner : polygon) {
      if (index_in[corner] != piece[i]) {
        index_in[corner] = piece[i];
        index[corner] = own.points.size();
        own.points.push_back(soup.points[corner]);
      }
      corner = index[corner];
    }
    own.polygons.push_back(std::move(polygon));
  }
  return out;
}

double signed_volume(const Soup& soup) {
  if (soup.vertices.empty()) return 0;
  const Vec3 origin = soup.vertices.front();
  double six_volumes = 0;
  for (const Triangle& t : soup.triangles)
    six_volumes += (soup.vertices[t[0]] - origin)
                       .dot((soup.vertices[t[1]] - origin).cross(soup.vertices[t[2]] - origin));
  return six_volumes / 6;
}

/// The closed ones of some pieces, collected: a part each, in the order of the file.
struct ClosedPieces {
  Sealed all;
  std::vector<PartFacts> facts;      ///< by part: its volume, signed, m³
  std::vector<std::uint32_t> piece;  ///< by part
};

ClosedPieces closed_pieces(const std::vector<PolygonSoup>& pieces, const Progress& progress) {
  ClosedPieces out;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    report(progress, static_cast<double>(k) / static_cast<double>(pieces.size()));
    const Soup soup = compacted(triangulate_all(pieces[k]));
    if (soup.triangles.empty() || !analyse_topology(soup).closed) continue;
    const auto first = static_cast<std::uint32_t>(out.all.soup.vertices.size());
    const auto part = static_cast<std::uint32_t>(out.piece.size());
    out.piece.push_back(static_cast<std::uint32_t>(k));
    out.facts.emplace_back().volume = signed_volume(soup);
    for (const Vec3& x : soup.vertices) out.all.soup.vertices.push_back(x);
    for (const Triangle& t : soup.triangles)
      out.all.soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    out.all.part.resize(out.all.soup.triangles.size(), part);
    out.all.cap.resize(out.all.soup.triangles.size(), Sealed::no_cap);
  }
  return out;
}

/// Of the parts around a part, those directly around it: none of the others lies inside them.
/// Several that cross each other may be.
std::vector<std::uint32_t> directly_around(std::uint32_t p, const Nesting& nesting,
                                           const std::vector<PartFacts>& facts) {
  std::vector<std::uint32_t> all, out;
  for (const std::uint32_t q : nesting.around(p))
    if (std::abs(facts[q].volume) > std::abs(facts[p].volume) && nesting.is_in(p, q))
      all.push_back(q);
  for (const std::uint32_t q : all)
    if (std::ranges::none_of(all, [&](std::uint32_t r) { return r != q && nesting.is_in(r, q); }))
      out.push_back(q);
  return out;
}

/// Whether a cavity fits one of the parts around it clearly better than the others: its middle is
/// at most this share as far from that one's.
constexpr double clearly_nearer = 0.5;

/// What belongs to what: for each piece itself, or the piece whose cavity or hole it is.
struct Owners {
  std::vector<std::uint32_t> of;                           ///< by piece
  std::map<std::uint32_t, std::vector<std::string>> said;  ///< by piece, what is odd about it
};

class OwnerFinder {
 public:
  OwnerFinder(std::size_t pieces, const ClosedPieces& closed, const Progress& progress)
      : closed_(closed), facts_(closed.facts), nesting_(closed.all, closed.facts, progress) {
    out_.of.resize(pieces);
    std::iota(out_.of.begin(), out_.of.end(), 0u);
    bounds_.resize(facts_.size());
    for (std::size_t i = 0; i < closed.all.part.size(); ++i)
      for (const std::uint32_t v : closed.all.soup.triangles[i])
        bounds_[closed.all.part[i]].extend(closed.all.soup.vertices[v]);
  }

  Owners run() {
    // From the largest on, so that what is around another is processed first.
    std::vector<std::uint32_t> order(facts_.size()), holes;
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::uint32_t p) { return std::abs(facts_[p].volume); });
    for (const std::uint32_t p : order) {
      std::vector<std::uint32_t> around = directly_around(p, nesting_, facts_);
      std::erase_if(around, [&](std::uint32_t q) { return !may_own(q, p); });
      if (!around.empty()) {
        give(p, around);
      } else if (is_hole_through_several(p)) {  // which then owns nothing that lies in it
        holes.push_back(p);
        out_.of[closed_.piece[p]] = closed_.piece[*nesting_.around(p).begin()];
      }
    }
    for (const std::uint32_t p : holes) join_by_hole(p);
    return std::move(out_);
  }

 private:
  bool owns_itself(std::uint32_t p) const { return out_.of[closed_.piece[p]] == closed_.piece[p]; }
  bool may_own(std::uint32_t q, std::uint32_t p) const {
    return owns_itself(q) && facts_[q].volume * facts_[p].volume < 0;
  }

  bool is_hole_through_several(std::uint32_t p) const {
    return nesting_.is_in_several(p) &&
           std::ranges::all_of(nesting_.around(p), [&](std::uint32_t q) {
             return facts_[q].volume * facts_[p].volume < 0;
           });
  }

  void give(std::uint32_t p, const std::vector<std::uint32_t>& around) {
    const std::uint32_t owner = closed_.piece[around.size() == 1 ? around[0] : likely(p, around)];
    out_.of[closed_.piece[p]] = owner;
    if (around.size() > 1)
      out_.said[owner].push_back("a cavity that lies within " + std::to_string(around.size()) +
                                 " parts that overlap was taken as this one's: the file does not "
                                 "say whose it is");
  }

  /// Which of several parts that clash a cavity within all of them belongs to: the one about whose
  /// middle it lies. Where that says nothing, the order of the file: cavities come after their
  /// parts, unless one comes before all parts.
  std::uint32_t likely(std::uint32_t p, const std::vector<std::uint32_t>& around) const {
    std::vector<std::pair<double, std::uint32_t>> by_middle;
    by_middle.reserve(around.size());
    for (const std::uint32_t q : around)
      by_middle.emplace_back((bounds_[p].center() - bounds_[q].center()).norm(), q);
    ordering::sort(by_middle.begin(), by_middle.end());
    if (by_middle[0].first < clearly_nearer * by_middle[1].first) return by_middle[0].second;
    const auto after = std::ranges::upper_bound(around, p);
    const bool cavities_first = facts_[0].volume * facts_[p].volume > 0;
    if (after == around.begin() || (cavities_first && after != around.end())) return *after;
    return *std::prev(after);
  }

  /// A hole that is one shell through several parts: without it none of them is what it is, and it
  /// is a part of neither alone, so all are one component.
  void join_by_hole(std::uint32_t p) {
    std::vector<std::uint32_t> holed{closed_.piece[p]};
    for (const std::uint32_t q : nesting_.around(p)) holed.push_back(out_.of[closed_.piece[q]]);
    const std::uint32_t owner = *std::ranges::min_element(holed);
    std::vector<std::string> said;
    for (std::uint32_t& of : out_.of)
      if (std::ranges::count(holed, of) > 0) of = owner;
    for (const std::uint32_t piece : holed)
      if (const auto found = out_.said.find(piece); found != out_.said.end() && piece != owner) {
        std::ranges::move(found->second, std::back_inserter(said));
        out_.said.erase(found);
      }
    std::ranges::move(said, std::back_inserter(out_.said[owner]));
    out_.said[owner].push_back("a hole that is one shell goes through " +
                               std::to_string(holed.size() - 1) +
                               " parts, which are one component for that");
  }

  const ClosedPieces& closed_;
  const std::vector<PartFacts>& facts_;
  Nesting nesting_;
  std::vector<Eigen::AlignedBox3d> bounds_;  // by part
  Owners out_;
};

/// A cavity lies inside its piece with all of its surface: parts that clash may cover a corner of
/// it too.
Owners find_owners(const std::vector<PolygonSoup>& pieces, const Progress& progress) {
  Owners none_owned{std::vector<std::uint32_t>(pieces.size()), {}};
  std::iota(none_owned.of.begin(), none_owned.of.end(), 0u);
  if (pieces.size() < 2) return none_owned;
  const ClosedPieces closed = closed_pieces(pieces, part_of(progress, 0, 0.5));
  const auto is_one_sign = [&](double sign) {
    return std::ranges::none_of(closed.facts,
                                [sign](const PartFacts& f) { return f.volume * sign < 0; });
  };
  if (is_one_sign(1) || is_one_sign(-1)) return none_owned;  // there is no cavity
  return OwnerFinder(pieces.size(), closed, part_of(progress, 0.5, 1)).run();
}

/// A polygon's corners by their places, the lowest first.
std::vector<std::uint32_t> places_in_turn(const Polygon& polygon,
                                          const std::vector<std::uint32_t>& place) {
  std::vector<std::uint32_t> out;
  out.reserve(polygon.size());
  for (const std::size_t corner : polygon) out.push_back(place[corner]);
  std::rotate(out.begin(), std::ranges::min_element(out), out.end());
  return out;
}

/// A polygon, and a number that only alike ones have, but for accidents.
struct KeyedPolygon {
  std::uint64_t key;
  std::uint32_t polygon;
};

std::vector<KeyedPolygon> keyed_polygons(const PolygonSoup& soup,
                                         const std::vector<std::uint32_t>& place,
                                         const Progress& progress) {
  std::vector<KeyedPolygon> out;
  for_each_index(soup.polygons.size(), progress, [&](std::size_t i) {
    if (soup.polygons[i].empty()) return;
    std::uint64_t key = 0xcbf29ce484222325;  // FNV
    for (const std::uint32_t at : places_in_turn(soup.polygons[i], place))
      key = (key ^ at) * 0x100000001b3;
    out.push_back({key, static_cast<std::uint32_t>(i)});
  });
  ordering::sort(out.begin(), out.end(), [](const KeyedPolygon& a, const KeyedPolygon& b) {
    return a.key != b.key ? a.key < b.key : a.polygon < b.polygon;
  });
  return out;
}

/// For each polygon, how many alike ones (the same corners, the same way round) come before it in
/// the file; and for each component how often all of it is there: 1 if some of it is there more
/// often than the rest.
struct Copies {
  std::vector<std::uint32_t> before, times;
};

Copies find_copies(const PolygonSoup& soup, const std::vector<std::uint32_t>& place,
                   const std::vector<std::uint32_t>& component, std::size_t components,
                   const Progress& progress) {
  Copies out{std::vector<std::uint32_t>(soup.polygons.size(), 0),
             std::vector<std::uint32_t>(components, 0)};
  const std::vector<KeyedPolygon> all = keyed_polygons(soup, place, progress);
  for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
    const auto first = places_in_turn(soup.polygons[all[i].polygon], place);
    bool alike = true;
    for (j = i; j < all.size() && all[j].key == all[i].key; ++j) {
      out.before[all[j].polygon] = static_cast<std::uint32_t>(j - i);
      alike = alike && places_in_turn(soup.polygons[all[j].polygon], place) == first;
    }
    std::uint32_t& times = out.times[component[all[i].polygon]];
    const auto found = static_cast<std::uint32_t>(j - i);
    times = alike && (times == 0 || times == found) ? found : 1;
  }
  return out;
}

/// Numbers the polygons anew: by their pieces' owners, and apart what is there several times, in
/// the order of first polygons (a cavity may come before its piece).
void renumber(std::vector<std::uint32_t>& piece, const std::vector<std::uint32_t>& owner,
              const Copies& copies) {
  std::vector<std::vector<std::uint32_t>> number(owner.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] == none) continue;
    const std::uint32_t own = owner[piece[i]];
    number[own].resize(copies.times[own], none);
    std::uint32_t& of_copy = number[own][copies.times[own] > 1 ? copies.before[i] : 0];
    if (of_copy == none) of_copy = count++;
    piece[i] = of_copy;
  }
}

}  // namespace

std::vector<PolygonSoup> components_of(const PolygonSoup& soup, const Progress& progress) {
  const std::vector<std::uint32_t> place = weld(soup.points, part_of(progress, 0, 0.15));
  std::vector<std::uint32_t> piece = pieces(soup, place, part_of(progress, 0.15, 0.3));
  const Owners owners = find_owners(taken_apart(soup, piece), part_of(progress, 0.3, 0.8));
  std::vector<std::uint32_t> owned(piece);
  for (std::uint32_t& p : owned)
    if (p != none) p = owners.of[p];
  renumber(piece, owners.of,
           find_copies(soup, place, owned, owners.of.size(), part_of(progress, 0.8, 0.9)));
  std::vector<PolygonSoup> out = taken_apart(soup, piece);
  if (!out.empty()) out.front().remarks = soup.remarks;
  std::vector<bool> done(out.size(), false);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece[i] == none || done[piece[i]]) continue;
    done[piece[i]] = true;
    if (const auto said = owners.said.find(owned[i]); said != owners.said.end())
      std::ranges::copy(said->second, std::back_inserter(out[piece[i]].remarks));
  }
  return out;
}

}  // namespace sonde
