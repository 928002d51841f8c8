// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/mass_rule.hpp"

#include <span>

#include "engine/geometry/by_corners.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

double area_of(const std::vector<Vec3>& x, const Triangle& t) {
  return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm() / 2;
}

/// Of the triangles with the same corners, whichever way round, the first.
Soup once_each(const Soup& soup) {
  std::vector<bool> stays(soup.triangles.size(), false);
  const std::vector<CornerTriangle> all = triangles_by_corners(soup);
  for_each_alike(
      all, [&](std::span<const CornerTriangle> alike) { stays[alike.front().triangle] = true; });
  Soup out{soup.vertices, {}};
  for (std::size_t i = 0; i < stays.size(); ++i)
    if (stays[i]) out.triangles.push_back(soup.triangles[i]);
  return out;
}

}  // namespace

double open_share(const Mended& mended, const std::vector<Vec3>& vertices) {
  double open = 0, all = 0;
  for (std::size_t i = 0; i < mended.triangles.size(); ++i) {
    if (mended.kinds[i] == TriangleKind::hidden) continue;
    const bool of_pair = mended.parts[i] == Mended::no_part;
    const double area = area_of(vertices, mended.triangles[i]) / (of_pair ? 2 : 1);
    all += area;
    if (mended.fins[i] || mended.kinds[i] == TriangleKind::loose) open += area;
  }
  return all > 0 ? open / all : 0;
}

void choose_mass(Body& body, double open_share) {
  if (!(open_share > 0)) return;
  const bool by_area = open_share > mass_rule.most_open;
  if (by_area) body.mass = mass_by_area(once_each(body.soup));
  body.mass_why = (by_area ? "by area: " : "by volume of the closed parts: ") +
                  number_text(100 * open_share, 3) + " % of the area belongs to open parts";
}

}  // namespace sonde
