// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/static_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/search/search_tuning.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/engine/penetration/overlapping_pose.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/real_meshes.hpp"

namespace sonde {
namespace {

std::vector<test::BodyPair> searched_pairs() {
  std::mt19937_64 random(1);
  const auto soup = [&](int n) { return test::body(test::random_soup(random, n, 0.2)); };
  const auto ring = test::body(test::torus(0.08, 0.03, 12, 8));
  const auto knot = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 30, 5));
  return {{"box, box", test::body(test::box({0.06, 0.1, 0.15})),
           test::body(test::box({0.2, 0.1, 0.1}))},
          {"soup, torus", soup(20), ring},
          {"torus, soup", ring, soup(25)},
          {"soup, soup", soup(20), soup(20)},
          {"torus, torus", ring, ring},
          {"knot, knot", knot, knot},
          {"cross, star", test::real_body("cross.off"), test::real_body("star.off")},
          {"tripod, double torus", test::real_body("tripod.off"),
           test::real_body("double-torus-example.off")}};
}

/// No free pose can be nearer than the lower bound: tried on random ones about the depth.
void check_lower_bound(const test::BodyPair& pair, const Separation& s, std::mt19937_64& random) {
  if (!s.lower_bound) return;
  const Chart chart(pair.a->mass, s.device);
  for (int i = 0; i < 200; ++i) {
    Vec6 y;
    for (int k = 0; k < 6; ++k) y[k] = test::uniform(random, -1, 1);
    y *= s.depth * test::uniform(random, 0.2, 1.2) / y.norm();
    if (chart.v(y).norm() >= 0.99) continue;
    if (overlap(*pair.a, *pair.b, Transform(chart.pose(y)), Doubt::exact)) continue;
    EXPECT_GE(y.norm(), *s.lower_bound) << pair.name;
  }
}

TEST(StaticSearch, answers_are_free_near_contact_and_add_up) {
  std::mt19937_64 random(2);
  for (const auto& pair : searched_pairs()) {
    const Pair bodies(pair.a, pair.b);
    for (int i = 0; i < 4; ++i) {
      const Separation s = separate_static(bodies, test::overlapping_pose(random, pair, 0.7));
      test::check_separation(*pair.a, *pair.b, s, pair.name + " " + std::to_string(i));
      EXPECT_TRUE(s.lower_bound || !(pair.a->solid || pair.b->solid));
      ASSERT_TRUE(s.pdt.has_value());
      EXPECT_FALSE(s.jumped);
      check_lower_bound(pair, s, random);
    }
  }
}

// Any way out along a straight line bounds the depth from above: found here by bisection of
// overlap at the far end, not by the engine's descents. (Beyond the last overlap all is free.)
TEST(StaticSearch, depth_is_at_most_any_translation_out) {
  std::mt19937_64 random(3);
  for (const auto& pair : searched_pairs()) {
    const Pose X = test::overlapping_pose(random, pair, 0.7);
    const Separation s = separate_static({pair.a, pair.b}, X);
    for (int i = 0; i < 20; ++i) {
      const Vec3 way = test::random_in_ball(random, 1).normalized();
      double step = 1e-3 * pair.a->mass.radius, out = 0;
      for (; out < 1e4 * step; out += step)
        if (!overlap(*pair.a, *pair.b, Transform({X.q, X.p + out * way}), Doubt::exact)) break;
      EXPECT_LE(s.depth, out * (1 + 1e-3) + step) << pair.name;
    }
  }
}

TEST(StaticSearch, translation_only_does_not_turn_and_is_never_less) {
  std::mt19937_64 random(4);
  StaticOptions options;
  options.method = Method::pdt;
  for (const auto& pair : searched_pairs()) {
    const Pose X = test::overlapping_pose(random, pair, 0.7);
    const Pair bodies(pair.a, pair.b);
    const Separation t = separate_static(bodies, X, options);
    test::check_separation(*pair.a, *pair.b, t, pair.name);
    EXPECT_LT(t.separated.q.angularDistance(X.q), 1e-7) << pair.name;
    EXPECT_LE(separate_static(bodies, X).depth, t.depth * (1 + 1e-9)) << pair.name;
  }
}

bool same_answer(const Separation& x, const Separation& y) {
  return x.separated.p == y.separated.p && x.separated.q.coeffs() == y.separated.q.coeffs() &&
         x.depth == y.depth && x.residual == y.residual && x.iterations == y.iterations &&
         x.contacts.size == y.contacts.size && x.lower_bound == y.lower_bound && x.pdt == y.pdt;
}

