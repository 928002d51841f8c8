// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/triangle_families.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

using Random = std::mt19937_64;

Vec3 ball(Random& random, double radius = 1) { return random_in_ball(random, radius); }
Vec3 direction(Random& random) { return ball(random).normalized(); }
double power(Random& random, double low, double high) {
  return std::pow(10.0, uniform(random, low, high));
}
Corners shuffled(Corners t, Random& random) {
  std::shuffle(t.begin(), t.end(), random);
  return t;
}
Corners triangle(Random& random) {
  const Vec3 c = ball(random);
  return {c + ball(random, 0.6), c + ball(random, 0.6), c + ball(random, 0.6)};
}
Vec3 point_of(const Corners& t, Random& random) {
  double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
}
Vec3 normal_of(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }
/// Two long edges, the third 1e-8 of them.
Corners needle(Random& random) {
  const Vec3 p = ball(random), q = ball(random);
  return shuffled({p, q, q + 1e-8 * direction(random)}, random);
}
/// Three corners nearly or exactly on a line.
Corners cap(Random& random) {
  const Vec3 p = ball(random), q = ball(random);
  const Vec3 between = p + uniform(random, -0.2, 1.2) * (q - p);
  return shuffled({p, q, between + power(random, -18, -6) * direction(random)}, random);
}
Corners segment(Random& random) {
  const Vec3 p = ball(random), q = ball(random);
  return shuffled({p, q, random() % 2 ? p : Vec3((p + q) / 2)}, random);
}
Corners point(Random& random) {
  const Vec3 p = ball(random);
  return {p, p, p};
}

TrianglePair any(Random& random) { return {triangle(random), triangle(random)}; }
TrianglePair needle_and_any(Random& random) { return {needle(random), triangle(random)}; }
TrianglePair needles(Random& random) { return {needle(random), needle(random)}; }
TrianglePair caps(Random& random) {
  return {cap(random), random() % 2 ? cap(random) : triangle(random)};
}
TrianglePair segments(Random& random) {
  return {segment(random), random() % 2 ? segment(random) : triangle(random)};
}
TrianglePair points(Random& random) {
  return {random() % 4 ? triangle(random) : point(random), point(random)};
}

/// A corner of b over the inside of a needle or cap.
TrianglePair over_a_needle(Random& random) {
  TrianglePair p{random() % 2 ? needle(random) : cap(random), {}};
  const Vec3 foot = point_of(p.a, random);
  const Vec3 up = (p.a[1] - p.a[0]).unitOrthogonal();
  p.b[0] = foot + power(random, -16, 0) * up;
  for (std::size_t i = 1; i < 3; ++i)
    p.b[i] = p.b[0] + uniform(random, 0.1, 1) * up + ball(random, 0.1);
  return {p.a, shuffled(p.b, random)};
}

/// An edge of b that leaves an edge of a at a small angle, at a small height.
TrianglePair nearly_parallel_edges(Random& random) {
  TrianglePair p = any(random);
  const Vec3 along = p.a[1] - p.a[0], up = along.unitOrthogonal();
  const Vec3 side = along.cross(up);
  const double turn = power(random, -17, -1);
  const double height = random() % 3 ? power(random, -17, 0) : 0;
  const Vec3 middle = p.a[0] + uniform(random, -0.2, 1.2) * along + height * up;
  const Vec3 way = along + turn * side;
  p.b[0] = middle - uniform(random, 0, 1) * way;
  p.b[1] = middle + uniform(random, 0, 1) * way;
  if (random() % 2) p.a[2] = p.a[0] - uniform(random, 0, 1) * up + ball(random, 0.5);
  if (random() % 2) p.b[2] = p.b[0] + uniform(random, 0, 1) * up + ball(random, 0.5);
  return {shuffled(p.a, random), shuffled(p.b, random)};
}

/// Two edges that cross at a small height, the triangles on either side of it.
TrianglePair crossing_edges(Random& random) {
  const Vec3 up = direction(random), u = up.unitOrthogonal(), w = up.cross(u);
  const double angle = power(random, -12, 0.5), height = power(random, -17, 0);
  const Vec3 v = std::cos(angle) * u + std::sin(angle) * w;
  const auto part = [&] { return uniform(random, 0.05, 1); };
  const Vec3 at = ball(random), lifted = at + height * up;
  Corners a = {at - part() * u, at + part() * u, at - part() * up + part() * w};
  Corners b = {lifted - part() * v, lifted + part() * v, lifted + part() * up + part() * u};
  return {shuffled(a, random), shuffled(b, random)};
}

