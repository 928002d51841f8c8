// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/region_mass.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/crossings.hpp"
#include "engine/mending/lines.hpp"

namespace sonde {
namespace {

/// Calls `use` for the hits of a line at one place, which make one step of the winding number.
template <class Use>
void each_step(std::span<const LineHit> hits, double rounding, Use use) {
  int winding = 0;
  for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
    int next = winding;
    for (j = i; j < hits.size() && hits[j].along - hits[i].along <= rounding; ++j)
      next -= hits[j].sign;
    use(hits.subspan(i, j - i), winding, next);
    winding = next;
  }
}

double size_of(const Soup& soup) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) box.extend(soup.vertices[v]);
  return box.isEmpty() ? 0 : box.sizes().norm();
}

/// How a part bounds the region, as far as the lines have shown.
struct Role {
  bool seen = false;
  bool constant = true;
  int weight = 0;
};

class Regions {
 public:
  Regions(const Soup& soup, const std::vector<std::uint32_t>& part)
      : soup_(soup), part_(part), rounding_(overlap_tuning.rounding * size_of(soup)) {
    std::uint32_t parts = 0;
    for (const std::uint32_t p : part) parts = std::max(parts, p + 1);
    roles_.resize(parts);
  }

  Region run(const Progress& progress) {
    Region out;
    if (!(rounding_ > 0)) return out;
    if (!any_overlap(part_of(progress, 0, 0.2))) return of_crossings(part_of(progress, 0.2, 1));
    out.overlaps = true;
    MassMoments found[2];
    for (std::size_t k = 0; k < 2; ++k) {
      // The second raster is the finer one, and takes most of the time.
      found[k] = integrate(overlap_tuning.rasters[k],
                           k == 0 ? part_of(progress, 0.2, 0.35) : part_of(progress, 0.35, 0.9));
    }
    const bool apart = std::ranges::all_of(roles_, [](const Role& r) { return r.constant; });
    out.soup.vertices = soup_.vertices;
    for (std::size_t i = 0; i < soup_.triangles.size(); ++i) {
      const Role& role = roles_[part_[i]];
      const int weight = apart && role.seen ? role.weight : 1;
      if (weight == 0) continue;
      out.soup.triangles.push_back(soup_.triangles[i]);
      if (weight < 0) std::swap(out.soup.triangles.back()[1], out.soup.triangles.back()[2]);
    }
    if (apart) {
      out.hidden = hidden_parts(part_of(progress, 0.9, 1));
      return out;
    }
    return with(std::move(out), soup_, found);
  }

 private:
  /// Takes what lines found in addition to the sum over all triangles; empty where it is nothing.
  static Region with(Region out, const Soup& soup, const MassMoments (&found)[2]) {
    const double volume = std::abs(mass_by_volume(soup).measure + found[1].measure);
    if (std::abs(found[1].measure) < overlap_tuning.least * volume) return {};
    out.more = found[1];
    out.error = std::abs(found[1].measure - found[0].measure) / volume;
    return out;
  }

