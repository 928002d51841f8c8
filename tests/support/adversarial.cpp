// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/adversarial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/proximity/queries/placement.hpp"

namespace sonde::test {
namespace {

constexpr double thin = 0x1p-27;

Vec3 on_grid(const Vec3& x) {
  return {std::round(x.x() * 0x1p30) * 0x1p-30, std::round(x.y() * 0x1p30) * 0x1p-30,
          std::round(x.z() * 0x1p30) * 0x1p-30};
}

Vec3 direction_or_axis(std::mt19937_64& random) {
  if (random() % 4 == 0) return (random() % 2 ? 1.0 : -1.0) * Vec3::Unit(random() % 3);
  for (;;) {
    const Vec3 x = random_in_ball(random, 1);
    if (x.squaredNorm() > 0.01) return x.normalized();
  }
}

double log_uniform(std::mt19937_64& random, double low, double high) {
  return std::exp2(uniform(random, low, high));
}

/// Builds loose triangles corner by corner.
struct Builder {
  PolygonSoup soup;
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (const Vec3& x : {a, b, c}) soup.points.push_back(on_grid(x));
    const std::size_t n = soup.points.size();
    soup.polygons.push_back({n - 3, n - 2, n - 1});
  }
};

/// The size of a triangle in a soup of n: the soup stays neither empty nor all crossings.
double usual_size(int n) { return std::min(0.6, 1.2 / std::cbrt(static_cast<double>(n))); }

void add_loose(Builder& b, double size, std::mt19937_64& random) {
  const Vec3 c = random_in_ball(random, 1 - size);
  b.add(c + random_in_ball(random, size), c + random_in_ball(random, size),
        c + random_in_ball(random, size));
}

/// Two long sides and one of `width`; or a cap: the third corner near the middle of the long side.
void add_slim(Builder& b, const Vec3& from, const Vec3& along, double width, double where,
              std::mt19937_64& random) {
  const Vec3 side = along.cross(direction_or_axis(random) + 1e-3 * Vec3(1, 2, 3)).normalized();
  b.add(from, from + along, from + where * along + width * side);
}

void add_one(Builder& b, Family family, int n, std::mt19937_64& random) {
  const double size = usual_size(n);
  const Vec3 c = random_in_ball(random, 0.7);
  const Vec3 d = size * direction_or_axis(random);
  const double bits = static_cast<double>(random() % 19) + 10;
  switch (family) {
    case Family::needles:
      return add_slim(b, c, d, thin, static_cast<double>(random() % 2), random);
    case Family::caps:
      return add_slim(b, c, d, thin, uniform(random, 0.1, 0.9), random);
    case Family::bundle: {
      // Through the neighbourhood of one axis, so that they cross each other.
      const double angle = log_uniform(random, -27, -10);
      const Vec3 along = Vec3(1, 0, 0) + angle * random_in_ball(random, 1);
      const Vec3 from = Vec3(-0.5, 0, 0) + angle * random_in_ball(random, 1);
      return add_slim(b, from, along, log_uniform(random, -27, -2), 0.5, random);
    }
    case Family::coplanar: {
      const auto flat = [&] {
        const Vec3 x = c + random_in_ball(random, size);
        return Vec3(x.x(), x.y(), 0.125);
      };
      const Vec3 x = flat(), y = flat();
      return b.add(x, y, flat());
    }
    case Family::hinge:
      return b.add({-0.5, 0.125, 0}, {0.5, -0.25, 0.25}, c);
    case Family::fan:
      return b.add({0.25, 0, -0.125}, c, c + d);
    case Family::sheets: {
      const double z = (random() % 2 ? 1 : -1) * std::exp2(-bits);
      const double x = uniform(random, -0.5, 0.5), y = uniform(random, -0.5, 0.5);
      const double tilt = random() % 4 ? 0 : 0x1p-26;
      return b.add({x, y, z}, {x + size, y, z + tilt}, {x, y + size, z});
    }
    case Family::all_sizes:
      return add_loose(b, log_uniform(random, -22, -1), random);
    default:
      return add_loose(b, size, random);
  }
}

PolygonSoup mesh(int triangles, std::mt19937_64& random) {
  const int around = std::max(3, static_cast<int>(std::sqrt(triangles / 4.0)));
  const int along = std::max(3, triangles / (2 * around));
  PolygonSoup out = random() % 2 ? torus(0.6, 0.3, along, around)
                                 : sphere(0.9, std::max(2, along / 2 + 1), 2 * around);
  for (Vec3& x : out.points) x = on_grid(x);
  return out;
}

PolygonSoup placed_at(PolygonSoup soup, Place place, double side) {
  const double scale = place == Place::tiny ? 0x1p-20 : (place == Place::huge ? 0x1p20 : 1);
  const Vec3 by =
      place == Place::far ? Vec3(side * 0x1p20 * Vec3(1, -0.75, 0.25)) : Vec3(Vec3::Zero());
  return scaled_and_moved(std::move(soup), scale, by);
}

std::array<Vec3, 3> some_triangle(const Body& body, std::mt19937_64& random) {
  return corners(surface(body),
                 static_cast<std::uint32_t>(random() % surface(body).triangles.size()));
}

/// A corner, the middle of an edge or a point of a face, without rounding.
Vec3 place_without_rounding(const Body& body, std::mt19937_64& random) {
  const auto t = some_triangle(body, random);
  const Vec3 middle = t[0] + 0.5 * (t[1] - t[0]);
  const std::uint64_t which = random() % 3;
  if (which == 0) return t[random() % 3];
  return which == 1 ? middle : Vec3(middle + 0.5 * (t[2] - middle));
}

/// A corner that is foremost along n, of all that are.
Vec3 foremost(const Body& body, const Vec3& n, std::mt19937_64& random) {
  std::vector<Vec3> found;
  double most = -std::numeric_limits<double>::infinity();
  for (const Triangle& t : surface(body).triangles)
    for (const std::uint32_t v : t) {
      const Vec3& x = surface(body).vertices[v];
      const double h = n.dot(x);
      if (h > most) most = h, found.clear();
      if (h >= most) found.push_back(x);
    }
  return found[random() % found.size()];
}

/// A quarter turn, and the foremost corners of both along a coordinate axis put together.
Transform touching(const BodyPair& pair, double ulps, std::mt19937_64& random) {
  Transform X;
  X.R = quarter_turn(random);
  const Vec3 n = (random() % 2 ? 1.0 : -1.0) * Vec3::Unit(random() % 3);
  const Vec3 low_a = foremost(*pair.a, -(X.R.transpose() * n), random);
  X.p = foremost(*pair.b, n, random) - X.R * low_a;
  const double ulp = std::numeric_limits<double>::epsilon() * size_at(pair, X);
  X.p += ulps * std::exp2(std::ceil(std::log2(ulp))) * n;
  return X;
}

}  // namespace

