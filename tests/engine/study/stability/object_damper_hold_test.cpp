// SPDX-License-Identifier: GPL-3.0-or-later
// References: the eigenvalues of one sampled axis with a virtual damping; the same hold without the
// damper.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/study/stability/contact_stability.hpp"
#include "engine/study/stability/press_and_hold.hpp"
#include "engine/study/stability/sampled_stability.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/engine/study/tuning/tuning_requests.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

ClosedLoopSetup cube_on_block(double k, double damping) {
  ClosedLoopSetup out{
      .pair = {test::body(test::box({0.05, 0.05, 0.05})), test::body(test::box({1, 1, 0.2}))}};
  out.coupling.mode = Coupling::Mode::damped;
  out.coupling.k = k;
  out.coupling.b_t = damping;
  out.coupling.max_force = out.coupling.max_torque = 1e6;
  out.device.translation = {.inertia = 0.1, .damping = 1, .limit = 1e6};
  out.device.rotation = {.inertia = 1e3, .damping = 1e5, .limit = 1e6};  // it does not turn
  return out;
}

/// Kinetic energy in the second half of a second after a small knock, over that in the first.
double growth(double k, double damping) {
  const ClosedLoopSetup setup = cube_on_block(k, damping);
  ClosedLoop loop(setup);
  const Pose X{Quat::Identity(), {0, 0, 0.125 + 1e-6}};
  loop.reset(X, StaticOptions{});
  Wrench push;
  double energy[2] = {0, 0};
  for (int i = 0; i < 1800; ++i) {
    push.force.z() = -20 * std::min(1.0, i / 500.0) - (i >= 700 && i < 720 ? 0.2 : 0);
    loop.step(X, push);
    if (i >= 800) energy[i < 1300 ? 0 : 1] += kinetic_energy(setup.device, loop.device().state());
  }
  return energy[1] / energy[0];
}

TEST(ObjectDamperHold, is_stable_up_to_the_limit_of_one_axis_with_that_virtual_damping) {
  double before = 0;
  for (const double damping : {0.0, 2.0, 10.0}) {
    const double K = largest_stable_stiffness({0.1, 1, damping, 1e-3, 0});
    EXPECT_GT(K, before) << "up to half of m/T damping allows more";
    EXPECT_LT(growth(0.95 * K, damping), 1) << damping;
    EXPECT_GT(growth(1.05 * K, damping), 1) << damping;
    before = K;
  }
}

struct Settled {
  double time = 0, overshoot = 0;
};

/// After a push from one moment to the next: until |F| stays within 5 % of what it comes to.
Settled step_response(const TuningSetup& setup) {
  constexpr int ticks = 1200, pushed = 100, last = 100;
  const Pose X = setup.situation.contact.separation.separated;
  ClosedLoop loop(setup.loop);
  loop.reset(X, StaticOptions{});
  std::vector<double> force;
  for (int i = 0; i < ticks; ++i) {
    loop.step(X, i < pushed ? Wrench{} : setup.situation.push);
    force.push_back(loop.device().motors().force.norm());
  }
  double end = 0;
  for (int i = ticks - last; i < ticks; ++i) end += force[static_cast<std::size_t>(i)] / last;
  Settled out;
  for (int i = pushed; i < ticks; ++i) {
    const double f = force[static_cast<std::size_t>(i)];
    if (std::abs(f - end) > 0.05 * end) out.time = (i - pushed) * setup.loop.sample_time;
    out.overshoot = std::max(out.overshoot, f / end - 1);
  }
  return out;
}

// What it buys, on a real pair: the table of the manual.
TEST(ObjectDamperHold, Full_in_the_cup_it_settles_sooner_and_allows_more) {
  const TuningRequest request = test::spoon_in_cup();
  const TuningPlan plan = tuning_plan(request, test::never);
  for (std::size_t i = 0; i < plan.contacts.situations.size(); ++i) {
    TuningSetup setup = tuning_setup(plan, i, hand_grips[0]);
    setup.loop.coupling.mode = Coupling::Mode::damped;
    setup.loop.coupling.k = 170;
    setup.loop.device.translation.friction = setup.loop.device.rotation.friction = 0;
    const ContactSituation& contact = setup.situation.contact;
    double time = INFINITY, released = 0;
    for (const double damping : {0.0, 1.0, 2.0}) {
      const SampledContact linear{setup.loop.device,
                                  request.sample_time,
                                  contact.stiffness.object,
                                  Mat6::Zero(),
                                  damping * contact.stiffness.damper,
                                  true};
      setup.loop.coupling.b_t = damping;
      const Settled settled = step_response(setup);
      const double stable = largest_released_factor(linear);
      EXPECT_LT(settled.time, 0.85 * time) << name_of(contact.kind) << ' ' << damping;
      EXPECT_GT(stable, 1.5 * released) << name_of(contact.kind) << ' ' << damping;
      time = settled.time;
      released = stable;
      RecordProperty(std::string(name_of(contact.kind)) + std::to_string(int(damping)),
                     std::to_string(settled.time) + " s, " + std::to_string(settled.overshoot) +
                         ", " + std::to_string(stable) + " N/m released, " +
                         std::to_string(largest_passive_factor(linear)) + " passive");
    }
  }
}

}  // namespace
}  // namespace sonde
