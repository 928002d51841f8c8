// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/coherent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/geometry/rotation.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/real_meshes.hpp"

namespace sonde {
namespace {

std::vector<test::BodyPair> followed_pairs() {
  std::mt19937_64 random(1);
  const auto soup = [&](int n) { return test::body(test::random_soup(random, n, 0.2)); };
  const auto ring = test::body(test::torus(0.08, 0.03, 12, 8));
  const auto knot = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 30, 5));
  return {{"knot, torus", knot, ring},
          {"soup, torus", soup(20), ring},
          {"soup, soup", soup(20), soup(20)},
          {"box, knot", test::body(test::box({0.03, 0.04, 0.08})), knot},
          {"cross, star", test::real_body("cross.off"), test::real_body("star.off")},
          {"tripod, eight", test::real_body("tripod.off"),
           test::real_body("double-torus-example.off")}};
}

Pose moved(const Pose& X, const Vec3& by, const Vec3& turn) {
  return {(rotation_by(turn) * X.q).normalized(), X.p + by};
}

/// A walk drawn to the fixed body's middle, from outside; strides are shares of the bodies' size.
std::vector<Pose> walk(std::mt19937_64& random, const test::BodyPair& pair, int ticks,
                       double stride) {
  const double size = 0.5 * (pair.a->mass.radius + pair.b->mass.radius), away = 2.04 * size;
  const Quat q = test::random_rotation(random);
  const Vec3 out = away * test::random_in_ball(random, 1).normalized();
  std::vector<Pose> path = {{q, pair.b->mass.com + out - q * pair.a->mass.com}};
  const Vec3 target = pair.b->mass.com + test::random_in_ball(random, 0.3 * pair.b->mass.radius);
  for (int i = 1; i < ticks; ++i) {
    const Pose& last = path.back();
    const Vec3 to_target = target - last * pair.a->mass.com;
    const double way = std::min(1.0, stride * size / std::max(to_target.norm(), 1e-300));
    const Vec3 step = 0.7 * way * to_target + test::random_in_ball(random, 0.7 * stride * size);
    path.push_back(moved(last, step, test::random_in_ball(random, 0.7 * stride)));
  }
  return path;
}

/// m: a tick may rise by the gap that the probe aims at, and regains.
double regained(double radius, double depth) {
  return Descent::gap_of_follower * allowed_clearance(radius, depth);
}

struct Rules {
  int contacts = 0, converged = 0, out_of_steps = 0, ticks = 0;
};

/// The rules of every tick, whatever the budget. Reference for σ: second moments by integration;
/// for freedom: exact predicates on all pairs of triangles.
void follow(const test::BodyPair& pair, const std::vector<Pose>& path, const Budget& budget,
            int check_every, Rules& rules) {
  CoherentSolver solver({pair.a, pair.b});
  ASSERT_EQ(solver.reset(path[0]).status, Status::separated) << pair.name;
  const test::Moments m = test::moments(*pair.a);
  const auto metric = [&](const Pose& x, const Pose& y) {
    return std::sqrt(std::max(0.0, test::mean_squared_displacement(m, x, y)));
  };
  const double radius = pair.a->mass.radius;
  const double rounding = 1e-12 * (radius + pair.a->mass.com.norm() + path[0].p.norm());
  Separation before = solver.last();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Separation now = solver.tick(path[i], budget);
    const std::string what = pair.name + " tick " + std::to_string(i);
    ASSERT_NE(now.status, Status::failed) << what << now.reason;
    const double to_new = metric(path[i], now.separated);
    EXPECT_NEAR(to_new, now.depth, 1e-9 * now.depth + 10 * rounding) << what;
    const double from = metric(path[i], before.separated);
    const double most = from * (1 + 1e-12) + rounding + regained(radius, from);
    EXPECT_LE(to_new, most) << what;
    EXPECT_LE(now.depth, before.depth + metric(path[i - 1], path[i]) * (1 + 1e-9) + most - from)
        << what;
    if (budget.steps > 0) {
      EXPECT_LE(now.iterations, budget.steps) << what;
    }
    if (i % static_cast<std::size_t>(check_every) == 0) {
      // A surface may not be met; being swept there it has not gone inside a solid either.
      EXPECT_TRUE(test::is_free(*pair.a, *pair.b, Transform(now.separated))) << what;
    }
    ++rules.ticks;
    if (now.status == Status::penetrating) {
      ++rules.contacts;
      rules.converged += now.converged;
      rules.out_of_steps += !now.converged && now.iterations == DescentGoal{}.steps;
      if (budget.steps == 0 && budget.work == 0 && !now.converged) {
        EXPECT_GT(now.limited, 0) << what << ", " << now.iterations << " steps";
      }
      if (now.converged) {
        EXPECT_LE(now.residual * now.depth,
                  std::max(1e-4 * now.depth, 0.1 * test::promised_clearance(radius, now.depth)) *
                      (1 + 1e-9))
            << what;
        if (i % static_cast<std::size_t>(check_every) == 0)
          test::check_contacts(*pair.a, *pair.b, now, what);
      }
    } else {
      EXPECT_EQ(now.separated.p, path[i].p) << what;
      EXPECT_EQ(now.depth, 0) << what;
    }
    before = now;
  }
}