  /// Where the lines through all of it met no overlap: what parts that cross have in common,
  /// however little, by lines of its own.
  Region of_crossings(const Progress& progress) const {
    if (roles_.size() < 2) return {};
    const auto boxes = crossings_of_parts(soup_, part_, part_of(progress, 0, 0.5));
    if (boxes.empty()) return {};
    Region out{soup_, {}, true, 0, {}};
    const std::vector<Eigen::AlignedBox3d> bounds = bounds_of_parts();
    MassMoments found[2];
    for (MassMoments& sum : found) sum.origin = soup_.vertices[soup_.triangles[0][0]];
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      report(progress, 0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(boxes.size()));
      const Soup by_it = parts_by(boxes[i], bounds);
      for (std::size_t k = 0; k < 2; ++k)
        integrate(by_it, boxes[i], overlap_tuning.local_rasters[k], found[k]);
    }
    return with(std::move(out), soup_, found);
  }

  std::vector<Eigen::AlignedBox3d> bounds_of_parts() const {
    std::vector<Eigen::AlignedBox3d> bounds(roles_.size());
    for (std::size_t i = 0; i < part_.size(); ++i)
      for (const std::uint32_t v : soup_.triangles[i]) bounds[part_[i]].extend(soup_.vertices[v]);
    return bounds;
  }

  /// The parts whose bounds meet a box: the others are not around any point of it.
  Soup parts_by(const Eigen::AlignedBox3d& box,
                const std::vector<Eigen::AlignedBox3d>& bounds) const {
    Soup out{soup_.vertices, {}};
    for (std::size_t i = 0; i < part_.size(); ++i)
      if (bounds[part_[i]].intersects(box)) out.triangles.push_back(soup_.triangles[i]);
    return compacted(std::move(out));
  }

  /// Adds (winding number ≠ 0) − (winding number) within a box, by lines through it.
  void integrate(const Soup& soup, const Eigen::AlignedBox3d& box, int count,
                 MassMoments& sum) const {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d frame = line_frame(k);
      Eigen::AlignedBox2d across;
      for (int i = 0; i < 8; ++i)
        across.extend(Eigen::Vector2d(
            (frame * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))).head<2>()));
      const double size = across.sizes().maxCoeff();
      if (!(size > 0)) return;
      const Lines lines(soup, frame, count, across.min(), size);
      lines.each([&](std::size_t i, std::span<const LineHit> hits) {
        each_missing(hits, [&](double from, double to, int missing) {
          if (clip(lines, i, box, from, to)) add(sum, lines, frame, i, from, to, missing);
        });
        return true;
      });
    }
  }

  /// Of a line, what of it between two places lies in a box; false if nothing does.
  static bool clip(const Lines& lines, std::size_t line, const Eigen::AlignedBox3d& box,
                   double& from, double& to) {
    const Vec3 at = lines.point(line, 0), way = lines.point(line, 1) - at;
    for (Eigen::Index k = 0; k < 3; ++k) {  // no line is square to an axis
      const double a = (box.min()[k] - at[k]) / way[k], b = (box.max()[k] - at[k]) / way[k];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from < to;
  }

  /// Whether winding numbers other than 0 and 1 occur over more than rounding; for an inverted
  /// region, other than 0 and -1.
  bool any_overlap(const Progress& progress) const {
    int inside = 0;
    for (int k = 0; k < 3; ++k) {
      const Lines lines(soup_, line_frame(k), overlap_tuning.first_look);
      const auto agrees = [&](std::size_t, std::span<const LineHit> all) {
        bool odd = false;
        double from = 0;
        bool found = false;
        each_step(all, rounding_, [&](std::span<const LineHit> hits, int, int next) {
          found = found || (odd && hits[0].along - from > rounding_);
          if (inside == 0 && std::abs(next) == 1) inside = next;
          odd = next != 0 && next != inside;
          from = hits.back().along;
        });
        return !found;
      };
      if (!lines.each(agrees, part_of(progress, k / 3.0, (k + 1) / 3.0))) return true;
    }
    return false;
  }

  void note(std::span<const LineHit> hits, int before, int after) {
    for (const LineHit& hit : hits) {
      Role& role = roles_[part_[hit.triangle]];
      // The front faces the line's end if the line leaves through it.
      const int front = hit.sign > 0 ? after : before, back = hit.sign > 0 ? before : after;
      const int weight = (back != 0) - (front != 0);
      role.constant = role.constant && hits.size() == 1 && (!role.seen || role.weight == weight);
      role.seen = true;
      role.weight = weight;
    }
  }

  /// Parts with the inside on both of their sides; none if the region needs one of them.
  std::vector<bool> hidden_parts(const Progress& progress) const {
    std::vector<bool> hidden(roles_.size());
    bool any = false;
    for (std::size_t p = 0; p < roles_.size(); ++p) {
      hidden[p] = roles_[p].seen && roles_[p].weight == 0;
      any = any || hidden[p];
    }
    if (!any) return {};
    for (int k = 0; k < 3; ++k) {
      const Lines lines(soup_, line_frame(k), overlap_tuning.rasters[0]);
      const auto agrees = [&](std::size_t, std::span<const LineHit> all) {
        int left = 0;
        bool differs = false, found = false;
        double from = 0;
        each_step(all, rounding_, [&](std::span<const LineHit> hits, int, int after) {
          found = found || (differs && hits[0].along - from > rounding_);
          for (const LineHit& hit : hits)
            if (!hidden[part_[hit.triangle]]) left -= hit.sign;
          differs = (left != 0) != (after != 0);
          from = hits.back().along;
        });
        return !found;
      };
      if (!lines.each(agrees, part_of(progress, k / 3.0, (k + 1) / 3.0))) return {};
    }
    return hidden;
  }

  /// Calls use(from, to, missing) where a line's winding number is neither 0 nor 1.
  template <class Use>
  void each_missing(std::span<const LineHit> hits, Use use) const {
    int total = 0;
    for (const LineHit& hit : hits) total += hit.sign;
    if (total != 0) return;
    int missing = 0;
    double from = 0;
    each_step(hits, rounding_, [&](std::span<const LineHit> at, int, int after) {
      if (missing != 0) use(from, at[0].along, missing);
      missing = (after != 0) - after;
      from = at.back().along;
    });
  }

  static void add(MassMoments& sum, const Lines& lines, const Eigen::Matrix3d& frame,
                  std::size_t line, double from, double to, int missing) {
    const Vec3 way = frame.row(2).transpose();
    const double section = lines.pixel() * lines.pixel() / 3, length = to - from;
    const Vec3 middle = lines.point(line, from + length / 2) - sum.origin;
    const double m = missing * section * length;
    sum.measure += m;
    sum.first += m * middle;
    sum.second += m * (middle * middle.transpose() + length * length / 12 * way * way.transpose());
  }

  MassMoments integrate(int count, const Progress& progress) {
    MassMoments sum;
    sum.origin = soup_.vertices[soup_.triangles[0][0]];
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d frame = line_frame(k);
      const Lines lines(soup_, frame, count);
      const auto use = [&](std::size_t i, std::span<const LineHit> hits) {
        int total = 0;
        for (const LineHit& hit : hits) total += hit.sign;
        if (total != 0) return true;
        each_step(hits, rounding_, [&](std::span<const LineHit> at, int before, int after) {
          note(at, before, after);
        });
        each_missing(hits, [&](double from, double to, int missing) {
          add(sum, lines, frame, i, from, to, missing);
        });
        return true;
      };
      lines.each(use, part_of(progress, k / 3.0, (k + 1) / 3.0));
    }
    return sum;
  }

  const Soup& soup_;
  const std::vector<std::uint32_t>& part_;
  double rounding_;
  std::vector<Role> roles_;
};

}  // namespace

Region find_region(const Soup& soup, const std::vector<std::uint32_t>& part,
                   const Progress& progress) {
  return Regions(soup, part).run(progress);
}

MassProperties mass_of(const Region& region, const Progress& progress) {
  return mass_by_volume(region.soup, progress, region.more);
}

}  // namespace sonde
