// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/joints.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "engine/base/numbers.hpp"
#include "tests/support/rings.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

constexpr double milli = 1e-3;

/// A point of ring j at corner i.
using RingPoint = std::function<Vec3(int, int)>;

std::size_t count(int sides) { return static_cast<std::size_t>(sides); }

/// Walls between rings, from the lowest up; returns the index of the first corner.
std::size_t add_rings(PolygonSoup& soup, int sides, int rings, const RingPoint& at, bool outwards) {
  const std::size_t first = soup.points.size(), n = count(sides);
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < sides; ++i) soup.points.push_back(at(i, j));
  for (std::size_t low = first; low + 2 * n <= soup.points.size(); low += n)
    wall_between_rings(soup, n, low, low + n, outwards);
  return first;
}

Vec3 on_circle(double radius, int i, int sides, double z) {
  const double angle = two_pi * i / sides;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// A thread along z: flanks of equal slope from `root` to `tip` (m), `lead` (m) a turn.
struct Thread {
  double root = 0, tip = 0, lead = 0;
  int sides = 0;   ///< a turn
  int levels = 0;  ///< a lead
};

double thread_radius(const Thread& of, int i, double z) {
  const double turns = z / of.lead - double(i) / of.sides;
  return of.root + (of.tip - of.root) * std::abs(2 * (turns - std::floor(turns)) - 1);
}

/// `across` × `across` round studs, or wells, of so many sides, a multiple of 8; m.
struct Studs {
  int across = 0, sides = 0;
  double pitch = 0, radius = 0, height = 0;
};

/// The corners of a well's cell on a square, as many as the well has sides.
Vec3 on_square(double half, int i, int sides, double z) {
  const Vec3 x = on_circle(1, i, sides, 0);
  return Vec3(x.x(), x.y(), 0) * (half / std::max(std::abs(x.x()), std::abs(x.y()))) +
         Vec3(0, 0, z);
}

void add_cell(PolygonSoup& soup, const Studs& of, double radius, double depth, double bottom,
              const Vec3& middle) {
  const double half = of.pitch / 2;
  const auto ring = [&](double size, double z, bool square) {
    const std::size_t first = soup.points.size();
    for (int i = 0; i < of.sides; ++i)
      soup.points.push_back(
          middle + (square ? on_square(size, i, of.sides, z) : on_circle(size, i, of.sides, z)));
    return first;
  };
  const std::size_t floor = ring(radius, -depth, false), mouth = ring(radius, 0, false);
  const std::size_t edge = ring(half, 0, true), under = ring(half, bottom, true);
  wall_between_rings(soup, count(of.sides), floor, mouth, false);
  lid_on_ring(soup, count(of.sides), floor, middle + Vec3(0, 0, -depth), true);
  wall_between_rings(soup, count(of.sides), edge, mouth, true);
  lid_on_ring(soup, count(of.sides), under, middle + Vec3(0, 0, bottom), false);
}

void each_stud(const Studs& of, const std::function<void(const Vec3&, int, int)>& visit) {
  for (int i = 0; i < of.across; ++i)
    for (int j = 0; j < of.across; ++j)
      visit(of.pitch * Vec3(i - 0.5 * (of.across - 1), j - 0.5 * (of.across - 1), 0), i, j);
}

void add_box(PolygonSoup& soup, const Vec3& low, const Vec3& high) {
  const PolygonSoup added = box(high - low);
  const std::size_t first = soup.points.size();
  for (const Vec3& x : added.points) soup.points.push_back(x + (low + high) / 2);
  for (Polygon polygon : added.polygons) {
    for (std::size_t& corner : polygon) corner += first;
    soup.polygons.push_back(std::move(polygon));
  }
}

/// A sheet across x, its faces cut into `cuts` × `cuts`.
PolygonSoup sheet(double half_width, double half_thickness, int cuts) {
  PolygonSoup out;
  // A ring for each x goes once round the sheet.
  const int around = 2 * cuts;
  const auto at = [&](int i, int j) {
    const int k = i % around;
    const double share = k < cuts ? double(k) / (cuts - 1) : double(around - 1 - k) / (cuts - 1);
    return Vec3((k < cuts ? 1 : -1) * half_thickness, half_width * (2 * share - 1),
                half_width * (2.0 * j / cuts - 1));
  };
  const std::size_t first = add_rings(out, around, cuts + 1, at, true);
  const std::size_t last = first + static_cast<std::size_t>(around * cuts);
  lid_on_ring(out, count(around), first, {0, 0, -half_width}, false);
  lid_on_ring(out, count(around), last, {0, 0, half_width}, true);
  return out;
}

/// Two walls on a floor, with such a slot between them.
PolygonSoup slot(double half_width, double half_slot, double wall) {
  PolygonSoup out;
  add_box(out, {-half_slot - wall, -half_width, -half_width}, {-half_slot, half_width, half_width});
  add_box(out, {half_slot, -half_width, -half_width}, {half_slot + wall, half_width, half_width});
  add_box(out, {-half_slot - wall, -half_width, -half_width - wall},
          {half_slot + wall, half_width, -half_width});
  return out;
}

/// A cylinder about the origin, down to `below` (m) under it, with a hollow of that radius up to
/// z = `open` (m).
PolygonSoup ball_socket(double radius, int sides, int rings, double open, double below) {
  PolygonSoup out;
  const double last = std::acos(-open / radius);  // from the lowest point
  const auto at = [&](int i, int j) {
    const double angle = last * (j + 1) / rings;
    return on_circle(radius * std::sin(angle), i, sides, -radius * std::cos(angle));
  };
  const std::size_t first = add_rings(out, sides, rings, at, false);
  lid_on_ring(out, count(sides), first, {0, 0, -radius}, true);
  const std::size_t mouth = first + static_cast<std::size_t>(sides * (rings - 1));
  const auto outside = [&](int i, int j) {
    return on_circle(1.4 * radius, i, sides, j == 0 ? -below : open);
  };
  const std::size_t foot = add_rings(out, sides, 2, outside, true);
  wall_between_rings(out, count(sides), foot + static_cast<std::size_t>(sides), mouth, true);
  lid_on_ring(out, count(sides), foot, {0, 0, -below}, false);
  return out;
}

PolygonSoup bolt(const Thread& thread, double half) {
  PolygonSoup out;
  const int levels = static_cast<int>(std::lround(2 * half / thread.lead * thread.levels));
  const auto z = [&](int j) { return half * (2.0 * j / levels - 1); };
  const auto at = [&](int i, int j) {
    return on_circle(thread_radius(thread, i, z(j)), i, thread.sides, z(j));
  };
  const std::size_t first = add_rings(out, thread.sides, levels + 1, at, true);
  lid_on_ring(out, count(thread.sides), first, {0, 0, -half}, false);
  lid_on_ring(out, count(thread.sides), first + static_cast<std::size_t>(thread.sides * levels),
              {0, 0, half}, true);
  return out;
}

/// A nut about it, its thread wider by `room` (m), `outer` (m) its radius.
PolygonSoup nut(const Thread& thread, double half, double room, double outer) {
  PolygonSoup out;
  const int levels = static_cast<int>(std::lround(2 * half / thread.lead * thread.levels));
  const auto z = [&](int j) { return half * (2.0 * j / levels - 1); };
  const auto at = [&](int i, int j) {
    return on_circle(thread_radius(thread, i, z(j)) + room, i, thread.sides, z(j));
  };
  const std::size_t inside = add_rings(out, thread.sides, levels + 1, at, false);
  const auto rim = [&](int i, int j) {
    return on_circle(outer, i, thread.sides, j == 0 ? -half : half);
  };
  const std::size_t outside = add_rings(out, thread.sides, 2, rim, true);
  const auto n = static_cast<std::size_t>(thread.sides);
  wall_between_rings(out, count(thread.sides), inside, outside, true);
  wall_between_rings(out, count(thread.sides), outside + n,
                     inside + n * static_cast<std::size_t>(levels), true);
  return out;
}

/// A nut on its bolt: three leads long on nine, so that their facets match where it starts, `from`
/// leads above the middle.
FittedScene screwed(const std::string& name, const Thread& thread, double room, double from,
                    double leads, double over, std::uint64_t seed) {
  FittedPath path{from * thread.lead, (from - leads) * thread.lead, 0.3 * milli, 0.02, seed};
  path.lead = thread.lead;
  path.over = over;
  return {name, nut(thread, 1.5 * thread.lead, room, 1.8 * thread.tip),
          bolt(thread, 4.5 * thread.lead), path};
}

/// A straight channel along y in a block: from half `floor` (m) wide at z = 0 to half `mouth` at z
/// = `top`. Without a floor, a groove.
PolygonSoup channel(double floor, double mouth, double top, double length) {
  const double under = 0.5 * top, half = 1.5 * mouth;
  // About a point in the block, from which all of its section is seen.
  Section section{{-half, -under}, {half, -under}, {half, top + under}, {mouth, top + under}};
  if (floor > 0) section.emplace_back(floor, under);
  section.emplace_back(-floor, under);
  section.emplace_back(-mouth, top + under);
  section.emplace_back(-half, top + under);
  PolygonSoup out = fitted_plug(section, length / 2, {});
  for (Vec3& x : out.points) x = Vec3(x.x(), -x.z(), x.y() - under);
  return out;
}

/// On the face z = 0 of a plate.
PolygonSoup studs(const Studs& of, double plate) {
  PolygonSoup out;
  const double half = of.pitch * of.across / 2;
  add_box(out, {-half, -half, 0}, {half, half, plate});
  each_stud(of, [&](const Vec3& middle, int, int) {
    // It ends inside the plate: two bodies that overlap.
    const auto at = [&](int i, int j) {
      return Vec3(middle + on_circle(of.radius, i, of.sides, j == 0 ? -of.height : plate / 2));
    };
    const std::size_t first = add_rings(out, of.sides, 2, at, true);
    lid_on_ring(out, count(of.sides), first, middle + Vec3(0, 0, -of.height), false);
    lid_on_ring(out, count(of.sides), first + static_cast<std::size_t>(of.sides),
                middle + Vec3(0, 0, plate / 2), true);
  });
  return out;
}

/// In the face z = 0 of a plate.
PolygonSoup wells(const Studs& of, double room, double plate) {
  PolygonSoup out;
  const double bottom = -of.height - plate;
  each_stud(of, [&](const Vec3& middle, int, int) {
    add_cell(out, of, of.radius + room, of.height + room, bottom, middle);
  });
  // The sides, over the corners that the cells have there.
  const double half = of.pitch / 2;
  each_stud(of, [&](const Vec3& middle, int column, int row) {
    for (int i = 0; i < of.sides; ++i) {
      const Vec3 a = on_square(half, i, of.sides, 0), b = on_square(half, i + 1, of.sides, 0);
      const Vec3 m = (a + b) / 2;
      const bool outside = (m.x() > 0.999 * half && column == of.across - 1) ||
                           (m.x() < -0.999 * half && column == 0) ||
                           (m.y() > 0.999 * half && row == of.across - 1) ||
                           (m.y() < -0.999 * half && row == 0);
      if (!outside) continue;
      const std::size_t first = out.points.size();
      for (const Vec3& x : {a, b}) {
        out.points.push_back(middle + x + Vec3(0, 0, bottom));
        out.points.push_back(middle + x);
      }
      out.polygons.push_back({first, first + 2, first + 3});
      out.polygons.push_back({first, first + 3, first + 1});
    }
  });
  return out;
}

}  // namespace