TEST(Coherent, rules_of_every_tick) {
  std::mt19937_64 random(2);
  Rules all;
  for (const auto& pair : followed_pairs())
    for (const double stride : {0.005, 0.1}) {
      Rules rules;
      follow(pair, walk(random, pair, stride < 0.01 ? 600 : 120, stride), {}, 12, rules);
      EXPECT_GT(rules.contacts, rules.ticks / 10) << pair.name << stride;
      all.contacts += rules.contacts, all.converged += rules.converged;
      all.out_of_steps += rules.out_of_steps;
    }
  // Deep among loose triangles the descent may crawl until its steps run out, and says so.
  std::printf("  %d of %d ticks in contact converged\n", all.converged, all.contacts);
  EXPECT_GE(all.converged, all.contacts * 9 / 10);
  EXPECT_GT(all.out_of_steps, 0);
}

TEST(Coherent, rules_hold_when_the_budget_runs_out) {
  std::mt19937_64 random(3);
  for (const auto& pair : followed_pairs()) {
    Rules rules;
    Budget budget;
    budget.steps = 1;
    follow(pair, walk(random, pair, 120, 0.1), budget, 12, rules);
    EXPECT_GT(rules.contacts, 10) << pair.name;
    EXPECT_LT(rules.converged, rules.contacts) << pair.name;  // or the budget was no limit
  }
}

// The effort may end within any step; whatever has been reached by then is handed out.
TEST(Coherent, rules_hold_wherever_the_work_runs_out) {
  std::mt19937_64 random(9);
  for (const auto& pair : followed_pairs())
    for (const std::int64_t work : {1, 1000, 3000, 10000}) {
      Rules rules;
      Budget budget;
      budget.work = work;
      follow(pair, walk(random, pair, 120, 0.1), budget, 12, rules);
      EXPECT_GT(rules.contacts, 10) << pair.name;
      EXPECT_LT(rules.converged, rules.contacts) << pair.name << work;  // or it was no limit
    }
}

// Reference: the residual. What one tick has no time for, the next ones do.
TEST(Coherent, a_descent_cut_short_goes_on_in_the_next_ticks) {
  std::mt19937_64 random(10);
  for (const auto& pair : followed_pairs()) {
    CoherentSolver solver({pair.a, pair.b}), twin({pair.a, pair.b});
    const auto path = walk(random, pair, 60, 0.1);
    solver.reset(path[0]), twin.reset(path[0]);
    Budget budget;
    budget.work = 6000;
    for (const Pose& X : path) {
      const Separation once = solver.tick(X, budget);
      ASSERT_EQ(once.separated.p, twin.tick(X, budget).separated.p)
          << "the same work, the same bits";
    }
    ASSERT_EQ(solver.last().status, Status::penetrating) << pair.name;
    int ticks = 0;
    for (double depth = solver.last().depth; !solver.last().converged && ticks < 2000; ++ticks) {
      const Separation& s = solver.tick(path.back(), budget);
      EXPECT_LE(s.depth, depth * (1 + 1e-12) + regained(pair.a->mass.radius, depth)) << pair.name;
      depth = s.depth;
    }
    std::printf("  %s: at rest after %d ticks\n", pair.name.c_str(), ticks);
    EXPECT_TRUE(solver.last().converged) << pair.name;
  }
}

