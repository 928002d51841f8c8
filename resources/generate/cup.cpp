// SPDX-License-Identifier: GPL-3.0-or-later
// The cup: a solid of revolution about z, 9 cm high, with a handle grown out of its wall.
#include "resources/generate/cup.hpp"

#include <algorithm>
#include <cmath>

#include "resources/generate/mesh.hpp"

namespace sonde::generate {
namespace {

constexpr int cup_sides = 72;
constexpr double cup_height = 0.090;
constexpr double cup_wall = 0.0036;
constexpr double cup_rim = 0.041;  ///< outer radius under the rim

/// Outer radius of the wall at a height: a little belly, narrower at the foot.
double outer_radius(double z) {
  const double s = z / cup_height;
  return 0.0285 + (cup_rim - 0.0285) * std::sin(s * 1.5) / std::sin(1.5);
}

/// Half the section of the cup, from under the foot out, up, over the rim and down inside.
std::vector<Outline> cup_profile() {
  Outline foot = {{0.004, 0.0030}, {0.021, 0.0030}, {0.0225, 0.0022}, {0.0235, 0.0008}};
  add_arc(foot, {0.0258, 0.0018}, 0.0018, -std::numbers::pi / 2 - 0.5, 0.1, 6);
  Outline outside;
  for (int i = 0; i <= 60; ++i) {
    const double z = 0.0040 + (cup_height - 0.0020 - 0.0040) * i / 60;
    outside.push_back({outer_radius(z), z});
  }
  Outline rim;
  add_arc(rim, {cup_rim - cup_wall / 2, cup_height - cup_wall / 2}, cup_wall / 2, 0.15,
          std::numbers::pi - 0.15, 8);
  Outline inside;
  for (int i = 0; i <= 60; ++i) {
    const double z = cup_height - 0.0022 - (cup_height - 0.0022 - 0.0160) * i / 60;
    inside.push_back({outer_radius(z) - cup_wall, z});
  }
  Outline floor;
  const double corner = outer_radius(0.0160) - cup_wall;
  for (int i = 1; i <= 20; ++i) {  // a quarter of an ellipse from the wall to the floor
    const double a = std::numbers::pi / 2 * i / 20;
    floor.push_back({corner - 0.014 * (1 - std::cos(a)), 0.0160 - 0.0095 * std::sin(a)});
  }
  floor.push_back({0.003, 0.0065});
  return {resample(foot, 12), resample(outside, 27), rim, resample(inside, 22),
          resample(floor, 13)};
}

Ring circle(double radius, double z) {
  Ring ring;
  for (int i = 0; i < cup_sides; ++i) {
    const double a = two_pi * i / cup_sides;
    ring.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
  return ring;
}

/// A window in the outer wall: rows and columns of the grid of rings, both ends included.
struct Window {
  int row = 0;
  int rows = 0;     ///< quads
  int columns = 4;  ///< quads, centred on the +x axis
  int half() const { return columns / 2; }
};

std::uint32_t grid_index(int row, int column) {
  return static_cast<std::uint32_t>(row * cup_sides + (column + cup_sides) % cup_sides);
}

/// The vertices round a window, anticlockwise seen from outside the cup, from its lowest left one.
std::vector<std::uint32_t> border(const Window& w) {
  std::vector<std::uint32_t> out;
  for (int c = -w.half(); c < w.half(); ++c) out.push_back(grid_index(w.row, c));
  for (int r = 0; r < w.rows; ++r) out.push_back(grid_index(w.row + r, w.half()));
  for (int c = w.half(); c > -w.half(); --c) out.push_back(grid_index(w.row + w.rows, c));
  for (int r = w.rows; r > 0; --r) out.push_back(grid_index(w.row + r, -w.half()));
  return out;
}

void cut(Soup& cup, const Window& w) {
  const auto inside = [&](std::uint32_t vertex) {
    const int row = static_cast<int>(vertex) / cup_sides;
    int column = static_cast<int>(vertex) % cup_sides;
    if (column > cup_sides / 2) column -= cup_sides;
    return row >= w.row && row <= w.row + w.rows && std::abs(column) <= w.half();
  };
  std::erase_if(cup.triangles,
                [&](const Triangle& t) { return inside(t[0]) && inside(t[1]) && inside(t[2]); });
}

/// Moves the corners of a window's border along the wall, so that it becomes an ellipse.
void round_off(Soup& cup, const std::vector<std::uint32_t>& border) {
  double low = cup_height, high = 0, half_angle = 0;
  for (const std::uint32_t v : border) {
    const Vec3& x = cup.vertices[v];
    low = std::min(low, x.z());
    high = std::max(high, x.z());
    half_angle = std::max(half_angle, std::atan2(x.y(), x.x()));
  }
  for (const std::uint32_t v : border) {
    Vec3& x = cup.vertices[v];
    const double across = std::atan2(x.y(), x.x()) / half_angle;
    const double up = (2 * x.z() - low - high) / (high - low);
    const double to_ellipse = 1 / std::hypot(across, up);
    const double angle = across * to_ellipse * half_angle;
    const double z = (low + high + up * to_ellipse * (high - low)) / 2;
    x = {outer_radius(z) * std::cos(angle), outer_radius(z) * std::sin(angle), z};
  }
}

/// The middle line of the handle in the plane y = 0 (x, z), from the lower window to the upper one.
Point2 handle_line(double s, Point2 low, Point2 high) {
  const Point2 a = {0.074, low.y - 0.004};
  const Point2 b = {0.082, high.y + 0.010};
  const double u = 1 - s;
  const double w0 = u * u * u, w1 = 3 * u * u * s, w2 = 3 * u * s * s, w3 = s * s * s;
  return {w0 * low.x + w1 * a.x + w2 * b.x + w3 * high.x,
          w0 * low.y + w1 * a.y + w2 * b.y + w3 * high.y};
}

/// How much of the window's shape is left at a distance s from it: falls steeply, for a soft
/// fillet.
double flare(double s) { return std::pow(std::max(0.0, 1 - s / 0.16), 3); }

Vec3 middle_of(const Soup& cup, const std::vector<std::uint32_t>& vertices) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t v : vertices) sum += cup.vertices[v];
  return sum / static_cast<double>(vertices.size());
}

/// The vertices of the upper window in the order in which the tube from the lower one meets them:
/// seen along the tube the upper window is the lower one's mirror image, turned upside down.
std::vector<std::uint32_t> mirrored(const std::vector<std::uint32_t>& upper, const Window& w) {
  const int n = static_cast<int>(upper.size());
  std::vector<std::uint32_t> out;
  for (int i = 0; i < n; ++i)
    out.push_back(upper[static_cast<std::size_t>((2 * w.columns + w.rows - i + n) % n)]);
  return out;
}

/// A point of the handle: share s along it, at an angle round it from the middle of its lower edge.
Vec3 tube_point(const Vec3& low, const Vec3& high, double s, double angle) {
  const Point2 c = handle_line(s, {low.x(), low.z()}, {high.x(), high.z()});
  const Point2 d = handle_line(s + 1e-5, {low.x(), low.z()}, {high.x(), high.z()});
  const Vec3 along = Vec3(d.x - c.x, 0, d.y - c.y).normalized();
  const Vec3 outwards = Vec3::UnitY().cross(along);  // away from the loop's inside
  const double thick = 0.0030 + 0.0006 * std::cos(two_pi * s);
  return Vec3(c.x, 0, c.y) + 0.0052 * std::sin(angle) * Vec3::UnitY() +
         thick * std::cos(angle) * outwards;
}

void join(Soup& cup, const std::vector<std::uint32_t>& ring,
          const std::vector<std::uint32_t>& next) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = (i + 1) % ring.size();
    cup.triangles.push_back({ring[i], ring[j], next[j]});
    cup.triangles.push_back({ring[i], next[j], next[i]});
  }
}

