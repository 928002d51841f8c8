// SPDX-License-Identifier: GPL-3.0-or-later
// References: the gradient of the spring's energy, which the same Jacobian makes of y; the exact
// derivative of the separation on a plane; the definition of a Rayleigh function, whose power is
// never above 0; a dashpot on a wall.
#include "engine/haptics/coupling/object_damper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/geometry/random.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupler.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/sensitivity/wrench_derivative.hpp"
#include "tests/engine/haptics/coupling/exact_separation_jacobian.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double sway_tick = 1e-3, sway_damping = 3;

/// A path that sways slowly, deep in the contact: sums of sines of random phase.
class Sway {
 public:
  Sway(std::uint64_t seed, const Vec3& at, double reach) : at_(at), reach_(reach) {
    Random random(seed);
    for (double& phase : phases_) phase = random.uniform(0, 6.28);
    for (double& rate : rates_) rate = random.uniform(1, 9);
  }
  Pose at(double t) const {
    Vec6 x;
    for (Eigen::Index i = 0; i < 6; ++i) {
      const auto n = static_cast<std::size_t>(i);
      x[i] = std::sin(phases_[n] + rates_[n] * t);
    }
    return {rotation_by(0.3 * Vec3(x.tail<3>())), at_ + reach_ * Vec3(x.head<3>())};
  }

 private:
  Vec3 at_;
  double reach_;
  double phases_[6], rates_[6];
};

struct SwayedPair {
  const char* name;
  Pair pair;
  Vec3 at;  // where the path sways
  double reach;
};

std::vector<SwayedPair> swayed_pairs() {
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  return {
      {"box, block", {test::body(test::box({0.02, 0.03, 0.05})), block}, {0, 0, 0.066}, 0.004},
      {"box, ball",
       {test::body(test::box({0.02, 0.03, 0.05})), test::body(test::sphere(0.03, 24, 32))},
       {0, 0.01, 0.045},
       0.006},
      {"torus, torus",
       {test::body(test::torus(0.04, 0.015, 16, 10)), test::body(test::torus(0.06, 0.02, 16, 10))},
       {0.01, 0, 0.024},
       0.004}};
}

Vec6 motion_between(const MassProperties& mass, const Pose& from, const Pose& to) {
  const SeparationMotion m = separation_motion(mass, from, to);
  Vec6 out;
  out << m.t, m.theta;
  return out;
}

/// Calls `look` with each separation of a swayed path, and with the device's pose before.
template <class Look>
void sway(const SwayedPair& each, std::uint64_t seed, Method method, const Look& look) {
  CoherentSolver solver(each.pair, method);
  solver.reset({Quat::Identity(), each.at + Vec3(0, 0, 0.2)});
  const Sway path(seed, each.at, each.reach);
  Pose before = solver.tick(path.at(0)).device;
  for (int i = 1; i < 2500; ++i) {
    const Separation& s = solver.tick(path.at(i * sway_tick));
    if (s.status == Status::penetrating && s.converged && !s.jumped) look(s, before);
    before = s.device;
  }
}

// The spring is the gradient of ½ k |y|², whatever bends: k Yᵀ y is its wrench.
TEST(ObjectDamper, its_jacobian_makes_the_spring_of_the_separation) {
  for (const SwayedPair& each : swayed_pairs())
    for (const Method method : {Method::pdg, Method::pdt}) {
      const MassProperties& mass = each.pair.probe().mass;
      int looked = 0;
      double worst = 0;
      sway(each, 5, method, [&](const Separation& s, const Pose&) {
        ++looked;
        const Wrench spring = object_norm_wrench(mass, s.device, s.separated, 1);
        const Vec6 y = Chart(mass, s.device).coordinates(s.separated);
        const Vec6 got = -separation_jacobian(mass, method, s).transpose() * y;
        worst = std::max(worst, (got.head<3>() - spring.force).norm() / spring.force.norm());
        worst = std::max(
            worst, (got.tail<3>() - spring.torque).norm() / (spring.force.norm() * mass.radius));
      });
      EXPECT_GT(looked, 500) << each.name;
      // The clearance, and what fades.
      EXPECT_LT(worst, 0.02) << each.name;
    }
}

