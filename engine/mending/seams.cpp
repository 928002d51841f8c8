// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/seams.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/mending/point_grid.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

using Uses = std::vector<EdgeUse>;

using IsOpen = std::function<bool(std::span<const EdgeUse>)>;

bool is_odd(std::span<const EdgeUse> edge) { return edge.size() % 2 == 1; }

Eigen::AlignedBox3d box_of(const Soup& soup) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : soup.vertices) box.extend(x);
  return box;
}

/// The corners of open edges, with the length of the shortest open edge at each.
struct OpenCorners {
  std::vector<std::uint32_t> vertices;  // ascending
  std::vector<double> shortest;         // by vertex of the soup, m
};

OpenCorners open_corners(const Soup& soup, const Uses& uses, const IsOpen& is_open) {
  OpenCorners out;
  out.shortest.assign(soup.vertices.size(), std::numeric_limits<double>::infinity());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (!is_open(edge)) return;
    const EdgeUse& use = edge[0];
    const double length = (soup.vertices[use.low] - soup.vertices[use.high]).norm();
    for (const std::uint32_t v : {use.low, use.high}) {
      out.vertices.push_back(v);
      out.shortest[v] = std::min(out.shortest[v], length);
    }
  });
  ordering::sort(out.vertices.begin(), out.vertices.end());
  out.vertices.erase(std::unique(out.vertices.begin(), out.vertices.end()), out.vertices.end());
  return out;
}

/// One attempt to close the open edges with a given reach.
class Attempt {
 public:
  Attempt(const Soup& soup, const IsOpen& is_open, const Eigen::AlignedBox3d& box, double reach,
          double of_edge)
      : soup_(soup),
        is_open_(is_open),
        low_(box.min()),
        diagonal_(box.sizes().norm()),
        reach_(reach),
        of_edge_(of_edge) {}

  /// `open`: the uses of open edges; `all`: the number of all uses.
  Seams run(const Uses& open, std::size_t all) {
    out_.reach = reach_;
    join_corners(open);
    Uses uses;
    uses.reserve(open.size());
    for (const EdgeUse& use : open) {
      const std::uint32_t low = out_.label[use.low], high = out_.label[use.high];
      if (low == high) continue;
      const bool down = use.down != (low > high);
      uses.push_back({std::min(low, high), std::max(low, high), use.side, down});
    }
    sort_uses(uses, soup_.vertices.size());
    cut_at_corners(uses, all);
    sort_uses(out_.uses, soup_.vertices.size());
    return std::move(out_);
  }

 private:
  const Vec3& at(std::uint32_t v) const { return soup_.vertices[v]; }

  void join_corners(const Uses& open) {
    out_.label.resize(soup_.vertices.size());
    std::iota(out_.label.begin(), out_.label.end(), 0u);
    if (!(reach_ > 0)) return;
    const OpenCorners corners = open_corners(soup_, open, is_open_);
    const PointGrid grid(soup_.vertices, corners.vertices, low_, 4 * reach_);
    TurnedSets sets(soup_.vertices.size());
    const Vec3 around = Vec3::Constant(reach_);
    for (const std::uint32_t i : corners.vertices)
      grid.each_within(at(i) - around, at(i) + around, [&](std::uint32_t j) {
        const double near =
            std::min(reach_, of_edge_ * std::min(corners.shortest[i], corners.shortest[j]));
        if (j < i && (at(i) - at(j)).norm() <= near) sets.join(j, i);
      });
    for (const std::uint32_t i : corners.vertices) {
      out_.label[i] = sets.set_of(i);
      out_.joined += out_.label[i] != i;
    }
  }

  /// Writes the uses between labels, sorted, to out_.uses; open edges are split at the corners on
  /// them.
  void cut_at_corners(const Uses& uses, std::size_t all) {
    std::size_t open = 0;
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) { open += is_open_(edge); });
    if (open > seam_tuning.most_open && 10 * open > all / 2) {
      out_.unsearched = open;
      out_.uses = uses;
      return;
    }
    const OpenCorners corners = open_corners(soup_, uses, is_open_);
    const double cell = std::max({median_length(uses), diagonal_ / 512, 4 * reach_});
    if (!(cell > 0)) {
      out_.uses = uses;
      return;
    }
    const PointGrid grid(soup_.vertices, corners.vertices, low_, cell);
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      std::vector<std::uint32_t> chain;
      if (is_open_(edge)) chain = on_edge(edge[0], corners, grid);
      out_.on_edges += chain.size();
      for (const EdgeUse& use : edge) add_pieces(use, chain);
    });
    ordering::sort(out_.cuts.begin(), out_.cuts.end(),
                   [](const auto& x, const auto& y) { return x.side < y.side; });
  }

  double median_length(const Uses& uses) const {
    std::vector<double> lengths;
    lengths.reserve(uses.size());
    for (const EdgeUse& use : uses) lengths.push_back((at(use.low) - at(use.high)).norm());
    if (lengths.empty()) return 0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    ordering::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
  }

  /// The labels on an open edge, from its lower end to the higher one.
  std::vector<std::uint32_t> on_edge(const EdgeUse& edge, const OpenCorners& corners,
                                     const PointGrid& grid) const {
    const Vec3 from = at(edge.low), way = at(edge.high) - from;
    const double length = way.norm();
    std::vector<std::pair<double, std::uint32_t>> found;
    const auto look = [&](std::uint32_t i) {
      if (i == edge.low || i == edge.high) return;
      const double t = (at(i) - from).dot(way) / (length * length);
      if (!(t > 0 && t < 1)) return;
      const double near =
          std::max(seam_tuning.rounding * diagonal_,
                   std::min(reach_, of_edge_ * std::min(corners.shortest[i], length)));
      if ((at(i) - from - t * way).norm() <= near) found.emplace_back(t, i);
    };
    const auto pieces = static_cast<int>(std::ceil(length / grid.cell()));
    const Vec3 around = Vec3::Constant(std::max(reach_, seam_tuning.rounding * diagonal_));
    for (int k = 0; k < pieces; ++k) {
      const Vec3 a = from + way * k / pieces, b = from + way * (k + 1) / pieces;
      grid.each_within(a.cwiseMin(b) - around, a.cwiseMax(b) + around, look);
    }
    ordering::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<std::uint32_t> out;
    out.reserve(found.size());
    for (const auto& [t, i] : found) out.push_back(i);
    return out;
  }

  void add_pieces(const EdgeUse& use, const std::vector<std::uint32_t>& chain) {
    std::vector<std::uint32_t> way(chain);
    if (use.down) std::reverse(way.begin(), way.end());
    std::uint32_t from = use.down ? use.high : use.low;
    const std::uint32_t end = use.down ? use.low : use.high;
    for (const std::uint32_t v : way) {
      out_.uses.push_back(edge_use(from, v, use.side));
      from = v;
    }
    out_.uses.push_back(edge_use(from, end, use.side));
    if (!way.empty()) out_.cuts.push_back({use.side, std::move(way)});
  }

  const Soup& soup_;
  const IsOpen& is_open_;
  Vec3 low_;
  double diagonal_, reach_, of_edge_;
  Seams out_;
};

