// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/conforming.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/quilt.hpp"

namespace sonde::test {
namespace {

using Outline = std::vector<Eigen::Vector2d>;
using Ring = std::vector<Vec3>;
using Edge = std::array<std::size_t, 4>;

/// Cells along a side of a many-sided outline, whose sides are short: a face is still cut n times
/// along the axis, and a mesh of n = 40 stays below 100 000 triangles.
int across(const Cutting& cutting) { return (cutting.n + 7) / 8; }

Ring at_height(const Outline& outline, double z) {
  Ring out;
  for (const auto& p : outline) out.emplace_back(p.x(), p.y(), z);
  return out;
}

Outline scaled(const Outline& outline, double by) {
  Outline out = outline;
  for (auto& p : out) p *= by;
  return out;
}

/// The wall between two rings; it looks outwards where the second ring is above the first.
void add_wall(Quilt& quilt, const Ring& below, const Ring& above, int nu, int nv) {
  for (std::size_t i = 0; i < below.size(); ++i) {
    const std::size_t next = (i + 1) % below.size();
    quilt.patch(below[i], below[next], above[next], above[i], nu, nv);
  }
}

/// Closes a ring to a point, in its plane: outer half by patches, inner half by fans. Looks up
/// where the ring is anticlockwise from above.
void add_lid(Quilt& quilt, const Outline& outline, double z, bool up, int nu, int nv) {
  const Ring outer = at_height(outline, z), inner = at_height(scaled(outline, 0.5), z);
  const Vec3 middle(0, 0, z);
  if (up)
    add_wall(quilt, outer, inner, nu, nv);
  else
    add_wall(quilt, inner, outer, nu, nv);
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const std::size_t next = (i + 1) % inner.size();
    if (up)
      quilt.fan(inner[i], inner[next], middle, nu);
    else
      quilt.fan(inner[next], inner[i], middle, nu);
  }
}

Outline circle(double radius, int sides) {
  Outline out;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * std::numbers::pi * i / sides;
    out.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return out;
}

/// The outline thrown outwards onto a square.
Outline square_about(const Outline& inner, double half_width) {
  Outline out;
  for (const auto& p : inner) out.push_back(p * (half_width / p.cwiseAbs().maxCoeff()));
  return out;
}

/// A cross-section in x and z drawn out along y, with caps of the quadrilaterals given (indices of
/// the section's corners, anticlockwise seen from −y, as the section is).
PolygonSoup drawn_out(const Outline& section, const std::vector<Edge>& caps, double half_length,
                      const Cutting& cutting) {
  Quilt quilt(cutting);
  const int n = cutting.n;
  const auto at = [&](std::size_t i, double y) {
    const auto& p = section[i % section.size()];
    return Vec3(p.x(), y, p.y());
  };
  const double l = half_length;
  for (std::size_t i = 0; i < section.size(); ++i)
    quilt.patch(at(i + 1, -l), at(i, -l), at(i, l), at(i + 1, l), n, n);
  for (const Edge& c : caps) {
    quilt.patch(at(c[0], -l), at(c[1], -l), at(c[2], -l), at(c[3], -l), n, n);
    quilt.patch(at(c[3], l), at(c[2], l), at(c[1], l), at(c[0], l), n, n);
  }
  return quilt.take();
}

/// Where the right flank of the notch is at that height.
double flank(double z) { return notch_half_width + z * std::tan(notch_half_angle); }

constexpr double key_half_width = 0.0025;
constexpr double key_height = 0.002;
constexpr double chamfer = 0.0012;
constexpr int peg_arcs = 28;

/// A circle with a key along +x, anticlockwise.
Outline keyed_circle() {
  const double corner = std::asin(key_half_width / peg_radius);
  Outline out;
  for (int i = 0; i <= peg_arcs; ++i) {
    const double a = corner + (2 * std::numbers::pi - 2 * corner) * i / peg_arcs;
    out.emplace_back(peg_radius * std::cos(a), peg_radius * std::sin(a));
  }
  out.emplace_back(peg_radius + key_height, -key_half_width);
  out.emplace_back(peg_radius + key_height, key_half_width);
  return out;
}

/// Every side moved outwards by `offset`, parallel to itself: so the walls between two such
/// outlines are flat, and a clearance is the same everywhere.
Outline grown(const Outline& outline, double offset) {
  const std::size_t n = outline.size();
  const auto normal = [&](std::size_t i) {
    const Eigen::Vector2d side = outline[(i + 1) % n] - outline[i % n];
    return Eigen::Vector2d(side.y(), -side.x()).normalized();
  };
  Outline out;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d a = normal(i + n - 1), b = normal(i);
    out.push_back(outline[i] + offset / (1 + a.dot(b)) * (a + b));
  }
  return out;
}

}  // namespace

PolygonSoup cut_block(const Vec3& size, const Cutting& cutting) {
  Quilt quilt(cutting);
  const Vec3 h = size / 2;
  const int n = cutting.n;
  const auto at = [&](int x, int y, int z) { return Vec3(x * h.x(), y * h.y(), z * h.z()); };
  quilt.patch(at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1), n, n);
  quilt.patch(at(-1, 1, -1), at(1, 1, -1), at(1, -1, -1), at(-1, -1, -1), n, n);
  quilt.patch(at(1, -1, -1), at(1, 1, -1), at(1, 1, 1), at(1, -1, 1), n, n);
  quilt.patch(at(-1, 1, -1), at(-1, -1, -1), at(-1, -1, 1), at(-1, 1, 1), n, n);
  quilt.patch(at(1, 1, -1), at(-1, 1, -1), at(-1, 1, 1), at(1, 1, 1), n, n);
  quilt.patch(at(-1, -1, -1), at(1, -1, -1), at(1, -1, 1), at(-1, -1, 1), n, n);
  return quilt.take();
}