struct ShareOfExact {
  double share = 0, deepest = 0;
  int looked = 0;
};

/// Of the rate that the exact derivative gives, in a path so much higher, mm.
ShareOfExact share_of_exact(double higher) {
  SwayedPair each = swayed_pairs()[0];
  each.at.z() += 1e-3 * higher;
  each.reach = 0.0005;
  const MassProperties& mass = each.pair.probe().mass;
  ShareOfExact out;
  double of_both = 0, of_exact = 0;
  sway(each, 1, Method::pdg, [&](const Separation& s, const Pose& before) {
    const WrenchDerivative d = wrench_derivative(each.pair, s);
    if (d.sides != WrenchDerivative::Sides::all) return;
    const Mat6 exact = test::exact_separation_jacobian(mass, s.device, s.separated, d.d_separated);
    const Vec6 v = motion_between(mass, before, s.device) / sway_tick;
    of_both += (separation_jacobian(mass, Method::pdg, s) * v).dot(exact * v);
    of_exact += (exact * v).squaredNorm();
    out.deepest = std::max(out.deepest, s.depth);
    ++out.looked;
  });
  out.share = of_both / of_exact;
  return out;
}

// A corner on a plane bends only by its own turn, in proportion to how deep it is: there the exact
// derivative of the separation says ever more nearly the same.
TEST(ObjectDamper, on_a_plane_its_jacobian_becomes_exact) {
  const ShareOfExact deep = share_of_exact(7.5), shallow = share_of_exact(11);
  EXPECT_GT(deep.looked, 500);
  EXPECT_GT(shallow.looked, 200);
  RecordProperty("deep", std::to_string(deep.share) + " " + std::to_string(deep.deepest));
  RecordProperty("shallow", std::to_string(shallow.share) + " " + std::to_string(shallow.deepest));
  EXPECT_LT(shallow.deepest, 0.6 * deep.deepest);
  EXPECT_LT(std::abs(1 - shallow.share), 0.6 * std::abs(1 - deep.share));
}

TEST(ObjectDamper, takes_energy_out_on_random_paths) {
  const Coupling gains{.mode = Coupling::Mode::damped, .k = 300, .b_t = sway_damping};
  for (const SwayedPair& each : swayed_pairs())
    for (const Method method : {Method::pdg, Method::pdt})
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const MassProperties& mass = each.pair.probe().mass;
        double taken = 0, given = 0, of_separation = 0;
        sway(each, seed, method, [&](const Separation& s, const Pose& before) {
          const Wrench w = object_damper(mass, method, s, before, sway_tick, gains);
          const Vec6 moved = motion_between(mass, before, s.device);
          const double done = w.force.dot(moved.head<3>()) + w.torque.dot(moved.tail<3>());
          given = std::max(given, done);
          taken -= done;
          if (method == Method::pdt) return;
          const WrenchDerivative d = wrench_derivative(each.pair, s);
          if (d.sides != WrenchDerivative::Sides::all) return;
          const Mat6 exact =
              test::exact_separation_jacobian(mass, s.device, s.separated, d.d_separated);
          of_separation += sway_damping * (exact * moved).squaredNorm() / sway_tick;
        });
        EXPECT_GT(taken, 0) << each.name;
        EXPECT_LE(given, 1e-12 * taken) << each.name << ' ' << seed;
        if (method == Method::pdg)
          RecordProperty(std::string(each.name) + std::to_string(seed),
                         std::to_string(taken / of_separation));
      }
}

/// A probe over a wall, its contact taken along by hand: depth along z, one contact at its middle.
Separation against_wall(double depth) {
  Separation s;
  s.status = Status::penetrating;
  s.device.p = Vec3(0, 0, -depth);
  s.depth = depth;
  s.contacts.push({Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(), 0, depth});
  return s;
}

Vec3 wall_force(double depth, double before, double k, double b) {
  const Coupling gains{.mode = Coupling::Mode::damped, .k = k, .b_t = b};
  Separation last = against_wall(before);
  return object_damper(MassProperties{}, Method::pdt, against_wall(depth), last.device, sway_tick,
                       gains)
      .force;
}

