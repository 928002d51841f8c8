// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/region_mass.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/joints.hpp"
#include "engine/mending/line_sums.hpp"

namespace sonde {
namespace {

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
    LineSums found[2];
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
    Region whole = with(std::move(out), soup_, found);
    // Few of the lines meet what is thin. A part alone has nothing twice but where it crosses
    // itself.
    if (roles_.size() > 1 || is_resolved(found)) return whole;
    Region finer = of_crossings(part_of(progress, 0.9, 1));
    const bool better = finer.overlaps && !finer.unknown && finer.error < whole.error;
    return better || !whole.overlaps ? finer : whole;
  }

 private:
  /// Whether what lines found is known to a small part of it.
  static bool is_resolved(const LineSums (&found)[2]) {
    return error_of(found[0], found[1]) < 0.05 * std::abs(found[1].sum.measure);
  }

  /// Takes what lines found in addition to the sum over all triangles; empty where it is nothing.
  static Region with(Region out, const Soup& soup, const LineSums (&found)[2]) {
    const MassMoments& more = found[1].sum;
    const double volume = std::abs(mass_by_volume(soup).measure + more.measure);
    if (std::abs(more.measure) < overlap_tuning.least * volume) return {};
    out.more = more;
    out.error = error_of(found[0], found[1]) / volume;
    out.differ = std::abs(more.measure - found[0].sum.measure) / volume;
    return out;
  }

  /// Where the lines through all of it met no overlap: what is there twice where parts cross each
  /// other or themselves, however little.
  Region of_crossings(const Progress& progress) const {
    Soup soup = soup_;
    const double volume = mass_by_volume(soup).measure;
    if (volume < 0)  // all of it is inside out, and winding number -1 is the inside
      for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
    const Joints joints = find_joints(soup, part_, std::abs(volume), rounding_, progress);
    Region out;
    out.soup = soup;
    out.overlaps = true;
    out = joints.any ? with(std::move(out), soup, joints.sums) : Region{};
    out.unknown = !joints.complete;
    return out;
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

  LineSums integrate(int count, const Progress& progress) {
    LineSums sums;
    sums.sum.origin = soup_.vertices[soup_.triangles[0][0]];
    for (int k = 0; k < 3; ++k) {
      const Lines lines(soup_, line_frame(k), count);
      const auto use = [&](std::size_t i, std::span<const LineHit> hits) {
        int total = 0;
        for (const LineHit& hit : hits) total += hit.sign;
        if (total != 0) return true;
        each_step(hits, rounding_, [&](std::span<const LineHit> at, int before, int after) {
          note(at, before, after);
        });
        each_missing(hits, rounding_, [&](double from, double to, int missing) {
          sums.add(lines, k, i, from, to, missing);
        });
        return true;
      };
      lines.each(use, part_of(progress, k / 3.0, (k + 1) / 3.0));
    }
    return sums;
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
