// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/defects.hpp"

#include <algorithm>
#include <cmath>
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

PolygonSoup cut_here_and_there(const PolygonSoup& soup, int one_in, double by, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PolygonSoup out{soup.points, {}};
  const auto on_side = [&](std::size_t a, std::size_t b) {
    const double at = uniform(random, 0.2, 0.8);
    out.points.push_back(
        (1 - at) * soup.points[a] + at * soup.points[b] +
        Vec3(uniform(random, -by, by), uniform(random, -by, by), uniform(random, -by, by)));
    return out.points.size() - 1;
  };
  for (Polygon t : triangulated(soup).polygons) {
    if (static_cast<int>(random() % static_cast<std::uint64_t>(one_in)) != 0) {
      out.polygons.push_back(t);
      continue;
    }
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
    const std::size_t ab = on_side(t[0], t[1]);
    out.polygons.push_back({t[0], ab, t[2]});
    if (random() % 2 == 0) {
      out.polygons.push_back({ab, t[1], t[2]});
      continue;
    }
    const std::size_t bc = on_side(t[1], t[2]);
    out.polygons.push_back({ab, t[1], bc});
    out.polygons.push_back({ab, bc, t[2]});
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

PolygonSoup lathed(const std::vector<Eigen::Vector2d>& profile, int n) {
  PolygonSoup out;
  std::vector<std::vector<std::size_t>> around;  // by corner of the profile
  for (const Eigen::Vector2d& p : profile) {
    std::vector<std::size_t>& at = around.emplace_back();
    for (int k = 0; k < n; ++k) {
      if (k == 0 || p.x() != 0)
        out.points.emplace_back(p.x() * std::cos(two_pi * k / n), p.x() * std::sin(two_pi * k / n),
                                p.y());
      at.push_back(out.points.size() - 1);
    }
  }
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const std::size_t j = (i + 1) % profile.size();
    for (std::size_t k = 0; k < around[i].size(); ++k) {
      const std::size_t l = (k + 1) % around[i].size();
      const std::size_t a = around[i][k], b = around[i][l], c = around[j][l], d = around[j][k];
      if (a != b) out.polygons.push_back({a, b, c});
      if (c != d) out.polygons.push_back({a, c, d});
    }
  }
  return out;
}

double lathed_volume(const std::vector<Eigen::Vector2d>& profile, int n) {
  double sum = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Eigen::Vector2d &p = profile[i], &q = profile[(i + 1) % profile.size()];
    sum += (q.y() - p.y()) * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x()) / 3;
  }
  return sum * n / 2 * std::sin(two_pi / n);
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
