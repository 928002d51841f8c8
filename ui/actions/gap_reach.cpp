// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gap_reach.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "ui/base/format.hpp"

namespace sonde::ui {
namespace {

constexpr double near_part = 0.12;   // of the probe's radius: further away is not near
constexpr double touch_part = 1e-5;  // of it: what is nearer touches, up to the search's tolerance
constexpr double cells = 8;          // over the reach
constexpr double least_reach = 10;   // times the gap of what touches
/// So much of what is within the reach is to lie within a third of it: two bodies that touch at a
/// point have a third there, a rod that lies in a groove 0.58, at whatever scale one looks.
constexpr double most_within = 0.65;
constexpr double lower_part = 1.0 / 3;
constexpr double times_least = 5;           // at least twice the least gap, rounded down
constexpr double least_part_of_near = 0.1;  // of all that is near: less is some other detail

double next_125(double value) { return round_down_125(2.6 * value); }

/// Areas by their gaps, in the order of these.
class AreasByGap {
 public:
  void add(const GapField& field, double from, double to) {
    for (const Triangle& t : field.patch.triangles) {
      const double gap = (field.gaps[t[0]] + field.gaps[t[1]] + field.gaps[t[2]]) / 3;
      if (gap < from || gap > to) continue;
      const Vec3& a = field.patch.vertices[t[0]];
      const Vec3 ab = field.patch.vertices[t[1]] - a, ac = field.patch.vertices[t[2]] - a;
      all_.emplace_back(gap, ab.cross(ac).norm() / 2);
    }
  }
  void sort() { std::ranges::sort(all_); }
  double area_up_to(double gap) const {
    double sum = 0;
    for (const auto& [at, area] : all_) {
      if (at > gap) break;
      sum += area;
    }
    return sum;
  }

 private:
  std::vector<std::pair<double, double>> all_;
};

}  // namespace

double suited_reach(const Body& probe) { return round_down_125(near_part * probe.mass.radius); }

double gap_cell(const Body& probe, double reach) {
  return std::max(reach, suited_reach(probe)) / cells;
}

double fitted_reach(const GapField& probe, const GapField& fixed, double range, double touch) {
  AreasByGap areas;
  areas.add(probe, touch, range);
  areas.add(fixed, touch, range);
  areas.sort();
  const double all = areas.area_up_to(range);
  for (double reach = round_down_125(least_reach * touch); reach < range; reach = next_125(reach)) {
    const double area = areas.area_up_to(reach);
    if (area >= least_part_of_near * all && area > 0 &&
        areas.area_up_to(lower_part * reach) >= most_within * area)
      return reach;
  }
  return range;
}

double fitted_reach(const Body& probe, const Body& fixed, const Pose& X_FM, const Stop& stop) {
  const double suited = suited_reach(probe);
  for (double range = suited; range < probe.mass.radius; range = next_125(range)) {
    GapOptions options{.reach = range, .cell = gap_cell(probe, range)};
    GapField own = gap_field(probe, fixed, X_FM, options, stop);
    if (own.patch.triangles.empty()) continue;
    const double least = *std::ranges::min_element(own.gaps);
    options.reach = std::max(range, least > 0 ? round_down_125(times_least * least) : 0);
    options.cell = gap_cell(probe, options.reach);
    if (options.reach > range) own = gap_field(probe, fixed, X_FM, options, stop);
    const GapField other = gap_field(fixed, probe, inverse(X_FM), options, stop);
    return fitted_reach(own, other, options.reach, touch_part * probe.mass.radius);
  }
  return suited;
}

}  // namespace sonde::ui
