// SPDX-License-Identifier: GPL-3.0-or-later
// Parts askew at the mouth of what they fit into, a little clear of it: what holds them there is an
// optimum. Triangles of both that are hardly apart meet there edge over edge, and along many
// directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "engine/geometry/rotation.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/proximity/queries/distance.hpp"
#include "tests/engine/penetration/ways_down.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double mm = 1e-3, half = 12 * mm;

struct Mouth {
  std::string name;
  test::Section plug, hole;
  std::vector<double> plug_cuts, hole_cuts;
};

test::Section rectangle(double width, double length) {
  return {{-width / 2, -length / 2},
          {width / 2, -length / 2},
          {width / 2, length / 2},
          {-width / 2, length / 2}};
}

std::vector<Mouth> mouths() {
  using test::even_strips;
  const test::Section dovetail = test::dovetail_section(14 * mm, 12 * mm, 3 * mm),
                      key = test::keyed_section(24, 8 * mm, 10.5 * mm, 2 * mm);
  return {{"slot", rectangle(19 * mm, 30 * mm), rectangle(20 * mm, 50 * mm), {}, {}},
          {"slot in strips", rectangle(19 * mm, 30 * mm), rectangle(20 * mm, 50 * mm),
           even_strips(3), even_strips(4)},
          {"narrow slot", rectangle(5.8 * mm, 16 * mm), rectangle(6 * mm, 40 * mm), even_strips(2),
           test::random_strips(5, 3)},
          {"bore",
           test::regular_section(40, 9.5 * mm),
           test::regular_section(36, 10 * mm),
           {},
           even_strips(3)},
          {"bore of few sides",
           test::regular_section(7, 9 * mm),
           test::regular_section(11, 10 * mm),
           even_strips(2),
           {}},
          {"dovetail", dovetail, test::grown(dovetail, 0.4 * mm), {}, {}},
          {"dovetail in strips", dovetail, test::grown(dovetail, 0.4 * mm), even_strips(5),
           test::random_strips(3, 5)},
          {"key", key, test::grown(key, 0.3 * mm), {}, even_strips(2)},
          {"key in strips", key, test::grown(key, 0.3 * mm), test::random_strips(4, 8),
           test::random_strips(6, 9)}};
}

/// Askew by `tilt` (rad) about a line across the axis, `in` (m) inside, and moved aside until
/// `clear` (m) of the wall. `about` and `aside` (rad) are the directions of that.
Pose at_the_wall(const Body& plug, const Body& socket, double in, double tilt, double clear,
                 double about, double aside) {
  const Pose X{rotation_by(tilt * Vec3(std::cos(about), std::sin(about), 0)),
               Vec3(0, 0, 2 * half - in)};
  const auto moved = [&](double by) {
    return Pose{X.q, X.p + by * Vec3(std::cos(aside), std::sin(aside), 0)};
  };
  double free = 0, held = 2 * mm;
  for (int i = 0; i < 60; ++i) {
    const double at = 0.5 * (free + held);
    (distance(plug, socket, Transform(moved(at))).distance > clear ? free : held) = at;
  }
  return moved(free);
}

/// The device goes on from a free pose, straight into the parts.
struct Push {
  Pose from;
  Vec3 way, turn;
  Pose at(double share) const { return {rotation_by(share * turn) * from.q, from.p + share * way}; }
};

/// Every other one within a plane along an axis of the section, where edges stay parallel.
Push random_push(const Body& plug, const Body& socket, bool in_plane, std::mt19937_64& random) {
  using test::uniform;
  Push out;
  double about = 0;
  do {
    const double tilt = 0.02 * std::pow(4, uniform(random, -1, 1)),
                 clear = std::pow(10, uniform(random, -6, -4)), in = uniform(random, 0.2, 8) * mm;
    about = uniform(random, 0, test::two_pi);
    double aside = uniform(random, 0, test::two_pi);
    if (in_plane) {
      about = test::two_pi / 4 * static_cast<double>(random() % 4);
      aside = about + (random() % 2 ? 1 : -1) * test::two_pi / 4;
    }
    out.from = at_the_wall(plug, socket, in, tilt, clear, about, aside);
  } while (distance(plug, socket, Transform(out.from)).overlapping);
  out.way = test::random_in_ball(random, 1);
  out.turn = uniform(random, 0, 0.1) * test::random_in_ball(random, 1);
  if (in_plane) {
    const Vec3 axis(std::cos(about), std::sin(about), 0);
    out.way -= axis.dot(out.way) * axis;
    out.turn = axis.dot(out.turn) * axis;
  }
  out.way = std::pow(10, uniform(random, -3.7, -2)) * out.way.normalized();
  return out;
}

struct Found {
  int contact = 0, converged = 0, looked_at = 0;
};

/// m: how far apart the points of the contacts are, at the most.
double farthest_contact(const ContactSet& contacts) {
  double out = 0;
  for (const Contact& c : contacts) out = std::max(out, (c.on_probe - c.on_fixed).norm());
  return out;
}

/// Pushes from a mouth; every third tick that converged is looked at.
Found push_and_look(const Mouth& mouth, int pushes, int tries) {
  const auto plug = test::body(test::fitted_plug(mouth.plug, half, mouth.plug_cuts)),
             socket = test::body(test::fitted_socket(mouth.hole, 1.6, half, mouth.hole_cuts));
  const double radius = plug->mass.radius;
  std::mt19937_64 random(17);
  constexpr int ticks = 60;
  Found found;
  for (int push = 0; push < pushes; ++push) {
    const Push way = random_push(*plug, *socket, push % 2 == 1, random);
    CoherentSolver solver({plug, socket});
    solver.reset(way.at(0));
    for (int i = 1; i <= ticks; ++i) {
      const Separation& s = solver.tick(way.at(double(i) / ticks));
      if (s.status != Status::penetrating) continue;
      const std::string where =
          mouth.name + ", push " + std::to_string(push) + ", tick " + std::to_string(i);
      ++found.contact;
      found.converged += s.converged;
      if (!s.converged || s.depth < 1e-3 * radius) continue;
      EXPECT_LE(farthest_contact(s.contacts), allowed_clearance(radius, s.depth)) << where;
      if (i % 3 != 0 || tries == 0) continue;
      ++found.looked_at;
      EXPECT_EQ(test::steepest_way_down(*plug, *socket, s, tries, random), 0) << where;
    }
  }
  return found;
}

void expect_optima(int pushes, int tries) {
  for (const Mouth& mouth : mouths()) {
    const Found found = push_and_look(mouth, pushes, tries);
    EXPECT_GT(found.contact, 5 * pushes) << mouth.name;
    EXPECT_GE(found.converged, found.contact - found.contact / 500) << mouth.name;
    EXPECT_GE(found.looked_at, tries > 0 ? pushes : 0) << mouth.name;
  }
}

// What holds is touched, along whichever direction: no further than a separated pose may lie from
// contact.
TEST(Mouth, what_holds_a_part_askew_is_near) { expect_optima(24, 0); }
TEST(Mouth, what_holds_a_part_askew_leaves_no_way_down) { expect_optima(8, 30); }
TEST(Mouth, Full_what_holds_a_part_askew_leaves_no_way_down) { expect_optima(60, 100); }

}  // namespace
}  // namespace sonde