TEST(StaticSearch, the_same_seed_gives_the_same_bits_and_the_budget_is_kept) {
  std::mt19937_64 random(5);
  for (const auto& pair : searched_pairs()) {
    const Pose X = test::overlapping_pose(random, pair, 0.7);
    const Pair bodies(pair.a, pair.b), again(pair.a, pair.b);
    EXPECT_TRUE(same_answer(separate_static(bodies, X), separate_static(again, X))) << pair.name;
    for (const int steps : {1, 20, 100}) {
      StaticOptions options;
      options.budget.steps = steps;
      const Separation s = separate_static(bodies, X, options);
      test::check_separation(*pair.a, *pair.b, s, pair.name);
      // A few steps more make what was found fit to be returned: one for each of ten at most.
      EXPECT_LE(s.iterations, steps + 10) << pair.name;
      EXPECT_TRUE(same_answer(s, separate_static(bodies, X, options))) << pair.name;
    }
  }
}

TEST(StaticSearch, a_small_probe_deep_inside_comes_out_to_contact) {
  const auto block = test::body(test::box({100, 100, 100}));
  std::mt19937_64 random(8);
  for (const double size : {1.0, 0.1, 0.01}) {
    const auto probe = test::body(test::box({size, 0.7 * size, 0.5 * size}));
    const Pose X{test::random_rotation(random), {1, -2, 30}};
    const Separation s = separate_static({probe, block}, X);
    test::check_separation(*probe, *block, s, std::to_string(size));
    EXPECT_NEAR(s.depth, 20, 2 * size);  // the face at 50
  }
}

TEST(StaticSearch, counted_steps_leave_room_for_translations) {
  std::mt19937_64 random(9);
  int with = 0, all = 0;
  for (const auto& pair : searched_pairs()) {
    const Pair bodies(pair.a, pair.b);
    for (const int steps : {30, 100}) {
      StaticOptions options;
      options.budget.steps = steps;
      const Separation s =
          separate_static(bodies, test::overlapping_pose(random, pair, 0.7), options);
      ++all, with += s.pdt.has_value();
    }
  }
  EXPECT_EQ(with, all);
}

// A translation is one of the answers: what a search for it alone finds with the same seed is never
// beaten by it. One inside the other in the middle every direction is as good, but for the facets.
// By hand: a cube of 1 m in one of 2 m leaves by 0.6 m. A budget that never runs out leaves nothing
// undone.
TEST(StaticSearch, has_converged_where_its_budget_did_not_run_out) {
  const auto small = test::body(test::box({1, 1, 1})), large = test::body(test::box({2, 2, 2}));
  for (const Method method : {Method::pdg, Method::pdt})
    for (const Vec3& p : {Vec3(0.9, 0.1, 0.05), Vec3(0.2, -0.95, 0.3), Vec3(1.2, 0.7, -0.4)}) {
      StaticOptions options;
      options.method = method;
      options.budget.steps = 1'000'000;
      const Separation s = separate_static({small, large}, {Quat::Identity(), p}, options);
      EXPECT_TRUE(s.converged) << p.transpose();
      EXPECT_LT(s.iterations, options.budget.steps);
      EXPECT_NEAR(s.depth, 1.5 - p.cwiseAbs().maxCoeff(), 1e-3);
    }
}

TEST(StaticSearch, is_no_deeper_than_the_translation_found_alone_among_many_as_good) {
  const auto ball = test::body(test::icosphere(1, 2)), shell = test::body(test::icosphere(3, 2));
  ASSERT_EQ(ball->soup.triangles.size(), 320U);
  const Pair bodies(ball, shell);
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    StaticOptions options;
    options.seed = seed;
    options.want_lower_bound = false;
    const Separation g = separate_static(bodies, {}, options);
    options.method = Method::pdt;
    const Separation t = separate_static(bodies, {}, options);
    EXPECT_LE(g.depth, t.depth * (1 + 1e-12)) << seed;
    ASSERT_TRUE(g.pdt);
    EXPECT_NEAR(*g.pdt, t.depth, 1e-12 * t.depth) << seed;
  }
}