// b times the speed into the wall, less a thousandth that fades; none along it.
TEST(ObjectDamper, on_a_wall_it_is_a_dashpot_that_never_pulls) {
  EXPECT_NEAR(wall_force(0.003, 0.002, 100, 2).z(), 2.0, 0.005);
  EXPECT_NEAR(wall_force(0.002, 0.0025, 100, 0.2).z(), -0.1, 0.005);
  EXPECT_NEAR(wall_force(0.002, 0.003, 100, 2).z(), -0.2, 0.0003) << "the spring is 0.2 N there";
  Separation beside = against_wall(0.002);
  beside.device.p.x() = 0.001;
  const Coupling gains{.mode = Coupling::Mode::damped, .k = 100, .b_t = 2};
  const Wrench w = object_damper(MassProperties{}, Method::pdt, against_wall(0.002), beside.device,
                                 sway_tick, gains);
  EXPECT_NEAR(w.force.norm(), 0, 1e-12);
}

// Two walls at a right angle: what each pushes is the component of the force along its normal.
TEST(ObjectDamper, pulls_at_none_of_several_contacts) {
  constexpr double k = 100, depth = 0.002;
  Separation s = against_wall(depth);
  s.device.p.x() = -depth;
  s.contacts.push({Vec3::Zero(), Vec3::Zero(), Vec3::UnitX(), 0, depth});
  for (const double speed : {0.05, 0.2, 1.0}) {
    Pose before = s.device;
    before.p += Vec3(-speed, 0, speed) * sway_tick;  // out of one wall, into the other
    const Vec3 damped = object_damper(MassProperties{}, Method::pdt, s, before, sway_tick,
                                      {.mode = Coupling::Mode::damped, .k = k, .b_t = 2})
                            .force;
    EXPECT_GE(k * depth + damped.x(), -1e-9) << speed;
    EXPECT_GT(damped.z(), 0) << speed;
    EXPECT_LE(damped.dot(s.device.p - before.p), 0) << "it dissipates";
  }
}

// A rod without thickness: a turn about it moves nothing, so nothing damps it, and a pose that is
// turned about it is as deep as it was.
TEST(ObjectDamper, leaves_out_the_turn_that_moves_no_mass) {
  MassProperties rod;
  rod.inertia = {0, 1e-4, 1e-4};
  rod.radius = 0.02;
  Separation s;
  s.status = Status::penetrating;
  s.device = {rotation_by(Vec3(0.1, 0.2, 0.3)), Vec3(0, 0, -0.002)};
  s.separated = {s.device.q, Vec3(0, 0, 0)};
  s.contacts.push({s.device.q * Vec3(0.01, 1e-3, 0), Vec3::Zero(), Vec3::UnitZ(), 0, 0.002});
  const Coupling gains{.mode = Coupling::Mode::damped, .k = 100, .b_t = 2};
  const Vec3 axis = s.device.q * Vec3::UnitX();
  const auto damped = [&](const Separation& separation, const Vec3& turn) {
    Pose before = separation.device;
    before.q = rotation_by(turn).conjugate() * before.q;
    return object_damper(rod, Method::pdg, separation, before, sway_tick, gains);
  };
  EXPECT_NEAR(damped(s, 1e-3 * axis).force.norm(), 0, 1e-9);
  const Wrench across = damped(s, Vec3(0, 1e-3, 0));
  EXPECT_GT(across.force.norm(), 1e-3);
  EXPECT_NEAR(across.torque.dot(axis), 0, 1e-12);
  Separation spun = s;
  spun.device.q = s.device.q * rotation_by(Vec3(2, 0, 0));
  EXPECT_LT((damped(spun, Vec3(0, 1e-3, 0)).force - across.force).norm(),
            1e-9 * across.force.norm());
}