// By hand: what holds the probe goes on holding it. One unit of work is spent before the first
// look.
TEST(Coherent, a_starved_tick_keeps_its_contacts) {
  std::mt19937_64 random(11);
  for (const auto& pair : followed_pairs())
    for (const Method method : {Method::pdg, Method::pdt}) {
      CoherentSolver solver({pair.a, pair.b}, method);
      const auto path = walk(random, pair, 120, 0.1);
      solver.reset(path[0]);
      for (const Pose& X : path) solver.tick(X);
      const Separation known = solver.last();
      ASSERT_EQ(known.status, Status::penetrating) << pair.name;
      ASSERT_GT(known.clusters.size, 0) << pair.name;
      Budget budget;
      budget.work = 1;
      const Vec3 onward =
          1e-4 * pair.a->mass.radius * (path.back().p - path.front().p).normalized();
      Pose X = path.back();
      for (int i = 0; i < 5; ++i) {
        X.p += onward;
        const Separation& s = solver.tick(X, budget);
        ASSERT_EQ(s.status, Status::penetrating) << pair.name;
        EXPECT_GT(s.contacts.size, 0) << pair.name << i;
        ASSERT_GT(s.clusters.size, 0) << pair.name << i;
        bool is_known = false;
        for (const ContactCluster& c : s.clusters)
          for (const ContactCluster& k : known.clusters) is_known |= c.id == k.id;
        EXPECT_TRUE(is_known) << pair.name << i;
      }
      // However long it starves, and it recovers with the first tick that has all it needs.
      for (int i = 0; i < 100; ++i) {
        EXPECT_GT(solver.tick(X, budget).contacts.size, 0) << pair.name << i;
      }
      EXPECT_GT(solver.tick(X).contacts.size, 0) << pair.name;
    }
}

// A tick that cannot move the probe must not move it by rounding either, which no sweep would see.
TEST(Coherent, a_probe_at_rest_stays_to_the_bit) {
  std::mt19937_64 random(13);
  for (const auto& pair : followed_pairs()) {
    CoherentSolver solver({pair.a, pair.b});
    const auto path = walk(random, pair, 60, 0.1);
    solver.reset(path[0]);
    for (const Pose& X : path) solver.tick(X);
    for (int i = 0; i < 50 && !solver.last().converged; ++i) solver.tick(path.back());
    const Separation rest = solver.last();
    ASSERT_EQ(rest.status, Status::penetrating) << pair.name;
    ASSERT_TRUE(rest.converged) << pair.name;
    for (int i = 0; i < 50; ++i) {
      const Separation& s = solver.tick(path.back());
      EXPECT_EQ(s.separated.p, rest.separated.p) << pair.name << i;
      EXPECT_EQ(s.separated.q.coeffs(), rest.separated.q.coeffs()) << pair.name << i;
    }
  }
}

// Reference: exact predicates; and with as much work as it takes the translation is at rest.
TEST(Coherent, translation_only_holds_wherever_the_work_runs_out) {
  std::mt19937_64 random(12);
  for (const auto& pair : followed_pairs())
    for (const std::int64_t work : {1, 1000, 3000}) {
      CoherentSolver solver({pair.a, pair.b}, Method::pdt), twin({pair.a, pair.b}, Method::pdt);
      const auto path = walk(random, pair, 120, 0.1);
      ASSERT_EQ(solver.reset(path[0]).status, Status::separated);
      twin.reset(path[0]);
      Budget budget;
      budget.work = work;
      int contacts = 0, converged = 0;
      for (std::size_t i = 1; i < path.size(); ++i) {
        const Separation s = solver.tick(path[i], budget);
        ASSERT_NE(s.status, Status::failed);
        EXPECT_EQ(s.separated.p, twin.tick(path[i], budget).separated.p)
            << "the same work, the same bits";
        contacts += s.status == Status::penetrating;
        converged += s.status == Status::penetrating && s.converged;
        if (s.converged) {
          EXPECT_LT(s.separated.q.angularDistance(path[i].q), 1e-7) << pair.name;
        }
        if (i % 12 == 0) {
          EXPECT_TRUE(test::is_free(*pair.a, *pair.b, Transform(s.separated))) << pair.name << i;
        }
      }
      EXPECT_GT(contacts, 10) << pair.name;
      EXPECT_LT(converged, contacts) << pair.name << work;  // or it was no limit
    }
}

TEST(Coherent, Full_rules_of_every_tick) {
  for (int seed = 100; seed < 140; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    for (const auto& pair : followed_pairs())
      for (const double stride : {0.001, 0.01, 0.1, 0.5}) {
        Rules rules;
        follow(pair, walk(random, pair, 400, stride), {}, 10, rules);
      }
  }
}

// Translation only: the separated probe is turned as the device is, unless it could not follow.
TEST(Coherent, translation_only_turns_with_the_device) {
  std::mt19937_64 random(5);
  for (const auto& pair : followed_pairs()) {
    CoherentSolver solver({pair.a, pair.b}, Method::pdt);
    const auto path = walk(random, pair, 200, 0.02);
    ASSERT_EQ(solver.reset(path[0]).status, Status::separated);
    int followed = 0, contacts = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Separation& s = solver.tick(path[i]);
      ASSERT_NE(s.status, Status::failed);
      if (i % 12 == 0) {
        EXPECT_TRUE(test::is_free(*pair.a, *pair.b, Transform(s.separated))) << pair.name << i;
      }
      const double turn = s.separated.q.angularDistance(path[i].q);
      if (s.converged) {
        EXPECT_LT(turn, 1e-7) << pair.name << i;
      }
      contacts += s.status == Status::penetrating;
      followed += s.status == Status::penetrating && turn < 1e-7;
    }
    EXPECT_GT(contacts, 20) << pair.name;
    std::printf("  %s: followed in %d of %d\n", pair.name.c_str(), followed, contacts);
    // Loose triangles hook each other: there the turn is often blocked, which each tick says.
    if (pair.a->solid) {
      EXPECT_GE(followed, contacts * 9 / 10) << pair.name;
    }
  }
}

