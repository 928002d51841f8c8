// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/rings.hpp"

#include <algorithm>

namespace sonde::test {

void wall_between_rings(PolygonSoup& soup, std::size_t n, std::size_t low, std::size_t high,
                        bool outwards) {
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    for (Polygon each : {Polygon{low + i, low + j, high + j}, {low + i, high + j, high + i}}) {
      if (!outwards) std::ranges::reverse(each);
      soup.polygons.push_back(each);
    }
  }
}

void lid_on_ring(PolygonSoup& soup, std::size_t n, std::size_t ring, const Vec3& middle,
                 bool upwards) {
  const std::size_t last = soup.points.size();
  soup.points.push_back(middle);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    soup.polygons.push_back(upwards ? Polygon{ring + i, ring + j, last}
                                    : Polygon{ring + j, ring + i, last});
  }
}

}  // namespace sonde::test
