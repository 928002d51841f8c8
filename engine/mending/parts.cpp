// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/mending/lines.hpp"

namespace sonde {
namespace {

/// Numbers of line ends on parts and on their caps.
struct Ends {
  Ends(std::size_t parts, std::size_t caps) : on_part(parts, 0), on_cap(caps, 0) {}
  std::vector<std::size_t> on_part;  ///< including its caps, whether covered or not
  std::vector<std::size_t> on_cap;   ///< if no other part covers it
};

/// Follows each line from both ends to the first hit of each part. An opening hidden by another
/// part does not count as open: a lid covers it. Caps hide only what is behind them in their own
/// part.
class Look {
 public:
  Look(const Sealed& sealed, Ends& ends)
      : sealed_(sealed), ends_(ends), place_(ends.on_part.size(), nowhere) {}

  void along(const Lines& lines, const Progress& progress) {
    lines.each_unordered(
        [this](std::size_t, std::span<const LineHit> hits) {
          look(hits);
          return true;
        },
        progress);
  }

 private:
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  /// The hits of a part nearest to the two ends of a line.
  struct Outermost {
    std::uint32_t part;
    const LineHit *first, *last;
  };
  static bool before(const LineHit& p, const LineHit& q) {
    return p.along != q.along ? p.along < q.along : p.triangle < q.triangle;
  }
  static void extend(const LineHit& hit, const LineHit*& first, const LineHit*& last) {
    if (first == nullptr || before(hit, *first)) first = &hit;
    if (last == nullptr || before(*last, hit)) last = &hit;
  }

  void look(std::span<const LineHit> hits) {
    seen_.clear();
    const LineHit *first = nullptr, *last = nullptr;  // that cover what is behind
    for (const LineHit& hit : hits) {
      const std::uint32_t part = sealed_.part[hit.triangle];
      if (place_[part] == nowhere) {
        place_[part] = seen_.size();
        seen_.push_back({part, nullptr, nullptr});
      }
      Outermost& own = seen_[place_[part]];
      extend(hit, own.first, own.last);
      if (sealed_.cap[hit.triangle] == Sealed::no_cap) extend(hit, first, last);
    }
    for (const Outermost& own : seen_) {
      place_[own.part] = nowhere;
      ends_.on_part[own.part] += 2;
      const std::uint32_t at_first = sealed_.cap[own.first->triangle],
                          at_last = sealed_.cap[own.last->triangle];
      if (at_first != Sealed::no_cap && !(first != nullptr && before(*first, *own.first)))
        ++ends_.on_cap[at_first];
      if (at_last != Sealed::no_cap && !(last != nullptr && before(*own.last, *last)))
        ++ends_.on_cap[at_last];
    }
  }

  const Sealed& sealed_;
  Ends& ends_;
  std::vector<std::size_t> place_;  // by part, in seen_
  std::vector<Outermost> seen_;
};

class Judge {
 public:
  Judge(const Sealed& sealed, const std::vector<Cap>& caps, const std::vector<std::size_t>& torn)
      : sealed_(sealed), caps_(caps), facts_(torn.size()) {
    for (std::size_t p = 0; p < torn.size(); ++p) facts_[p].torn = torn[p];
    boxes_.resize(torn.size());
    sort_by_part();
  }

  std::vector<PartFacts> run(const Progress& progress) {
    measure();
    report(progress, 0.2);
    const Progress stays = part_of(progress, 0.2, 0.2);
    for (std::uint32_t p = 0; p < facts_.size(); ++p) find_flat(p, stays);
    report(progress, 0.4);
    find_mouths(part_of(progress, 0.4, 1));
    return std::move(facts_);
  }

 private:
  void sort_by_part() {
    start_.assign(facts_.size() + 1, 0);
    for (const std::uint32_t p : sealed_.part) ++start_[p + 1];
    for (std::size_t p = 0; p < facts_.size(); ++p) start_[p + 1] += start_[p];
    order_.resize(sealed_.part.size());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t i = 0; i < sealed_.part.size(); ++i) order_[next[sealed_.part[i]]++] = i;
  }

  void measure() {
    const auto& x = sealed_.soup.vertices;
    std::vector<Vec3> origin(facts_.size());
    for (std::size_t i = 0; i < sealed_.part.size(); ++i) {
      const Triangle& t = sealed_.soup.triangles[i];
      PartFacts& part = facts_[sealed_.part[i]];
      Eigen::AlignedBox3d& box = boxes_[sealed_.part[i]];
      if (box.isEmpty()) origin[sealed_.part[i]] = x[t[0]];
      for (const std::uint32_t v : t) box.extend(x[v]);
      const Vec3& o = origin[sealed_.part[i]];
      const Vec3 a = x[t[0]] - o, b = x[t[1]] - o, c = x[t[2]] - o;
      part.volume += a.dot(b.cross(c)) / 6;
      if (sealed_.cap[i] != Sealed::no_cap) continue;
      ++part.triangles;
      part.area += (b - a).cross(c - a).norm() / 2;
    }
    for (const Cap& cap : caps_) ++facts_[cap.part].caps;
  }