std::vector<FittedScene> joint_scenes() {
  std::vector<FittedScene> out;
  const auto add_ball = [&](const std::string& name, double radius, double room, int sides,
                            int rings, int socket, double open, const FittedPath& path) {
    out.push_back({name, sphere(radius, rings + 1, sides),
                   ball_socket(radius + room, socket, socket / 3, open, 1.3 * radius), path});
  };
  add_ball("ball, 1 %", 10 * milli, 0.1 * milli, 34, 32, 42, -0.5 * milli,
           {14 * milli, -0.3 * milli, 1.2 * milli, 0.3, 31});
  add_ball("ball, 0.4 %", 14 * milli, 0.056 * milli, 26, 21, 50, -1 * milli,
           {20 * milli, -0.2 * milli, 0.8 * milli, 0.1, 32});
  add_ball("ball, coarse, 3 %", 8 * milli, 0.24 * milli, 15, 12, 18, -1 * milli,
           {12 * milli, -0.6 * milli, 2 * milli, 0.5, 33});
  // They roll on few corners and edges, which curve about as strongly as the way out is long.
  const auto add_egg = [&](const std::string& name, const Vec3& half, int sides, int rings,
                           const PolygonSoup& fixed, const FittedPath& path) {
    out.push_back({name, sphere(1, rings + 1, sides), fixed, path});
    for (Vec3& x : out.back().probe.points) x = x.cwiseProduct(half);
  };
  add_egg("ball of 16 in a groove", Vec3::Constant(20 * milli), 16, 10,
          channel(0, 35 * milli, 35 * milli, 160 * milli),
          {60 * milli, 20 * milli, 6 * milli, 1, 34});
  add_egg("ball of 10 in a steep groove", Vec3::Constant(9 * milli), 10, 7,
          channel(0, 9 * milli, 16 * milli, 60 * milli),
          {34 * milli, 14 * milli, 3 * milli, 1.2, 35});
  add_egg("egg of 13 in a channel", {12 * milli, 9 * milli, 15 * milli}, 13, 8,
          channel(4 * milli, 15 * milli, 14 * milli, 80 * milli),
          {40 * milli, 10 * milli, 3 * milli, 0.8, 36});
  const auto add_studs = [&](const std::string& name, const Studs& of, double room,
                             const FittedPath& path) {
    out.push_back({name, studs(of, 3 * milli), wells(of, room, 3 * milli), path});
  };
  add_studs("studs, 4 x 4", {4, 24, 8 * milli, 2.4 * milli, 3 * milli}, 0.05 * milli,
            {5 * milli, -0.4 * milli, 0.5 * milli, 0.02, 41});
  add_studs("studs, 3 x 3", {3, 16, 10 * milli, 3 * milli, 5 * milli}, 0.1 * milli,
            {7 * milli, 0.5 * milli, 0.8 * milli, 0.05, 42});
  add_studs("studs, 6 x 6", {6, 8, 6 * milli, 2 * milli, 2 * milli}, 0.08 * milli,
            {4 * milli, -0.5 * milli, 1 * milli, 0.03, 43});
  // On the thread from the start on: about 7 mrad a tick in 3000.
  out.push_back(screwed("nut, jammed", {4 * milli, 5 * milli, 1.5 * milli, 24, 8}, 0.06 * milli, 2,
                        1, 1.2, 51));
  out.push_back(screwed("nut, coarse, jammed", {6 * milli, 8 * milli, 4 * milli, 16, 8},
                        0.1 * milli, 2, 1, 2, 52));
  out.push_back(screwed("nut, fine, jammed", {3 * milli, 3.8 * milli, 1 * milli, 32, 6},
                        0.05 * milli, 2, 1, 1.5, 54));
  out.push_back(screwed("nut, steep, jammed", {7 * milli, 8.5 * milli, 5 * milli, 20, 10},
                        0.12 * milli, 2, 1, 1, 55));
  out.push_back(screwed("nut, loose", {5 * milli, 6.2 * milli, 2.5 * milli, 40, 10}, 0.15 * milli,
                        2, 1, 0, 53));
  const auto add_sheet = [&](const std::string& name, double thickness, double room, int cuts,
                             const FittedPath& path) {
    out.push_back({name, sheet(10 * milli, thickness / 2, cuts),
                   slot(11 * milli, thickness / 2 + room, 4 * milli), path});
  };
  add_sheet("sheet, 1 %", 1 * milli, 0.01 * milli, 9, {23 * milli, 0, 0.6 * milli, 0.06, 61});
  add_sheet("sheet, fine", 0.4 * milli, 0.02 * milli, 24,
            {23 * milli, -2 * milli, 0.8 * milli, 0.1, 62});
  add_sheet("sheet, thick", 4 * milli, 0.05 * milli, 4,
            {23 * milli, 1 * milli, 1 * milli, 0.08, 63});
  return out;
}

}  // namespace sonde::test
