// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/mending/crossings.hpp"
#include "engine/mending/region_mass.hpp"

namespace sonde {
namespace {

using Box = Eigen::AlignedBox3d;

/// Boxes with lines of their own, each of which costs about a millisecond and a look at all
/// triangles.
constexpr std::size_t most_boxes = 1000, fewest_boxes = 20, most_looks = 200'000'000;
/// Rounds in which a box may grow to hold what is there twice.
constexpr int most_growth = 12;
/// Share of the least volume that counts, which the cubes about all boxes left out may have
/// together. Of a curve along which a part crosses itself the box is but a part of what is there
/// twice, as of the end of a rod in another.
constexpr double left_out = 1e-3;
constexpr std::uint32_t not_used = std::numeric_limits<std::uint32_t>::max();

double cube_of(const Box& box) {
  const double diagonal = box.diagonal().norm();
  return diagonal * diagonal * diagonal;
}

/// Boxes that overlap as one, until none do.
std::vector<Box> apart(const std::vector<Box>& boxes) {
  std::vector<Box> out;
  for (Box box : boxes) {
    const auto overlaps = [&](const Box& other) { return other.intersects(box); };
    for (auto met = std::ranges::find_if(out, overlaps); met != out.end();
         met = std::ranges::find_if(out, overlaps)) {
      box.extend(*met);
      out.erase(met);
    }
    out.push_back(box);
  }
  return out;
}

class JointFinder {
 public:
  JointFinder(const Soup& soup, const std::vector<std::uint32_t>& part, double volume,
              double rounding)
      : soup_(soup),
        part_(part),
        volume_(volume),
        rounding_(rounding),
        number_(soup.vertices.size(), not_used) {
    for (std::size_t i = 0; i < part_.size(); ++i) {
      if (part_[i] >= bounds_.size()) bounds_.resize(part_[i] + 1);
      for (const std::uint32_t v : soup_.triangles[i]) bounds_[part_[i]].extend(soup_.vertices[v]);
    }
  }

  Joints run(const Progress& progress) {
    const Crossings found = find_crossings(soup_, part_, part_of(progress, 0, 0.5));
    out_.complete = found.complete;
    std::vector<Box> boxes = apart(large_ones(found.boxes));
    for (bool grows = !boxes.empty(); grows;) {  // those that met as they grew, as one
      const std::size_t before = boxes.size();
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        report(progress, 0.5 + 0.2 * static_cast<double>(i) / static_cast<double>(boxes.size()));
        grow(boxes[i]);
      }
      boxes = apart(boxes);
      grows = boxes.size() < before;
    }
    out_.any = !boxes.empty();
    for (LineSums& sums : out_.sums) sums.sum.origin = soup_.vertices[soup_.triangles[0][0]];
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      report(progress, 0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(boxes.size()));
      const Soup by_it = triangles_by(boxes[i]);
      for (std::size_t k = 0; k < 2; ++k)
        each_piece(by_it, boxes[i], overlap_tuning.local_rasters[k],
                   [&](const Lines& lines, int way, std::size_t line, double from, double to,
                       int missing) {
                     if (clip(lines, line, boxes[i], from, to))
                       out_.sums[k].add(lines, way, line, from, to, missing);
                   });
    }
    return out_;
  }

 private:
  /// Without those too small to matter together, and as many as can be looked at: if others are
  /// left out, it is incomplete.
  std::vector<Box> large_ones(const std::vector<Box>& boxes) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::size_t i) { return cube_of(boxes[i]); });
    const double least = left_out * overlap_tuning.least * volume_;
    for (double left = 0; !order.empty(); order.pop_back())
      if ((left += cube_of(boxes[order.back()])) >= least) break;
    const std::size_t most =
        std::clamp(most_looks / std::max<std::size_t>(1, part_.size()), fewest_boxes, most_boxes);
    if (order.size() > most) {
      out_.complete = false;
      order.resize(most);
    }
    ordering::sort(order.begin(), order.end());
    std::vector<Box> out;
    out.reserve(order.size());
    for (const std::size_t i : order) out.push_back(boxes[i]);
    return out;
  }

  /// The triangles of parts whose bounds meet a box: the others are not around any point of it.
  Soup triangles_by(const Box& box) {
    Soup out;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      if (!bounds_[part_[i]].intersects(box)) continue;
      Triangle t = soup_.triangles[i];
      for (std::uint32_t& v : t) v = number(v, out);
      out.triangles.push_back(t);
    }
    for (const std::uint32_t v : used_) number_[v] = not_used;
    used_.clear();
    return out;
  }

  std::uint32_t number(std::uint32_t v, Soup& out) {
    if (number_[v] == not_used) {
      number_[v] = static_cast<std::uint32_t>(out.vertices.size());
      out.vertices.push_back(soup_.vertices[v]);
      used_.push_back(v);
    }
    return number_[v];
  }

  /// Calls use(lines, direction, line, from, to, missing) for what lines through a box meet.
  template <class Use>
  void each_piece(const Soup& soup, const Box& box, int count, Use use) const {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d frame = line_frame(k);
      Eigen::AlignedBox2d across;
      for (int i = 0; i < 8; ++i)
        across.extend(
            Eigen::Vector2d((frame * box.corner(static_cast<Box::CornerType>(i))).head<2>()));
      const double size = across.sizes().maxCoeff();
      if (!(size > 0)) return;
      const Lines lines(soup, frame, count, across.min(), size);
      lines.each([&](std::size_t i, std::span<const LineHit> hits) {
        each_missing(hits, rounding_, [&](double from, double to, int missing) {
          use(lines, k, i, from, to, missing);
        });
        return true;
      });
    }
  }

  /// Grows a box until no line through it leaves it where something is there twice.
  void grow(Box& box) {
    Soup by_it = triangles_by(box);
    const double slack = 1e-6 * box.diagonal().norm();
    for (int round = 0; round < most_growth; ++round) {
      Box wanted = box;
      each_piece(by_it, box, overlap_tuning.local_rasters[0],
                 [&](const Lines& lines, int, std::size_t line, double from, double to, int) {
                   double first = from, last = to;
                   if (!clip(lines, line, box, first, last)) return;
                   if (from < first - slack) wanted.extend(lines.point(line, from));
                   if (to > last + slack) wanted.extend(lines.point(line, to));
                 });
      if (box.contains(wanted)) return;
      box = wanted;
      by_it = triangles_by(box);
    }
    out_.complete = false;
  }

  /// Of a line, what of it between two places lies in a box; false if nothing does.
  static bool clip(const Lines& lines, std::size_t line, const Box& box, double& from, double& to) {
    const Vec3 at = lines.point(line, 0), way = lines.point(line, 1) - at;
    for (Eigen::Index k = 0; k < 3; ++k) {  // no line is square to an axis
      const double a = (box.min()[k] - at[k]) / way[k], b = (box.max()[k] - at[k]) / way[k];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from < to;
  }

  const Soup& soup_;
  const std::vector<std::uint32_t>& part_;
  double volume_, rounding_;
  std::vector<Box> bounds_;            // by part
  std::vector<std::uint32_t> number_;  // by vertex, in the triangles by a box
  std::vector<std::uint32_t> used_;    // vertices that have one
  Joints out_;
};

}  // namespace

Joints find_joints(const Soup& soup, const std::vector<std::uint32_t>& part, double volume,
                   double rounding, const Progress& progress) {
  return JointFinder(soup, part, volume, rounding).run(progress);
}

}  // namespace sonde