// By default the bound gets no more work than the search took, as counted; and what it is then, it
// is again. Reference: the bound by itself (lower_bound_test.cpp), with all the work it may have.
TEST(StaticSearch, the_bound_is_not_the_larger_part_unless_it_is_asked_for) {
  const auto ring = test::body(test::torus(1, 0.3, 24, 12));
  const Pair rings(ring, ring);
  const Pose X{Quat(Eigen::AngleAxisd(0.4, Vec3(1, 0.3, 0.2).normalized())), Vec3(0.3, 0.2, 0.1)};
  StaticOptions options;
  const Separation cheap = separate_static(rings, X, options), again = separate_static(rings, X);
  options.whole_bound = true;
  const Separation whole = separate_static(rings, X, options);
  ASSERT_EQ(cheap.status, Status::penetrating);
  ASSERT_TRUE(cheap.lower_bound && whole.lower_bound);
  EXPECT_EQ(*whole.lower_bound, *depth_lower_bound(*ring, *ring, X));
  EXPECT_EQ(*cheap.lower_bound, *again.lower_bound);
  EXPECT_GT(*cheap.lower_bound, 0);
  EXPECT_LT(*cheap.lower_bound, *whole.lower_bound) << "else the test shows nothing";
  EXPECT_LE(*whole.lower_bound, cheap.depth);
  options.whole_bound = false;
  double before = 0;
  for (const int steps : {1, 4, 16, 64, 256}) {  // more work of the search, and of the bound
    options.budget.steps = steps;
    const double bound = *separate_static(rings, X, options).lower_bound;
    EXPECT_GE(bound, before) << steps;
    before = bound;
  }
  EXPECT_LE(before, *whole.lower_bound);
}

// What is found with so many steps is found with more: the depth never rises with the budget. And
// what is returned touches, whatever the steps ended in (check_separation).
TEST(StaticSearch, more_steps_never_give_a_worse_answer) {
  std::mt19937_64 random(10);
  for (const auto& pair : searched_pairs()) {
    const Pose X = test::overlapping_pose(random, pair, 0.7);
    const Pair bodies(pair.a, pair.b);
    StaticOptions options;
    options.want_lower_bound = false;
    double before = std::numeric_limits<double>::infinity();
    for (int steps = 1; steps < 400; steps += 1 + steps / 6) {
      options.budget.steps = steps;
      const Separation s = separate_static(bodies, X, options);
      test::check_separation(*pair.a, *pair.b, s, pair.name);
      EXPECT_LE(s.depth, before * (1 + 1e-12)) << pair.name << ", " << steps << " steps";
      before = s.depth;
    }
  }
}

// Starts on sketches cost no steps, and end near where the bodies do: eight steps suffice from
// there. Reference: the search without a limit.
TEST(StaticSearch, few_steps_go_on_from_sketches) {
  std::mt19937_64 random(12);
  const auto all_pairs = searched_pairs();
  int near = 0, all = 0;
  for (const std::size_t k : {4u, 5u})  // torus in torus, knot in knot
    for (int i = 0; i < 12; ++i) {
      const Pair bodies(all_pairs[k].a, all_pairs[k].b);
      const Pose X = test::overlapping_pose(random, all_pairs[k], 0.7);
      StaticOptions options;
      options.want_lower_bound = false;
      const double reference = separate_static(bodies, X, options).depth;
      options.budget.steps = 8;
      ++all, near += separate_static(bodies, X, options).depth < 1.05 * reference;
    }
  EXPECT_GE(near, 3 * all / 4);
}

TEST(StaticSearch, two_threads_give_the_same_bits) {
  std::mt19937_64 random(7);
  for (const auto& pair : searched_pairs()) {
    const Pose X = test::overlapping_pose(random, pair, 0.7);
    const Pair bodies(pair.a, pair.b);
    for (const int steps : {0, 50}) {
      StaticOptions one;
      one.budget.steps = steps;
      StaticOptions two = one;
      two.two_threads = true;
      EXPECT_TRUE(same_answer(separate_static(bodies, X, one), separate_static(bodies, X, two)))
          << pair.name;
    }
  }
}

// |depth(o) − depth(o′)| ≤ √σ(o, o′) is a law of the true depth: what breaks it by more than the
// clearance proves a missed optimum. A search by restarts misses some, so the share is bounded, not
// each.
TEST(StaticSearch, depth_changes_by_no_more_than_the_device_moved) {
  std::mt19937_64 random(6);
  int broken = 0, all = 0;
  for (const auto& pair : searched_pairs()) {
    const Pair bodies(pair.a, pair.b);
    for (int i = 0; i < 3; ++i) {
      const Pose X = test::overlapping_pose(random, pair, 0.7);
      Pose Y = X;
      Y.p += test::random_in_ball(random, 0.02 * pair.a->mass.radius);
      Y.q = (Y.q * Quat(Eigen::AngleAxisd(0.02, test::random_in_ball(random, 1).normalized())))
                .normalized();
      const Separation x = separate_static(bodies, X), y = separate_static(bodies, Y);
      const double moved = test::pose_distance(*pair.a, X, Y);
      const double slack = test::promised_clearance(pair.a->mass.radius, x.depth);
      broken += std::abs(x.depth - y.depth) > moved + 2 * slack;
      ++all;
    }
  }
  std::printf("  %d of %d pairs of poses break the law\n", broken, all);
  EXPECT_LE(broken, all / 12);
}

