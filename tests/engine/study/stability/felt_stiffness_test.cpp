// SPDX-License-Identifier: GPL-3.0-or-later
// References: a box on a wide one, whose separation is known in closed form; the definition of the
// energy; and the summed penalties that the felt stiffness is compared with.
#include "engine/study/stability/felt_stiffness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/penetration/search/coherent.hpp"
#include "engine/scene/scene.hpp"
#include "engine/study/stability/contact_situations.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

TEST(FeltStiffness, of_a_box_pressed_flat_is_that_of_its_three_degrees) {
  const auto probe = test::body(test::box({0.06, 0.04, 0.02}));
  const auto fixed = test::body(test::box({1, 1, 0.2}));
  const Pose O{Quat::Identity(), {0, 0, 0.11 - 1e-3}}, Q{Quat::Identity(), {0, 0, 0.11 + 1e-7}};
  const auto felt = felt_stiffness({probe, fixed}, Method::pdg, O, Q, 2e-5);
  ASSERT_TRUE(felt);
  // It resists pressing with 1 and turns out of the plane with Î; nothing else.
  const Vec3 square = Vec3(0.06, 0.04, 0.02).cwiseAbs2();
  const Vec3 inertia = Vec3(square.y() + square.z(), square.x() + square.z(), 0) / 12;
  Mat6 object = Mat6::Zero(), classic = Mat6::Zero();
  object(2, 2) = classic(2, 2) = classic(3, 3) = classic(4, 4) = 1;
  object(3, 3) = inertia.x();
  object(4, 4) = inertia.y();
  const Mat6 off = felt->object - object;
  EXPECT_LT(off.topRows(3).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT(off.bottomRightCorner(3, 3).cwiseAbs().maxCoeff(), 0.01 * inertia.y());
  EXPECT_LT((felt->classic - classic).bottomRightCorner(3, 3).cwiseAbs().maxCoeff(), 0.01);
  const StiffnessRatio ratio = stiffness_ratio(probe->mass, O, felt->object);
  EXPECT_NEAR(ratio.translation, 1, 0.01);
  EXPECT_NEAR(ratio.rotation, 1, 0.01);

  Coupling c;
  c.mode = Coupling::Mode::classic;
  c.k_t = 300;
  c.k_r = 2;
  c.b_t = 7;
  c.b_r = 0.1;
  EXPECT_NEAR(felt->stiffness(c)(2, 2), 300, 3);
  EXPECT_NEAR(felt->stiffness(c)(4, 4), 2, 0.02);
  EXPECT_NEAR(felt->damping(c)(2, 2), 7, 0.07);
  EXPECT_NEAR(felt->damping(c)(4, 4), 0.1, 0.001);
  c.mode = Coupling::Mode::object;
  EXPECT_EQ(felt->damping(c), Mat6::Zero());
}

// The answer to a graze stands within its clearance, so it does not follow a smaller motion: taken
// as a contact, it would hold the probe in every direction.
TEST(FeltStiffness, a_graze_has_none) {
  const Pair pair(test::body(test::box({0.06, 0.05, 0.04})), test::body(test::box({1, 1, 0.1})));
  for (const double depth : {1e-11, 1e-9, 1e-5, 1e-3}) {
    const Pose O{Quat::Identity(), {0.01, 0.005, 0.07 - depth}};
    const Pose Q{Quat::Identity(), {0.01, 0.005, 0.07 + 1e-4 * depth}};
    const auto felt = felt_stiffness(pair, Method::pdg, O, Q, 0.03 * depth);
    EXPECT_EQ(felt.has_value(), depth > 1e-6) << depth;
    if (!felt) continue;
    EXPECT_NEAR(felt->object(2, 2), 1, 0.02) << depth;
    EXPECT_NEAR(felt->object(0, 0), 0, 0.02) << depth << ": it slides along the plane";
    EXPECT_NEAR(felt->object(1, 1), 0, 0.02) << depth;
  }
}

/// Contacts of two real meshes and of two knots.
struct Contacts {
  std::shared_ptr<const Body> probe, fixed;
  std::vector<ContactSituation> found;

  Contacts(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, int walks)
      : probe(std::move(a)), fixed(std::move(b)) {
    SituationOptions options;
    options.walks = walks;
    options.hardness = [](const FeltStiffness& felt) { return felt.object.norm(); };
    const Pose X{Quat::Identity(), Vec3::Zero()};
    found = find_situations({probe, fixed}, X, 100, options, never);
  }
};

Contacts spoon_in_cup(int walks) {
  const Scene scene = read_scene(SONDE_RESOURCES "/scenes/spoon-in-cup.sonde.json");
  return {load(scene.probe, scene.unit), load(scene.fixed, scene.unit), walks};
}
Contacts knots(int walks) {
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.02, 60, 8));
  return {knot, knot, walks};
}