bool same_tick(const Separation& x, const Separation& y) {
  return x.status == y.status && x.separated.p == y.separated.p &&
         x.separated.q.coeffs() == y.separated.q.coeffs() && x.depth == y.depth &&
         x.residual == y.residual && x.iterations == y.iterations && x.jumped == y.jumped &&
         x.contacts.size == y.contacts.size;
}

TEST(Coherent, the_same_path_gives_the_same_bits) {
  std::mt19937_64 random(6);
  for (const auto& pair : followed_pairs()) {
    const auto path = walk(random, pair, 150, 0.03);
    CoherentSolver one({pair.a, pair.b}), two({pair.a, pair.b});
    one.reset(path[0]), two.reset(path[0]);
    // One of them has a past: a reset forgets it.
    for (std::size_t i = 1; i < 80; ++i) two.tick(path[i]);
    two.reset(path[0]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Separation a = one.tick(path[i]), b = two.tick(path[i]);
      ASSERT_TRUE(same_tick(a, b)) << pair.name << " tick " << i;
    }
  }
}

TEST(Coherent, refuses_what_it_cannot_compute_with_and_goes_on_after_it) {
  std::mt19937_64 random(7);
  const auto pair = followed_pairs().front();
  const auto path = walk(random, pair, 150, 0.03);
  CoherentSolver plain({pair.a, pair.b}), pestered({pair.a, pair.b});
  EXPECT_EQ(pestered.tick(path[0]).status, Status::failed) << "not started";
  plain.reset(path[0]), pestered.reset(path[0]);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Separation expected = plain.tick(path[i]);
    if (i % 7 == 0) {
      const Pose at = pestered.last().separated;
      std::vector<Pose> bad(5, path[i]);
      bad[0].p.y() = nan;
      bad[1].q.x() = nan;
      bad[2].p.z() = std::numeric_limits<double>::infinity();
      bad[3].q.coeffs().setZero();
      bad[4].p.x() = 1e300;
      for (const Pose& X : bad) {
        const Separation& refused = pestered.tick(X);
        EXPECT_EQ(refused.status, Status::failed);
        EXPECT_STRNE(refused.reason, "");
        EXPECT_EQ(refused.separated.p, at.p);
        EXPECT_EQ(refused.contacts.size, 0);
      }
    }
    const Separation got = pestered.tick(path[i]);
    EXPECT_EQ(got.separated.p, expected.separated.p) << i;
    EXPECT_EQ(got.depth, expected.depth) << i;
  }
}

TEST(Coherent, a_reset_in_overlap_searches_and_says_so) {
  const auto pair = followed_pairs().front();
  CoherentSolver solver({pair.a, pair.b});
  const Pose X{Quat::Identity(), Vec3(0.02, 0.01, 0)};
  const Separation s = solver.reset(X);
  test::check_separation(*pair.a, *pair.b, s, "reset");
  EXPECT_TRUE(s.jumped);
  const Separation next = solver.tick(X);
  EXPECT_LE(next.depth, s.depth * (1 + 1e-12) + regained(pair.a->mass.radius, s.depth));
  EXPECT_FALSE(next.jumped);
  EXPECT_GE(next.depth, s.depth * (1 - 1e-3));  // it was converged
}

TEST(Coherent, a_tick_does_not_allocate) {
  std::mt19937_64 random(8);
  for (const auto& pair : followed_pairs())
    for (const Method method : {Method::pdg, Method::pdt}) {
      const auto path = walk(random, pair, 60, 0.1);
      CoherentSolver solver({pair.a, pair.b}, method);
      solver.reset(path[0]);
      test::AllocationCounter counter;
      for (const Pose& X : path) solver.tick(X);
      counter.stop();
      EXPECT_EQ(counter.allocations(), 0u) << pair.name;
      EXPECT_EQ(counter.frees(), 0u) << pair.name;
      EXPECT_EQ(solver.last().status, Status::penetrating) << pair.name;
    }
}

}  // namespace
}  // namespace sonde