TEST(StaticSearch, a_free_pose_is_separated_as_it_is) {
  for (const auto& pair : searched_pairs()) {
    Pose X;
    X.p = pair.b->mass.com - pair.a->mass.com +
          Vec3(1.01 * (pair.a->mass.radius + pair.b->mass.radius), 0, 0);
    const Separation s = separate_static({pair.a, pair.b}, X);
    EXPECT_EQ(s.status, Status::separated) << pair.name;
    EXPECT_EQ(s.depth, 0);
    EXPECT_EQ(s.sigma, 0);
    EXPECT_EQ(s.separated.p, X.p);
    EXPECT_EQ(s.contacts.size, 0);
    EXPECT_TRUE(s.converged);
  }
  // Rings through one another, without touching, are free.
  const auto ring = test::body(test::torus(0.08, 0.02, 16, 8));
  const Pose linked{Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX())), Vec3(0.08, 0, 0)};
  EXPECT_EQ(separate_static({ring, ring}, linked).status, Status::separated);
}

TEST(StaticSearch, answers_of_both_methods_are_free_near_contact_and_add_up) {
  std::mt19937_64 random(22);
  for (const auto& pair : searched_pairs()) {
    const Pair bodies(pair.a, pair.b);
    for (const Method method : {Method::pdg, Method::pdt})
      for (int i = 0; i < 3; ++i) {
        const Pose X = test::overlapping_pose(random, pair, 0.7);
        StaticOptions options;
        options.method = method;
        const Separation s = separate_static(bodies, X, options);
        test::check_separation(*pair.a, *pair.b, s, pair.name);
        EXPECT_TRUE(method == Method::pdg || s.rotation == 0) << pair.name;
      }
  }
}

TEST(StaticSearch, a_mesh_in_its_own_place) {
  for (const auto& body :
       {test::body(test::box({0.1, 0.1, 0.1})), test::body(test::torus(0.08, 0.03, 12, 8)),
        test::real_body("star.off")}) {
    const Pose X{Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())), Vec3(0.1, 0, 0)};
    for (const Pose& at : {Pose{}, X}) {
      const Pose same = at.p.isZero() ? at : Pose{};
      test::check_separation(*body, *body, separate_static({body, body}, same), body->name);
    }
  }
}

// By evidence it would go on, or stop: told to look at a few starts and nothing else, it ends by
// their number alone.
TEST(StaticSearch, a_search_that_ends_by_its_number_of_starts_counts_that_limit) {
  const test::BodyPair pair = searched_pairs().front();
  std::mt19937_64 random(8);
  const Pose X = test::overlapping_pose(random, pair, 0.7);
  StaticOptions options;
  options.method = Method::pdt;
  options.starts = 8;
  options.want_lower_bound = false;
  const int by_itself = separate_static({pair.a, pair.b}, X, options).limited;
  options.agreement = std::numeric_limits<int>::max();
  options.by_evidence = false;
  // Of the search for the probe, and of that for the fixed body.
  EXPECT_EQ(separate_static({pair.a, pair.b}, X, options).limited, by_itself + 2);
}

// Reference: a limit that is far above what the search makes, and that it never meets. A surer
// answer takes ten times as many starts, which of the largest limit is no int.
TEST(StaticSearch, the_largest_limit_of_starts_is_none_for_a_surer_answer_too) {
  const test::BodyPair pair = searched_pairs().front();
  std::mt19937_64 random(8);
  const Pose X = test::overlapping_pose(random, pair, 0.7);
  SearchTuning tuning;
  tuning.narrow = 0;  // any way out counts as long
  tuning.most_after_sketches = tuning.most_translations_pushed = 4;
  StaticOptions options{.starts = 1000, .sure = 0.99, .want_lower_bound = false};
  for (const Method method : {Method::pdg, Method::pdt}) {
    options.method = method;
    options.starts = 1000;
    const Separation by_enough = separate_static({pair.a, pair.b}, X, options, tuning);
    ASSERT_TRUE(by_enough.far_out);
    options.starts = std::numeric_limits<int>::max();
    const Separation by_most = separate_static({pair.a, pair.b}, X, options, tuning);
    EXPECT_EQ(by_most.iterations, by_enough.iterations);
    EXPECT_EQ(by_most.depth, by_enough.depth);
  }
}

}  // namespace
}  // namespace sonde