  /// A part alone, with its caps counted from `first_cap`.
  Sealed alone(std::uint32_t p, std::size_t first_cap = 0) const {
    Sealed out;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> number;
    for (std::size_t k = start_[p]; k < start_[p + 1]; ++k)
      for (const std::uint32_t v : sealed_.soup.triangles[order_[k]]) number.emplace_back(v, 0);
    ordering::sort(number.begin(), number.end());
    number.erase(std::unique(number.begin(), number.end()), number.end());
    for (auto& [v, n] : number) {
      n = static_cast<std::uint32_t>(out.soup.vertices.size());
      out.soup.vertices.push_back(sealed_.soup.vertices[v]);
    }
    const auto numbered = [&](std::uint32_t v) {
      return std::lower_bound(number.begin(), number.end(), std::pair{v, 0u})->second;
    };
    for (std::size_t k = start_[p]; k < start_[p + 1]; ++k) {
      const Triangle& t = sealed_.soup.triangles[order_[k]];
      out.soup.triangles.push_back({numbered(t[0]), numbered(t[1]), numbered(t[2])});
      out.part.push_back(0);
      const std::uint32_t cap = sealed_.cap[order_[k]];
      out.cap.push_back(cap == Sealed::no_cap ? cap : cap - static_cast<std::uint32_t>(first_cap));
    }
    return out;
  }

  /// Lobes of opposite winding may cancel in the volume; lines then decide.
  void find_flat(std::uint32_t p, const Progress& progress) {
    PartFacts& part = facts_[p];
    const double unit = part.area * boxes_[p].sizes().norm();
    if (std::abs(part.volume) > part_tuning.flat * unit) return;
    part.flat = !(unit > 0);
    if (part.flat || part.triangles < 4) {  // fewer bound no volume
      part.flat = true;
      return;
    }
    const Sealed own = alone(p);
    const double thin = part_tuning.thinnest_lobe * boxes_[p].sizes().norm();
    double inside = 0;
    for (int k = 0; k < 3; ++k) {
      const Lines lines(own.soup, line_frame(k), part_tuning.flat_lines);
      lines.each(
          [&](std::size_t, std::span<const LineHit> hits) {
            int winding = 0;
            double from = 0;
            for (const LineHit& hit : hits) {
              if (const double length = hit.along - from; winding != 0 && length > thin)
                inside += length * lines.pixel() * lines.pixel() / 3;
              winding -= hit.sign;
              from = hit.along;
            }
            return true;
          },
          progress);
    }
    part.flat = !(inside > part_tuning.flat_by_lines * unit);
  }

  void find_mouths(const Progress& progress) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t p = 0; p < facts_.size(); ++p)
      if (facts_[p].caps > 0 && !facts_[p].flat) open.push_back(p);
    if (open.empty()) return;
    Ends ends(facts_.size(), caps_.size());
    for (int k = 0; k < 3; ++k) {
      Look(sealed_, ends)
          .along(Lines(sealed_.soup, line_frame(k), part_tuning.lines),
                 part_of(progress, k / 4.0, (k + 1) / 4.0));
    }
    std::size_t rasters = 0;
    const Progress stays = part_of(progress, 0.75, 0.75);
    for (const std::uint32_t p : open) {
      if (ends.on_part[p] >= part_tuning.fewest_ends) continue;
      const auto [first, own] = caps_of(p);
      const bool in_sight = rasters++ < part_tuning.most_rasters;
      const Ends found = in_sight ? ends_in(box_of(p), part_tuning.own_lines, sealed_,
                                            Ends(facts_.size(), caps_.size()), stays)
                                  : ends_in(box_of(p), part_tuning.few_lines, alone(p, first),
                                            Ends(1, own), stays);
      ends.on_part[p] = found.on_part[in_sight ? p : 0];
      for (std::size_t c = 0; c < own; ++c)
        ends.on_cap[first + c] = found.on_cap[in_sight ? first + c : c];
    }
    for (std::uint32_t c = 0; c < caps_.size(); ++c) {
      PartFacts& part = facts_[caps_[c].part];
      const double all = static_cast<double>(std::max<std::size_t>(1, ends.on_part[caps_[c].part]));
      const double share = static_cast<double>(ends.on_cap[c]) / all;
      part.open += share;
      if (share > part.mouth) {
        part.mouth = share;
        part.mouth_cap = c;
      }
    }
  }

  /// The index of the first cap of a part, and the number of its caps.
  std::pair<std::size_t, std::size_t> caps_of(std::uint32_t p) const {
    const auto first = std::partition_point(caps_.begin(), caps_.end(),
                                            [p](const Cap& cap) { return cap.part < p; });
    const auto last =
        std::partition_point(first, caps_.end(), [p](const Cap& cap) { return cap.part == p; });
    return {static_cast<std::size_t>(first - caps_.begin()),
            static_cast<std::size_t>(last - first)};
  }

  /// The bounding box of a part across the lines, in each of their three directions.
  using Boxes = std::array<Eigen::AlignedBox2d, 3>;
  Boxes box_of(std::uint32_t p) const {
    Boxes boxes;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d frame = line_frame(k);
      for (std::size_t i = start_[p]; i < start_[p + 1]; ++i)
        for (const std::uint32_t v : sealed_.soup.triangles[order_[i]])
          boxes[static_cast<std::size_t>(k)].extend(
              Eigen::Vector2d((frame * sealed_.soup.vertices[v]).head<2>()));
    }
    return boxes;
  }

  static Ends ends_in(const Boxes& boxes, int count, const Sealed& what, Ends ends,
                      const Progress& progress) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::AlignedBox2d& box = boxes[static_cast<std::size_t>(k)];
      if (const double size = box.sizes().maxCoeff(); size > 0)
        Look(what, ends).along(Lines(what.soup, line_frame(k), count, box.min(), size), progress);
    }
    return ends;
  }

  const Sealed& sealed_;
  const std::vector<Cap>& caps_;
  std::vector<PartFacts> facts_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::size_t> start_;    // by part, in order_
  std::vector<std::uint32_t> order_;  // triangles by part
};

}  // namespace

std::vector<PartFacts> judge_parts(const Sealed& sealed, const std::vector<Cap>& caps,
                                   const std::vector<std::size_t>& torn, const Progress& progress) {
  return Judge(sealed, caps, torn).run(progress);
}

}  // namespace sonde