TrianglePair in_one_plane(Random& random, double height) {
  TrianglePair p = any(random);
  const Vec3 n = normal_of(p.a);
  for (Vec3& x : p.b) x += (height - n.dot(x - p.a[0])) * n;
  return p;
}
TrianglePair coplanar(Random& random) { return in_one_plane(random, 0); }
TrianglePair parallel_planes(Random& random) { return in_one_plane(random, power(random, -16, 0)); }
TrianglePair shared_corner(Random& random) {
  TrianglePair p = any(random);
  p.b[random() % 3] = p.a[random() % 3];
  return p;
}
TrianglePair shared_edge(Random& random) {
  TrianglePair p = any(random);
  p.b[0] = p.a[1], p.b[1] = p.a[2];
  return {shuffled(p.a, random), shuffled(p.b, random)};
}
TrianglePair duplicate(Random& random) {
  const Corners t = random() % 2 ? triangle(random) : needle(random);
  return {t, shuffled(t, random)};
}

/// A corner of b on the face or an edge of a, or next to it.
TrianglePair touching(Random& random) {
  TrianglePair p = any(random);
  const Vec3 n = normal_of(p.a);
  const Vec3 foot = random() % 2 ? point_of(p.a, random)
                                 : Vec3(p.a[0] + uniform(random, 0, 1) * (p.a[1] - p.a[0]));
  const double lift = random() % 2 ? power(random, -17, -3) : 0;
  for (Vec3& x : p.b) x += (std::max(0.0, -2 * n.dot(x - foot))) * n;
  p.b[0] = foot + lift * n;
  return {shuffled(p.a, random), shuffled(p.b, random)};
}

/// Corners on a coarse grid: exact contacts of every kind.
TrianglePair grid(Random& random) {
  TrianglePair p;
  for (Corners* t : {&p.a, &p.b})
    for (Vec3& x : *t)
      for (int c = 0; c < 3; ++c) x[c] = static_cast<double>(random() % 4) / 2;
  return p;
}

TrianglePair large_and_small(Random& random) {
  TrianglePair p = any(random);
  const Vec3 at = point_of(p.a, random) + power(random, -9, 0) * direction(random);
  const double size = power(random, -9, -2);
  for (Vec3& x : p.b) x = at + size * ball(random);
  return p;
}

}  // namespace

std::span<const TriangleFamily> triangle_families() {
  static constexpr std::array all = {
      TriangleFamily{"any", any},
      TriangleFamily{"needle and any", needle_and_any},
      TriangleFamily{"needles", needles},
      TriangleFamily{"caps", caps},
      TriangleFamily{"over a needle", over_a_needle},
      TriangleFamily{"nearly parallel edges", nearly_parallel_edges},
      TriangleFamily{"crossing edges", crossing_edges},
      TriangleFamily{"parallel planes", parallel_planes},
      TriangleFamily{"coplanar", coplanar},
      TriangleFamily{"shared corner", shared_corner},
      TriangleFamily{"shared edge", shared_edge},
      TriangleFamily{"duplicate", duplicate},
      TriangleFamily{"touching", touching},
      TriangleFamily{"grid", grid},
      TriangleFamily{"segments", segments},
      TriangleFamily{"points", points},
      TriangleFamily{"large and small", large_and_small},
  };
  return all;
}

std::span<const TrianglePlace> triangle_places() {
  static const std::array<TrianglePlace, 4> all = {
      TrianglePlace{1, Vec3::Zero()}, TrianglePlace{1e-6, Vec3::Zero()},
      TrianglePlace{1e6, Vec3::Zero()}, TrianglePlace{1, Vec3(1e6, -2e6, 3e5)}};
  return all;
}

TrianglePair placed(const TrianglePair& pair, const TrianglePlace& place) {
  TrianglePair out = pair;
  for (Corners* t : {&out.a, &out.b})
    for (Vec3& x : *t) x = place.scale * x + place.at;
  return out;
}

double size_of(const TrianglePair& pair) {
  Vec3 low = pair.a[0], high = pair.a[0];
  for (const Corners* t : {&pair.a, &pair.b})
    for (const Vec3& x : *t) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return (high - low).maxCoeff();
}

double reach_of(const TrianglePair& pair) {
  double m = 0;
  for (const Corners* t : {&pair.a, &pair.b})
    for (const Vec3& x : *t) m = std::max(m, x.cwiseAbs().maxCoeff());
  return m;
}

}  // namespace sonde::test
