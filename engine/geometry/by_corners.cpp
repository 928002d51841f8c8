// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/by_corners.hpp"

#include <algorithm>

#include "engine/base/ordering.hpp"

namespace sonde {
namespace {

CornerTriangle by_corners(const Soup& soup, std::size_t i) {
  Triangle t = soup.triangles[i];
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  const bool even = t[1] < t[2];
  if (!even) std::swap(t[1], t[2]);
  return {t, static_cast<std::uint32_t>(i), even};
}

bool is_before(const CornerTriangle& x, const CornerTriangle& y) {
  if (x.corners[1] != y.corners[1]) return x.corners[1] < y.corners[1];
  if (x.corners[2] != y.corners[2]) return x.corners[2] < y.corners[2];
  return x.triangle < y.triangle;
}

}  // namespace

std::vector<CornerTriangle> triangles_by_corners(const Soup& soup, const Progress& progress) {
  const std::size_t n = soup.triangles.size();
  // Bucket sort by the lowest corner (few triangles each), then a sort within each bucket.
  std::vector<std::uint32_t> first(soup.vertices.size() + 1, 0);
  for (const Triangle& t : soup.triangles) ++first[*std::min_element(t.begin(), t.end()) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<CornerTriangle> out(n);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for_each_index(n, part_of(progress, 0, 0.5), [&](std::size_t i) {
    const CornerTriangle t = by_corners(soup, i);
    out[next[t.corners[0]]++] = t;
  });
  for_each_index(soup.vertices.size(), part_of(progress, 0.5, 1), [&](std::size_t v) {
    if (first[v + 1] - first[v] > 1)
      ordering::sort(out.begin() + first[v], out.begin() + first[v + 1], is_before);
  });
  return out;
}

}  // namespace sonde
