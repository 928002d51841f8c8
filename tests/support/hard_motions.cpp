// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/hard_motions.hpp"

#include <array>
#include <cmath>

#include "engine/proximity/queries/placement.hpp"
#include "tests/support/exact_reference.hpp"

namespace sonde::test {
namespace {

using Kind = HardMotion::Kind;

double size_of(const BodyPair& pair) { return pair.a->mass.radius + pair.b->mass.radius; }

double power_of_ten(std::mt19937_64& random, double low, double high) {
  return std::pow(10.0, uniform(random, low, high));
}

Vec3 place_on_surface(const Body& body, std::mt19937_64& random) {
  const auto t =
      corners(body.soup, static_cast<std::uint32_t>(random() % body.soup.triangles.size()));
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
  return t[0] + u * (t[1] - t[0]) + (1 - u) * v * (t[2] - t[0]);
}

/// Foremost corner of a body turned by q, along n.
Vec3 foremost(const Body& body, const Quat& q, const Vec3& n) {
  Vec3 best = q * body.soup.vertices[0];
  for (const Vec3& x : body.soup.vertices)
    if (n.dot(q * x) > n.dot(best)) best = q * x;
  return best;
}

struct Contact {
  Pose X;
  Vec3 normal;  // the plane between, where there is one
};

/// A place of one on a place of the other; or, seen along a normal, next to each other, `gap`
/// apart.
Contact contact(const BodyPair& pair, const Quat& q, std::optional<double> gap,
                std::mt19937_64& random) {
  const Vec3 n =
      (random() % 2 ? Vec3(Vec3::Unit(random() % 3)) : random_in_ball(random, 1)).normalized();
  if (!gap)
    return {{q, place_on_surface(*pair.b, random) - q * place_on_surface(*pair.a, random)}, n};
  const Vec3 base_b = foremost(*pair.b, Quat::Identity(), n);
  return {{q, base_b - foremost(*pair.a, q, -n) + *gap * n}, n};
}

Vec3 in_chart(const MassProperties& mass, const Vec3& v) {
  return 2 * mass.inertia.cwiseSqrt().cwiseProduct(v);
}

/// The way of a motion: by how much v and the centre of mass change on it.
struct Way {
  Vec3 v = Vec3::Zero(), t = Vec3::Zero();
};

Way way(Kind kind, double size, const Vec3& normal, std::mt19937_64& random) {
  Way w{random_in_ball(random, 0.9), random_in_ball(random, 2 * size)};
  if (kind == Kind::translation || kind == Kind::fast) w.v.setZero();
  if (kind == Kind::rotation) w.t.setZero();
  if (kind == Kind::fast) {
    w.t = power_of_ten(random, 1, 5) * size * w.t.normalized();
    if (random() % 2) w.v = random_in_ball(random, 0.5);
  }
  if (kind == Kind::tiny) {
    const double part = power_of_ten(random, -9, -3);
    w.v *= part, w.t *= part;
  }
  if (kind == Kind::sliding) {
    const double into = random() % 2 ? 0 : power_of_ten(random, -9, -3) * uniform(random, -1, 1);
    w.t += (into * size - normal.dot(w.t)) * normal;
    w.v *= random() % 2 ? 0 : power_of_ten(random, -6, 0);
  }
  if (kind == Kind::leaving && random() % 2) {
    const double part = power_of_ten(random, -6, 0);
    w.v *= part, w.t *= part;
  }
  return w;
}

/// Shortens the turn of `way` until both ends stay within |v| = 0.95.
void stay_in_chart(const Vec3& v, double back, Vec3& way) {
  while ((v - back * way).norm() > 0.95 || (v + (1 - back) * way).norm() > 0.95) way *= 0.8;
}

std::optional<HardMotion> attempt(Kind kind, const BodyPair& pair, std::mt19937_64& random) {
  const double size = size_of(pair);
  const bool from_near = kind == Kind::leaving || kind == Kind::sliding || kind == Kind::tiny;
  std::optional<double> gap;
  if (from_near)
    gap = size * power_of_ten(random, -12, -2);
  else if (random() % 3 == 0)
    gap = size * uniform(random, -1, 1) * power_of_ten(random, -10, -1);  // grazing
  const Quat q = random() % 3 ? random_rotation(random) : Quat(Quat::Identity());
  const Contact at = contact(pair, q, gap, random);
  // The device pose is turned away from the contact by v, which is then where the path passes.
  const Vec3 v = random() % 3 == 0 ? Vec3(Vec3::Zero())
                                   : random_in_ball(random, kind == Kind::turning_far ? 0.9 : 0.6);
  Vec6 away = Vec6::Zero();
  away.head<3>() = in_chart(pair.a->mass, -v);
  const Chart chart(pair.a->mass, Chart(pair.a->mass, at.X).pose(away));
  const Vec6 middle = chart.coordinates(at.X);
  const double back = from_near ? 0 : uniform(random, 0, 1.2);
  Way w = way(kind, size, at.normal, random);
  stay_in_chart(chart.v(middle), back, w.v);
  Vec6 step;
  step.head<3>() = in_chart(pair.a->mass, w.v);
  step.tail<3>() = w.t;
  const double clearance = size * power_of_ten(random, -8, -2);
  HardMotion out{chart, middle - back * step, middle + (1 - back) * step, clearance, back};
  const Placed a(*pair.a, out.motion().at(0)), b(*pair.b, {});
  if (any_meet(a, b)) return {};
  return out;
}

}  // namespace

std::optional<HardMotion> hard_motion(Kind kind, const BodyPair& pair, std::mt19937_64& random) {
  for (int tries = 0; tries < 30; ++tries)
    if (auto found = attempt(kind, pair, random)) return found;
  return {};
}

const char* name(Kind kind) {
  constexpr std::array<const char*, HardMotion::kinds> names = {
      "translation", "rotation", "screw", "turning far", "tiny", "fast", "leaving", "sliding"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace sonde::test