double border_length(const Soup& soup, const Uses& uses) {
  double length = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (is_odd(edge)) length += (soup.vertices[edge[0].low] - soup.vertices[edge[0].high]).norm();
  });
  return length;
}

/// The search for the reach that closes a soup.
class SeamSearch {
 public:
  SeamSearch(const Soup& soup, const Uses& uses, const SeamJudge& judge)
      : soup_(soup), judge_(judge), all_(uses.size()), box_(box_of(soup)) {
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      Uses& to = judge.open(edge) ? open_ : paired_;
      to.insert(to.end(), edge.begin(), edge.end());
    });
    border_ = judge.border(open_);
    best_.label.resize(soup.vertices.size());
    std::iota(best_.label.begin(), best_.label.end(), 0u);
    best_.uses = open_;
  }

  /// `shorter_at_once`: how much shorter cuts alone must make the border, with no corners joined.
  Seams run(double shorter_at_once, const Progress& progress) {
    report(progress, 0);
    if (border_ > 0 && widest_finds_any()) {
      for (const double reach : seam_tuning.reaches) {
        if (border_ == 0) break;
        report(progress, 0.5);
        Seams tried = within(metres(reach), seam_tuning.of_edge);
        const double left = judge_.border(tried.uses);
        if (left <= (reach > 0 ? seam_tuning.shorter : shorter_at_once) * border_)
          take(std::move(tried), left);
      }
      if (border_ > 0 && best_.reach > 0) try_wider(progress);
    }
    // Edges that are already paired keep their vertices, whatever the labels of their ends.
    best_.uses.insert(best_.uses.end(), paired_.begin(), paired_.end());
    sort_uses(best_.uses, soup_.vertices.size());
    return std::move(best_);
  }

 private:
  static double widest() { return *std::rbegin(seam_tuning.reaches); }

  double metres(double reach) const {
    const double size = box_.sizes().norm();
    const double rounding =
        std::min(seam_tuning.farthest_rounding * size,
                 seam_tuning.single_precision *
                     std::max(box_.min().cwiseAbs().maxCoeff(), box_.max().cwiseAbs().maxCoeff()));
    return std::max(reach * size, reach == widest() ? rounding : 0);
  }

  Seams within(double reach, double of_edge) const {
    return Attempt(soup_, judge_.open, box_, reach, of_edge).run(open_, all_);
  }

  /// If the widest reach finds nothing, no smaller one does.
  bool widest_finds_any() {
    const Seams widest_found = within(metres(widest()), seam_tuning.of_edge);
    best_.unsearched = widest_found.unsearched;
    return widest_found.joined + widest_found.on_edges > 0;
  }

  void take(Seams found, double border) {
    best_ = std::move(found);
    border_ = border;
  }

  void try_wider(const Progress& progress) {
    const auto found = [](const Seams& seams) { return seams.joined + seams.on_edges; };
    for (const double times : seam_tuning.wider) {
      report(progress, 0.7);
      const double reach = times * metres(widest());
      Seams tried = within(reach, seam_tuning.of_edge_wider);
      const double left = judge_.border(tried.uses);
      if (left > seam_tuning.shorter * border_) continue;
      if (left > 0 &&
          found(within(seam_tuning.further * reach, seam_tuning.of_edge_wider)) != found(tried))
        continue;
      return take(std::move(tried), left);
    }
  }

  const Soup& soup_;
  const SeamJudge& judge_;
  std::size_t all_;  // uses
  Eigen::AlignedBox3d box_;
  Uses open_, paired_;
  double border_ = 0;  // m, of the best so far
  Seams best_;
};

}  // namespace

Seams find_seams(const Soup& soup, const Uses& uses, const Progress& progress) {
  const SeamJudge judge{is_odd, [&](const Uses& left) { return border_length(soup, left); }};
  return SeamSearch(soup, uses, judge).run(seam_tuning.shorter, progress);
}

Seams find_seams(const Soup& soup, const Uses& uses, const SeamJudge& judge,
                 const Progress& progress) {
  return SeamSearch(soup, uses, judge).run(1 - seam_tuning.rounding, progress);
}

}  // namespace sonde