PolygonSoup cut_rod(double radius, double length, int sides, const Cutting& cutting) {
  Quilt quilt(cutting);
  const Outline outline = circle(radius, sides);
  const int nu = across(cutting), nv = cutting.n;
  add_wall(quilt, at_height(outline, -length / 2), at_height(outline, length / 2), nu, nv);
  add_lid(quilt, outline, length / 2, true, nu, nu);
  add_lid(quilt, outline, -length / 2, false, nu, nu);
  return quilt.take();
}

PolygonSoup cut_bored_block(double half_width, double height, double hole_radius, int sides,
                            const Cutting& cutting) {
  Quilt quilt(cutting);
  const Outline hole = circle(hole_radius, sides), square = square_about(hole, half_width);
  const double h = height / 2;
  const int nu = across(cutting), nv = cutting.n;
  add_wall(quilt, at_height(hole, h), at_height(hole, -h), nu, nv);
  add_wall(quilt, at_height(hole, -h), at_height(square, -h), nu, nu);
  add_wall(quilt, at_height(square, -h), at_height(square, h), nu, nv);
  add_wall(quilt, at_height(square, h), at_height(hole, h), nu, nu);
  return quilt.take();
}

PolygonSoup cut_notched_block(const Cutting& cutting) {
  constexpr double w = 0.04, h = 0.04, depth = 0.025;
  const double a = notch_half_width, b = flank(-depth);
  const Outline section = {{-w, -h},    {w, -h},      {w, 0},  {a, 0},
                           {b, -depth}, {-b, -depth}, {-a, 0}, {-w, 0}};
  return drawn_out(section, {{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}}, 0.04, cutting);
}

PolygonSoup cut_wedge(const Cutting& cutting) {
  constexpr double low = -0.02, high = 0.01;
  const double b = flank(low), a = flank(high);
  return drawn_out({{-b, low}, {b, low}, {a, high}, {-a, high}}, {{0, 1, 2, 3}}, 0.025, cutting);
}

PolygonSoup cut_peg(const Cutting& cutting) {
  constexpr double height = 0.035;
  Quilt quilt(cutting);
  const Outline side = keyed_circle(), tip = grown(side, -chamfer);
  const int nu = across(cutting), nv = cutting.n;
  add_lid(quilt, tip, 0, false, nu, nu);
  add_wall(quilt, at_height(tip, 0), at_height(side, chamfer), nu, nu);
  add_wall(quilt, at_height(side, chamfer), at_height(side, height), nu, nv);
  add_lid(quilt, side, height, true, nu, nu);
  return quilt.take();
}

PolygonSoup cut_socket(double clearance, const Cutting& cutting) {
  constexpr double half_width = 0.025, height = 0.03;
  Quilt quilt(cutting);
  const Outline hole = grown(keyed_circle(), clearance), mouth = grown(hole, chamfer);
  const Outline square = square_about(mouth, half_width);
  const int nu = across(cutting), nv = cutting.n;
  add_lid(quilt, hole, -socket_depth, true, nu, nu);
  add_wall(quilt, at_height(hole, -chamfer), at_height(hole, -socket_depth), nu, nv);
  add_wall(quilt, at_height(mouth, 0), at_height(hole, -chamfer), nu, nu);
  add_wall(quilt, at_height(square, 0), at_height(mouth, 0), nu, nu);
  add_wall(quilt, at_height(square, -height), at_height(square, 0), nu, nv);
  add_lid(quilt, square, -height, false, nu, nu);
  return quilt.take();
}

PolygonSoup wavy_block(WavyBlock which, int n) {
  const auto wave = [](double x, double y) { return 0.02 * std::sin(18 * x) * std::cos(14 * y); };
  Quilt quilt{Cutting{}};
  const auto at = [&](int i, int j, bool top) {
    const double x = double(i) / n - 0.5, y = double(j) / n - 0.5;
    const bool wavy = top == (which == WavyBlock::below);
    return Vec3(x, y, wavy ? wave(x, y) : top ? 0.3 : -0.3);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (const bool top : {false, true}) {
        const Vec3 a = at(i, j, top), b = at(i + 1, j, top), c = at(i + 1, j + 1, top),
                   d = at(i, j + 1, top);
        top ? quilt.patch(a, b, c, d, 1, 1) : quilt.patch(a, d, c, b, 1, 1);
      }
  const auto wall = [&](int i, int j, int to_i, int to_j) {
    quilt.patch(at(i, j, false), at(to_i, to_j, false), at(to_i, to_j, true), at(i, j, true), 1, 1);
  };
  for (int k = 0; k < n; ++k) {
    wall(k, 0, k + 1, 0);
    wall(n, k, n, k + 1);
    wall(k + 1, n, k, n);
    wall(0, k + 1, 0, k);
  }
  return quilt.take();
}

PolygonSoup repeated(const PolygonSoup& soup, int times) {
  PolygonSoup out{soup.points, {}};
  for (int i = 0; i < times; ++i)
    out.polygons.insert(out.polygons.end(), soup.polygons.begin(), soup.polygons.end());
  return out;
}

PolygonSoup turned(PolygonSoup soup, const Quat& q) {
  for (Vec3& x : soup.points) x = q * x;
  return soup;
}

}  // namespace sonde::test
