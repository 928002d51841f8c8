// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

constexpr std::size_t pairs_a_report = 4096;
/// In a closed mesh a triangle shares a corner with some twelve others; each pair counts once.
constexpr double pairs_a_triangle = 7;

class Mesh {
 public:
  explicit Mesh(const Soup& soup) : soup_(soup) {}

  bool meet(std::uint32_t first, std::uint32_t second) const {
    // Moves the shared corners to the front, in the same order.
    Triangle a = soup_.triangles[first], b = soup_.triangles[second];
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      auto* const found = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
      if (found == b.end()) continue;
      std::iter_swap(found, b.begin() + static_cast<std::ptrdiff_t>(shared));
      std::swap(a[i], a[shared++]);
    }
    switch (shared) {
      case 0:
        return CGAL::do_intersect(triangle(a), triangle(b));
      case 1:
        return CGAL::do_intersect(triangle(a), Kernel::Segment_3(point(b[1]), point(b[2]))) ||
               CGAL::do_intersect(triangle(b), Kernel::Segment_3(point(a[1]), point(a[2])));
      case 2:  // coplanar and folded onto each other
        return CGAL::coplanar(point(a[0]), point(a[1]), point(a[2]), point(b[2])) &&
               CGAL::coplanar_orientation(point(a[0]), point(a[1]), point(a[2]), point(b[2])) ==
                   CGAL::POSITIVE;
      default:
        return false;
    }
  }

  std::vector<Box> boxes() const {
    std::vector<Box> all;
    all.reserve(soup_.triangles.size());
    for (std::uint32_t i = 0; i < soup_.triangles.size(); ++i) {
      CGAL::Bbox_3 box;
      for (const auto corner : soup_.triangles[i]) box += point(corner).bbox();
      all.emplace_back(box, i);
    }
    return all;
  }

 private:
  Kernel::Point_3 point(std::uint32_t i) const {
    const Vec3& x = soup_.vertices[i];
    return {x.x(), x.y(), x.z()};
  }
  Kernel::Triangle_3 triangle(const Triangle& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  const Soup& soup_;
};

struct Enough {};

}  // namespace

void for_each_meeting(const Soup& soup,
                      const std::function<bool(std::uint32_t, std::uint32_t)>& visit,
                      const Progress& progress) {
  const Mesh mesh(soup);
  std::vector<Box> boxes = mesh.boxes();
  std::size_t looked_at = 0;
  const double expected = pairs_a_triangle * double(soup.triangles.size());
  const auto look = [&](const Box& a, const Box& b) {
    if (++looked_at % pairs_a_report == 0)
      report(progress, std::min(double(looked_at) / expected, 1.0));
    if (mesh.meet(a.info(), b.info()) && !visit(a.info(), b.info())) throw Enough{};
  };
  report(progress, 0);
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), look);
  } catch (const Enough&) {  // the visitor ended the search
  }
}

SelfIntersections self_intersections(const Soup& soup, const Progress& progress, std::size_t most) {
  std::vector<bool> meets(soup.triangles.size(), false);
  SelfIntersections found;
  for_each_meeting(
      soup,
      [&](std::uint32_t a, std::uint32_t b) {
        found.all = found.pairs < most;
        if (!found.all) return false;
        ++found.pairs;
        meets[a] = meets[b] = true;
        return true;
      },
      progress);
  for (std::uint32_t i = 0; i < meets.size(); ++i)
    if (meets[i]) found.triangles.push_back(i);
  return found;
}

}  // namespace sonde
