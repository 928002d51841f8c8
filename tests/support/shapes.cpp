// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shapes.hpp"

#include <numbers>

#include "engine/base/elementary.hpp"

namespace sonde::test {
namespace {

/// A closed grid of quads, wrapping in both directions.
PolygonSoup wrapped_grid(int n, int m, const std::function<Vec3(double u, double v)>& point) {
  PolygonSoup out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) out.points.push_back(point(two_pi * i / n, two_pi * j / m));
  const auto at = [&](int i, int j) { return static_cast<std::size_t>((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      out.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.polygons.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return out;
}
}  // namespace

PolygonSoup box(const Vec3& size) {
  PolygonSoup out;
  for (int i = 0; i < 8; ++i)
    out.points.push_back(
        size.cwiseProduct(Vec3((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, (i >> 2) - 0.5)));
  out.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return out;
}

PolygonSoup sphere(double radius, int rings, int segments) {
  PolygonSoup out;
  out.points.push_back(Vec3(0, 0, radius));
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < segments; ++j) {
      const double a = std::numbers::pi * i / rings, b = two_pi * j / segments;
      out.points.push_back(radius * Vec3(elementary::sin(a) * elementary::cos(b),
                                         elementary::sin(a) * elementary::sin(b),
                                         elementary::cos(a)));
    }
  out.points.push_back(Vec3(0, 0, -radius));
  const auto at = [&](int i, int j) {
    return static_cast<std::size_t>(1 + (i - 1) * segments + j % segments);
  };
  const std::size_t south = out.points.size() - 1;
  for (int j = 0; j < segments; ++j) {
    out.polygons.push_back({0, at(1, j), at(1, j + 1)});
    out.polygons.push_back({south, at(rings - 1, j + 1), at(rings - 1, j)});
    for (int i = 1; i + 1 < rings; ++i) {
      out.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.polygons.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return out;
}

PolygonSoup torus(double major, double minor, int major_steps, int minor_steps) {
  return wrapped_grid(major_steps, minor_steps, [&](double u, double v) {
    const double r = major + minor * elementary::cos(v);
    return Vec3(r * elementary::cos(u), r * elementary::sin(u), minor * elementary::sin(v));
  });
}

PolygonSoup torus_knot(int p, int q, double major, double minor, double tube, int steps,
                       int sides) {
  const auto center = [&](double u) {
    const double r = major + minor * elementary::cos(q * u);
    return Vec3(r * elementary::cos(p * u), r * elementary::sin(p * u),
                minor * elementary::sin(q * u));
  };
  return wrapped_grid(steps, sides, [&](double u, double v) {
    const Vec3 c = center(u);
    const Vec3 tangent = (center(u + 1e-4) - center(u - 1e-4)).normalized();
    const Vec3 radial =
        (c - major * Vec3(elementary::cos(p * u), elementary::sin(p * u), 0)).normalized();
    const Vec3 side = tangent.cross(radial).normalized();
    const Vec3 up = side.cross(tangent);
    return Vec3(c + tube * (elementary::cos(v) * up - elementary::sin(v) * side));
  });
}

PolygonSoup tetrahedron(double size) {
  PolygonSoup out;
  const double s = size / 2;
  out.points = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  out.polygons = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return out;
}

PolygonSoup random_soup(std::mt19937_64& random, int n, double size) {
  PolygonSoup out;
  for (int i = 0; i < n; ++i) {
    const Vec3 c(uniform(random, -size, size) / 2, uniform(random, -size, size) / 2,
                 uniform(random, -size, size) / 2);
    for (int k = 0; k < 3; ++k) out.points.push_back(c + random_in_ball(random, size / 4));
    const std::size_t at = out.points.size();
    out.polygons.push_back({at - 3, at - 2, at - 1});
  }
  return out;
}

std::shared_ptr<const Body> body(const PolygonSoup& soup, Model model) {
  return make_body(soup, model, "test shape");
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Vec3 random_in_ball(std::mt19937_64& random, double radius) {
  for (;;) {
    const Vec3 x(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    if (x.squaredNorm() <= 1) return radius * x;
  }
}

Quat random_rotation(std::mt19937_64& random) {
  for (;;) {
    const Eigen::Vector4d x(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1),
                            uniform(random, -1, 1));
    if (x.squaredNorm() <= 1 && x.squaredNorm() > 1e-3) return Quat(x.normalized());
  }
}

}  // namespace sonde::test
