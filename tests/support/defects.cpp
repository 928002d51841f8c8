// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/defects.hpp"

#include <algorithm>
#include <map>
#include <random>

#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

Vec3 middle_of(const PolygonSoup& soup, const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (const std::size_t i : polygon) sum += soup.points[i];
  return sum / static_cast<double>(polygon.size());
}

}  // namespace

PolygonSoup joined(PolygonSoup a, const PolygonSoup& b, const Vec3& by) {
  const std::size_t at = a.points.size();
  for (const Vec3& x : b.points) a.points.push_back(x + by);
  for (Polygon polygon : b.polygons) {
    for (std::size_t& i : polygon) i += at;
    a.polygons.push_back(std::move(polygon));
  }
  return a;
}

PolygonSoup turned_over(PolygonSoup soup) {
  for (Polygon& polygon : soup.polygons) std::reverse(polygon.begin(), polygon.end());
  return soup;
}

PolygonSoup repeated(PolygonSoup soup, const std::vector<std::size_t>& which, bool turned) {
  for (const std::size_t i : which) {
    Polygon polygon = soup.polygons[i];
    if (turned) std::reverse(polygon.begin(), polygon.end());
    soup.polygons.push_back(std::move(polygon));
  }
  return soup;
}

PolygonSoup moved(PolygonSoup soup, const std::function<Vec3(const Vec3&)>& move) {
  for (Vec3& x : soup.points) x = move(x);
  return soup;
}

PolygonSoup placed(PolygonSoup soup, const Vec3& by) {
  for (Vec3& x : soup.points) x += by;
  return soup;
}

PolygonSoup triangulated(const PolygonSoup& soup) {
  PolygonSoup out{soup.points, {}};
  for (const Triangle& t : triangulate(soup).soup.triangles)
    out.polygons.push_back({t[0], t[1], t[2]});
  return out;
}

PolygonSoup cracked(const PolygonSoup& soup, double by, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PolygonSoup out;
  for (const Polygon& t : triangulated(soup).polygons) {
    const std::size_t at = out.points.size();
    for (const std::size_t i : t)
      out.points.push_back(soup.points[i] + Vec3(uniform(random, -by, by), uniform(random, -by, by),
                                                 uniform(random, -by, by)));
    out.polygons.push_back({at, at + 1, at + 2});
  }
  return out;
}

PolygonSoup cut_beyond(const PolygonSoup& soup, const Vec3& normal, double at, double by) {
  std::mt19937_64 random(1);
  PolygonSoup out{soup.points, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), out.points.size());
    if (is_new)
      out.points.push_back((soup.points[a] + soup.points[b]) / 2 + Vec3(uniform(random, -by, by),
                                                                        uniform(random, -by, by),
                                                                        uniform(random, -by, by)));
    return found->second;
  };
  for (const Polygon& t : triangulated(soup).polygons) {
    if (middle_of(soup, t).dot(normal) < at) {
      out.polygons.push_back(t);
      continue;
    }
    const std::size_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
    for (const Polygon& part :
         {Polygon{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}})
      out.polygons.push_back(part);
  }
  return out;
}

PolygonSoup without(const PolygonSoup& soup, const std::function<bool(const Vec3&)>& left_out) {
  PolygonSoup out = triangulated(soup);
  std::erase_if(out.polygons, [&](const Polygon& t) { return left_out(middle_of(out, t)); });
  return out;
}

PolygonSoup icosphere(double radius, int times) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  PolygonSoup out;
  out.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  out.polygons = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int k = 0; k < times; ++k) out = cut_beyond(out, Vec3::UnitX(), -1e9);
  return moved(std::move(out), [radius](const Vec3& x) { return Vec3(radius * x.normalized()); });
}

PolygonSoup prism(const std::vector<Eigen::Vector2d>& outline, double height) {
  PolygonSoup out;
  const std::size_t n = outline.size();
  for (const double z : {0.0, height})
    for (const Eigen::Vector2d& p : outline) out.points.emplace_back(p.x(), p.y(), z);
  Polygon bottom, top;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    out.polygons.push_back({i, j, n + j, n + i});
  }
  out.polygons.push_back(bottom);
  out.polygons.push_back(top);
  return out;
}

}  // namespace sonde::test