struct Extremes {
  StiffnessRatio felt, summed;
  int contacts = 0;
};

Extremes extremes(const Contacts& contacts) {
  Extremes out;
  for (const ContactSituation& s : contacts.found) {
    const MassProperties& mass = contacts.probe->mass;
    const StiffnessRatio felt = stiffness_ratio(mass, s.separation.device, s.stiffness.object);
    const StiffnessRatio summed = summed_penalty_ratio(mass, s.separation);
    out.felt.translation = std::max(out.felt.translation, felt.translation);
    out.felt.rotation = std::max(out.felt.rotation, felt.rotation);
    out.summed.translation = std::max(out.summed.translation, summed.translation);
    out.summed.rotation = std::max(out.summed.rotation, summed.rotation);
    ++out.contacts;
  }
  return out;
}

void expect_felt_stiffness_bounded(const Contacts& contacts) {
  const Extremes e = extremes(contacts);
  testing::Test::RecordProperty("contacts", e.contacts);
  testing::Test::RecordProperty(
      "felt", std::to_string(e.felt.translation) + " " + std::to_string(e.felt.rotation));
  testing::Test::RecordProperty(
      "summed", std::to_string(e.summed.translation) + " " + std::to_string(e.summed.rotation));
  EXPECT_GT(e.contacts, 10);
  EXPECT_LE(e.felt.translation, 1.01);  // the differences are exact to a hundredth
  EXPECT_LE(e.felt.rotation, 1.2);
  EXPECT_GT(e.summed.translation, 2);
  EXPECT_GT(e.summed.rotation, 2);
}

/// U(o′) ≤ ½kσ(q*(o), o′): what the solver finds at o′ is no dearer than staying at q*(o).
void expect_energy_bounded(const Contacts& contacts, std::uint64_t seed, int each) {
  std::mt19937_64 random(seed);
  const MassProperties& mass = contacts.probe->mass;
  CoherentSolver solver({contacts.probe, contacts.fixed});
  int compared = 0;
  for (const ContactSituation& s : contacts.found)
    for (int i = 0; i < each; ++i) {
      const double size = s.separation.depth * test::uniform(random, 0, 1);
      Pose beside = s.separation.device;
      beside.p += test::random_in_ball(random, size);
      const Vec3 turn = test::random_in_ball(random, size / mass.radius * 2);
      if (turn.norm() > 0)
        beside.q =
            (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * beside.q).normalized();
      solver.reset(s.separation.separated);
      const Separation held = solver.tick(s.separation.device);
      if (held.status != Status::penetrating) continue;
      const double stay = Chart(mass, beside).coordinates(held.separated).squaredNorm();
      const Separation& moved = solver.tick(beside);
      ASSERT_NE(moved.status, Status::failed);
      EXPECT_LE(moved.sigma, stay * (1 + 1e-12));
      ++compared;
    }
  EXPECT_GT(compared, 50);
}

TEST(FeltStiffness, is_never_more_than_asked_for_where_summed_penalties_are) {
  expect_felt_stiffness_bounded(spoon_in_cup(120));
}
TEST(FeltStiffness, energy_beside_a_contact_is_bounded_by_staying) {
  expect_energy_bounded(spoon_in_cup(40), 1, 5);
  expect_energy_bounded(knots(40), 2, 5);
}
TEST(FeltStiffness, Full_bounds_on_many_contacts) {
  expect_felt_stiffness_bounded(spoon_in_cup(1000));
  expect_energy_bounded(spoon_in_cup(400), 3, 20);
  expect_energy_bounded(knots(400), 4, 20);
}

}  // namespace
}  // namespace sonde
