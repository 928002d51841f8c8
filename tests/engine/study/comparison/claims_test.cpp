// SPDX-License-Identifier: GPL-3.0-or-later
// Renderings made up by hand, of which it is known who is smoother; the sign test by its sums, by
// Boost.Math's binomial distribution, and by the same sums of log factorials, term by term.
#include "engine/study/comparison/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "engine/geometry/random.hpp"

namespace sonde {
namespace {

/// Four seconds in contact, at a stated size, that trembles by a share of it.
Rendering rubbing(double size, double share, std::uint64_t seed = 1) {
  Random random(seed);
  Rendering out;
  for (int i = 0; i <= 4000; ++i) {
    RenderedTick tick;
    tick.t = 0.001 * i;
    tick.force = size * Vec3(std::sin(0.01 * i), 0, 3 + share * random.uniform(-1, 1));
    tick.torque = 0.01 * tick.force;
    out.push_back(tick);
  }
  return out;
}

TestedClaim claim_of(const Rendering& pdt, const Rendering& pdg, std::size_t which = 0) {
  Comparison c;
  c.pdt = pdt;
  c.pdg = pdg;
  return tested_claims(c).at(which);
}

TEST(Claims, a_smaller_force_is_no_smoother_one) {
  // By its size alone, the total variation is a third.
  for (const std::size_t which : {0u, 1u}) {
    const TestedClaim claim = claim_of(rubbing(3, 0.01), rubbing(1, 0.01), which);
    EXPECT_EQ(claim.finding, Finding::undecided);
    EXPECT_EQ(claim.for_it + claim.against_it, 0) << "within 2 %";
    EXPECT_EQ(claim.alike, 16);
  }
}

TEST(Claims, what_trembles_less_is_smoother_and_could_have_been_the_other) {
  const Rendering quiet = rubbing(3, 0.01), trembling = rubbing(1, 0.1);
  const TestedClaim supported = claim_of(trembling, quiet), refuted = claim_of(quiet, trembling);
  EXPECT_EQ(supported.finding, Finding::supported);
  EXPECT_EQ(refuted.finding, Finding::refuted);
  EXPECT_EQ(supported.for_it, 16) << "quarters of a second";
  EXPECT_EQ(supported.against_it, 0);
  EXPECT_LT(supported.chance, 1e-4);
}

/// Pressed flat, 5 mm deep, at 500 N/m: what little torque there is alternates by `torque`.
Comparison pressed_flat(double torque) {
  Comparison c;
  c.stiffness = 500;
  c.radius = 0.05;
  c.pdt = c.pdg = rubbing(1, 0.01);
  for (std::size_t i = 0; i < c.pdt.size(); ++i) {
    for (RenderedTick* each : {&c.pdt[i], &c.pdg[i]}) {
      each->depth = 0.005;
      each->torque.setZero();
    }
    c.pdt[i].torque.x() = i % 2 == 0 ? 0 : torque;
  }
  return c;
}

// Reference: the clearance may be 1e-4 of the depth, here worth 500 N/m · 5e-7 m = 0.25 mN, and
// 0.0125 mN·m on the radius; each may be off by as much at both ends of a swing. A trial has 250
// ticks, 249 changes of the alternating torque.
TEST(Claims, rounding_is_no_tremble) {
  const double resolved = 4 * 0.0125e-3 / 249;
  for (const double torque : {1e-16, 1e-13, 0.9 * resolved}) {
    const TestedClaim claim = tested_claims(pressed_flat(torque)).at(1);
    EXPECT_EQ(claim.finding, Finding::undecided) << torque;
    EXPECT_EQ(claim.alike, 16) << torque;
  }
  EXPECT_EQ(tested_claims(pressed_flat(1.1 * resolved)).at(1).finding, Finding::supported);
  Comparison swapped = pressed_flat(1.1 * resolved);
  std::swap(swapped.pdt, swapped.pdg);
  EXPECT_EQ(tested_claims(swapped).at(1).finding, Finding::refuted);
}

// Reference: of a depth known to 1e-4 of itself, so is the torque, of force times radius.
TEST(Claims, two_torques_that_are_as_right_as_the_solver_are_alike) {
  const auto nearer = [](double pdt, double pdg) {
    Comparison c;
    for (std::size_t i = 0; i < 12; ++i) {
      c.of_pdt.realism.at_equal_force.push_back({i, pdt});
      c.of_pdg.realism.at_equal_force.push_back({i, pdg});
    }
    return tested_claims(c).at(4).finding;
  };
  EXPECT_EQ(nearer(1.9e-4, 1e-9), Finding::undecided);
  EXPECT_EQ(nearer(1e-9, 1e-13), Finding::undecided);
  EXPECT_EQ(nearer(2.1e-4, 1e-9), Finding::supported);
  EXPECT_EQ(nearer(1e-9, 2.1e-4), Finding::refuted);
}

TEST(Claims, of_what_there_was_no_trial_there_is_no_finding) {
  EXPECT_EQ(claim_of({}, {}).finding, Finding::none);
  EXPECT_EQ(claim_of(rubbing(1, 0.1), rubbing(1, 0.1), 3).finding, Finding::none)
      << "nobody popped through";
  Comparison c;
  c.of_pdt.stiffness.limits.push_back({4, 5.0});
  EXPECT_EQ(tested_claims(c).at(5).finding, Finding::none) << "of one method alone";
  c.of_pdg.stiffness.limits.push_back({4, 5.0});
  EXPECT_EQ(tested_claims(c).at(5).finding, Finding::undecided) << "alike";
}

TEST(Claims, a_split_that_chance_may_make_is_undecided) {
  Comparison c;
  c.of_pdt.discontinuities.pop_throughs = 6;
  EXPECT_EQ(tested_claims(c).at(3).finding, Finding::supported);
  c.of_pdt.discontinuities.pop_throughs = 5;
  EXPECT_EQ(tested_claims(c).at(3).finding, Finding::undecided) << "2/32";
}

// Reference: 2 Σ C(n, k) / 2ⁿ over splits as uneven: 9 of 10 are 22/1024.
TEST(Claims, fewer_steps_are_seen_either_way) {
  Comparison c;
  c.of_pdt.discontinuities.force_steps = 4;
  c.of_pdt.discontinuities.torque_steps = 9;  // in the same ticks: nine trials, not thirteen
  c.of_pdg.discontinuities.torque_steps = 1;
  const TestedClaim fewer = tested_claims(c).at(2);
  EXPECT_STREQ(fewer.key, "fewer_steps");
  EXPECT_EQ(fewer.finding, Finding::supported);
  EXPECT_NEAR(fewer.chance, 22.0 / 1024, 1e-12);
  std::swap(c.of_pdt, c.of_pdg);
  EXPECT_EQ(tested_claims(c).at(2).finding, Finding::refuted);
  c.of_pdg.discontinuities.torque_steps = 5;
  EXPECT_EQ(tested_claims(c).at(2).finding, Finding::undecided) << "1 and 5";
}

TEST(Claims, a_nearer_torque_and_a_larger_stable_force_are_seen_either_way) {
  Comparison c;
  for (std::size_t i = 0; i < 12; ++i) {
    c.of_pdt.realism.at_equal_force.push_back({i, 0.2});
    c.of_pdg.realism.at_equal_force.push_back({i, i == 3 ? 0.3 : 0.1});
    c.of_pdt.stiffness.limits.push_back({2 * i, 5.0});
    c.of_pdg.stiffness.limits.push_back({3 * i, 4.0});
  }
  const TestedClaim torque = tested_claims(c).at(4), stable = tested_claims(c).at(5);
  EXPECT_STREQ(torque.key, "better_torque");
  EXPECT_EQ(torque.finding, Finding::supported);
  EXPECT_EQ(torque.against_it, 1);
  EXPECT_STREQ(stable.key, "more_stable");
  EXPECT_EQ(stable.against_it, 4) << "ticks that both have: 0, 6, 12, 18";
  EXPECT_EQ(stable.finding, Finding::undecided) << "2/16";
  std::swap(c.of_pdt, c.of_pdg);
  EXPECT_EQ(tested_claims(c).at(4).finding, Finding::refuted);
  EXPECT_EQ(tested_claims(c).at(5).for_it, 4);
}

TEST(Claims, the_sign_test_sums_up_the_binomial) {
  EXPECT_NEAR(sign_test(6, 0), 2.0 / 64, 1e-12);
  EXPECT_NEAR(sign_test(5, 1), 2 * 7.0 / 64, 1e-12);
  EXPECT_NEAR(sign_test(9, 3), 2 * (220 + 66 + 12 + 1) / 4096.0, 1e-12);
  EXPECT_EQ(sign_test(3, 3), 1);
  EXPECT_EQ(sign_test(0, 0), 1);
}

double log_factorial(int n) { return std::lgamma(n + 1.0); }

TEST(Claims, the_sign_test_is_that_of_a_binomial_distribution) {
  for (const int n : {1, 2, 7, 20, 99, 1000, 50'000})
    for (const double share : {0.5, 0.501, 0.52, 0.6, 0.8, 1.0}) {
      const int most = std::max((n + 1) / 2, static_cast<int>(share * n));
      const boost::math::binomial_distribution<> fair(n, 0.5);
      const double reference =
          std::min(1.0, 2 * boost::math::cdf(boost::math::complement(fair, most - 1)));
      const double chance = sign_test(n - most, most);
      EXPECT_NEAR(chance, reference, 1e-9 * reference + 1e-300) << n << ' ' << most;
      EXPECT_EQ(chance, sign_test(most, n - most));
      if (n > 1000) continue;
      double sum = 0;
      for (int k = most; k <= n; ++k)
        sum +=
            std::exp(log_factorial(n) - log_factorial(k) - log_factorial(n - k) - n * std::log(2));
      EXPECT_NEAR(chance, std::min(1.0, 2 * sum), 1e-9 * sum + 1e-300) << n << ' ' << most;
    }
}

TEST(Claims, the_sign_test_of_a_million_trials_is_one_pass) {
  // Reference: the normal distribution, with the half that a whole number needs.
  EXPECT_NEAR(sign_test(499'000, 501'000), std::erfc((1000 - 0.5) / std::sqrt(1e6 / 2)), 1e-6);
}

}  // namespace
}  // namespace sonde