// A flush face may stand on two opposite corners, and a turn about the line between them then
// meets no contact. But once it has turned by a few thousandths of the depth, a third carries
// enough. Three hold the face to its plane, so the separation turns back as fast as the device
// turns: |ẏ| = √Î ω, less what fades of the third.
TEST(ObjectDamper, a_flush_face_that_rocks_is_damped) {
  const Vec3 size(0.02, 0.03, 0.05);
  const Pair pair{test::body(test::box(size)), test::body(test::box({0.3, 0.3, 0.1}))};
  const double depth = 0.002;
  const Vec3 at(0, 0, 0.075 - depth);
  CoherentSolver solver(pair, Method::pdg);
  solver.reset({Quat::Identity(), {0, 0, 0.2}});
  const auto rate_of = [&](const Vec3& axis, double angle) {
    Vec6 turn = Vec6::Zero();
    turn.tail<3>() = axis;
    const Separation& s = solver.tick({rotation_by(angle * axis), at});
    return (separation_jacobian(pair.probe().mass, Method::pdg, s) * turn).norm();
  };
  for (const double side : {1.0, -1.0}) {
    const Vec3 diagonal = Vec3(size.x(), side * size.y(), 0).normalized();
    const double arm = size.x() * size.y() / size.head<2>().norm();
    const Vec3 moments = Vec3::Constant(size.squaredNorm()) - size.cwiseAbs2();
    const double whole = std::sqrt(moments.dot(diagonal.cwiseAbs2()) / 12);
    for (const double rise : {0.003, 0.01, 0.1}) {
      EXPECT_NEAR(rate_of(diagonal, rise * depth / arm), whole, 0.06 * whole) << side * rise;
    }
    rate_of(diagonal, 0);
  }
}

// A contact that is about to be lost carries ever less: the damper has let it go before.
TEST(ObjectDamper, a_contact_that_is_taken_or_lost_makes_no_step) {
  const auto damped = [](double share) {
    Separation s = against_wall(0.002);
    const Vec3 other = Vec3(0.6, 0, 0.8);
    s.contacts.push({Vec3::Zero(), Vec3::Zero(), other, 0, share * 0.002});
    Pose before = s.device;
    before.p.x() -= 0.001;  // along the first wall, out of the second
    return Vec3(object_damper(MassProperties{}, Method::pdt, s, before, sway_tick,
                              {.mode = Coupling::Mode::damped, .k = 1e6, .b_t = 1})
                    .force);
  };
  double last = 0;
  for (const double share : {0.0, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    const double now = damped(share).norm();
    EXPECT_GE(now, last) << share;
    last = now;
  }
  EXPECT_LT(damped(1e-5).norm(), 0.01);
  EXPECT_GT(damped(1).norm(), 0.8);
}

// As the classic damper, by differences: none where the probe fell or without a time, but where it
// only catches up.
TEST(ObjectDamper, the_coupler_adds_it_to_the_spring) {
  const SwayedPair each = swayed_pairs()[1];
  const MassProperties& mass = each.pair.probe().mass;
  const Coupling plain{.k = 300, .max_force = 1e9, .max_torque = 1e9};
  Coupling gains = plain;
  gains.mode = Coupling::Mode::damped;
  gains.b_t = 2;
  Coupler damped(mass, gains), spring(mass, plain);
  int looked = 0;
  Pose last;
  sway(each, 2, Method::pdg, [&](Separation s, const Pose& before) {
    Coupler across = damped, behind = damped, at_once = damped;  // each from the last pose
    const Wrench with = damped.wrench(s, sway_tick), without = spring.wrench(s, sway_tick);
    const Wrench own = object_damper(mass, Method::pdg, s, before, sway_tick, gains);
    const bool of_last = last.p == before.p && last.q.coeffs() == before.q.coeffs();
    last = s.device;
    looked += of_last;
    if (of_last) {
      EXPECT_LE((with.force - without.force - own.force).norm(), 1e-9 * with.force.norm());
      EXPECT_LE((with.torque - without.torque - own.torque).norm(), 1e-9 * with.force.norm());
    }
    EXPECT_EQ(at_once.wrench(s, 0).force, without.force);
    s.jumped = true;
    EXPECT_EQ(across.wrench(s, sway_tick).force, without.force);
    s.lagged = true;
    EXPECT_EQ(behind.wrench(s, sway_tick).force, with.force);
  });
  EXPECT_GT(looked, 500);
}

}  // namespace
}  // namespace sonde
