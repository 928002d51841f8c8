// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/box_pairs.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "engine/base/ordering.hpp"

namespace sonde {

std::vector<std::array<std::size_t, 2>> pairs_that_meet(const std::vector<AxisBox>& boxes) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> all;
  all.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 &low = boxes[i].low, &high = boxes[i].high;
    all.emplace_back(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), i);
  }
  std::vector<std::array<std::size_t, 2>> out;
  CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const Box& a, const Box& b) {
    out.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
  });
  ordering::sort(out);
  return out;
}

}  // namespace sonde