/// Joins two windows cut in the wall by a tube: the cup with its handle is one closed surface.
void add_handle(Soup& cup, const Window& low, const Window& high) {
  const std::vector<std::uint32_t> start = border(low);
  const std::vector<std::uint32_t> end = mirrored(border(high), high);
  round_off(cup, start);
  round_off(cup, end);
  const Vec3 a = middle_of(cup, start);
  const Vec3 b = middle_of(cup, end);
  const int steps = 44;
  std::vector<std::uint32_t> previous = start;
  for (int k = 1; k < steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    const Point2 c = handle_line(s, {a.x(), a.z()}, {b.x(), b.z()});
    const Vec3 middle(c.x, 0, c.y);
    const double leave = flare(s);
    const double arrive = flare(1 - s);
    std::vector<std::uint32_t> ring;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const double angle =
          two_pi * (static_cast<double>(i) - low.half()) / static_cast<double>(start.size());
      const Vec3 from_window = cup.vertices[start[i]] + middle - a;
      const Vec3 to_window = cup.vertices[end[i]] + middle - b;
      ring.push_back(static_cast<std::uint32_t>(cup.vertices.size()));
      cup.vertices.push_back((1 - leave - arrive) * tube_point(a, b, s, angle) +
                             leave * from_window + arrive * to_window);
    }
    join(cup, previous, ring);
    previous = ring;
  }
  join(cup, previous, end);
}

}  // namespace

Soup cup_mesh() {
  std::vector<Ring> rings;
  int wall_begins = 0;
  const std::vector<Outline> profile = cup_profile();
  for (const Outline& part : profile) {
    if (&part == &profile[1]) wall_begins = static_cast<int>(rings.size());
    for (const Point2& p : part) rings.push_back(circle(p.x, p.y));
  }
  Soup cup = loft(rings, Ends::capped, Vec3(0, 0, 0.0030), Vec3(0, 0, 0.0065));
  const Window low{wall_begins + 5, 4, 4};
  const Window high{wall_begins + 18, 4, 4};
  cut(cup, low);
  cut(cup, high);
  add_handle(cup, low, high);
  return compacted(cup);
}

}  // namespace sonde::generate