const char* name(Family family) {
  constexpr std::array<const char*, families> names = {
      "loose", "needles",    "caps",   "bundle",    "coplanar", "hinge",
      "fan",   "duplicated", "sheets", "all sizes", "mesh"};
  return names[static_cast<std::size_t>(family)];
}

PolygonSoup adversarial_soup(Family family, int triangles, std::mt19937_64& random) {
  if (family == Family::mesh) return mesh(triangles, random);
  Builder b;
  while (static_cast<int>(b.soup.polygons.size()) < triangles) {
    add_one(b, family, triangles, random);
    if (family != Family::duplicated) continue;
    for (std::uint64_t copies = random() % 4; copies > 0; --copies) {
      auto again = b.soup.polygons.back();
      std::rotate(again.begin(), again.begin() + 1, again.end());
      if (copies == 2) std::swap(again[0], again[1]);
      b.soup.polygons.push_back(again);
    }
  }
  return std::move(b.soup);
}

BodyPair adversarial_pair(Family family, Place place, int triangles, std::mt19937_64& random) {
  const auto mix = static_cast<Family>(random() % families);
  const PolygonSoup a = adversarial_soup(family, triangles, random);
  const std::uint64_t second = random() % 4;
  const PolygonSoup b =
      second == 0 ? a : adversarial_soup(second == 1 ? mix : family, triangles, random);
  constexpr std::array<const char*, 4> places = {"", ", tiny", ", huge", ", far"};
  return {std::string(name(family)) + places[static_cast<std::size_t>(place)],
          body(placed_at(a, place, -1), Model::surface),
          body(placed_at(b, place, 1), Model::surface)};
}

Mat3 quarter_turn(std::mt19937_64& random) {
  std::array<int, 3> order = {0, 1, 2};
  std::shuffle(order.begin(), order.end(), random);
  Mat3 R = Mat3::Zero();
  for (int i = 0; i < 3; ++i) R(order[static_cast<std::size_t>(i)], i) = random() % 2 ? 1 : -1;
  if (R.determinant() < 0) R.col(0) = -R.col(0);
  return R;
}

double size_at(const BodyPair& pair, const Transform& X) {
  return extent(*pair.a) + extent(*pair.b) + X.p.cwiseAbs().maxCoeff();
}

HardPose hard_pose(HardPose::Kind kind, const BodyPair& pair, std::mt19937_64& random) {
  using Kind = HardPose::Kind;
  const double ulps = 1 + static_cast<double>(random() % 4);
  if (kind == Kind::touching) return {kind, touching(pair, 0, random)};
  if (kind == Kind::ulps_off) return {kind, touching(pair, ulps, random)};
  if (kind == Kind::overlapping) return {kind, touching(pair, -ulps, random)};
  Transform X;
  X.R = kind == Kind::quarter_turn ? quarter_turn(random)
                                   : random_rotation(random).toRotationMatrix();
  const double spread = random() % 2 ? 1.5 * pair.b->mass.radius : 0;
  X.p = place_without_rounding(*pair.b, random) - X.R * place_without_rounding(*pair.a, random);
  if (kind != Kind::turned_touching) X.p += random_in_ball(random, spread);
  return {kind, X};
}

}  // namespace sonde::test
