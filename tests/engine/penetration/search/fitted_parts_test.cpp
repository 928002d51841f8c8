// SPDX-License-Identifier: GPL-3.0-or-later
// Conforming parts, pressed and wedged: what the coherent solver holds is an optimum, however the
// walls are cut, and what it lets go is said.
#include "tests/support/fitted_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/free_region.hpp"
#include "tests/engine/penetration/ways_down.hpp"
#include "tests/support/joints.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double k = 800;  // N/m

std::vector<Separation> follow(const test::FittedScene& scene, int ticks, const Budget& budget = {},
                               std::size_t refused = 0) {
  const auto probe = test::body(scene.probe), fixed = test::body(scene.fixed);
  EXPECT_TRUE(probe->solid && fixed->solid) << scene.name;
  const std::vector<Pose> path = test::fitted_path(scene.path, ticks);
  CoherentSolver solver({probe, fixed});
  std::vector<Separation> out{solver.reset(path.front())};
  EXPECT_EQ(out.back().status, Status::separated) << scene.name;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (refused > 0 && i % refused == 0)
      solver.tick({Quat::Identity(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN())});
    out.push_back(solver.tick(path[i], budget));
  }
  return out;
}

void expect_optima(const std::vector<test::FittedScene>& scenes, int ticks, int every, int tries) {
  for (const test::FittedScene& scene : scenes) {
    const auto probe = test::body(scene.probe), fixed = test::body(scene.fixed);
    const std::vector<Separation> all = follow(scene, ticks);
    std::mt19937_64 random(7);
    const bool jams = scene.name.ends_with("jammed");
    int looked_at = 0, converged = 0, contact = 0, falling = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].status != Status::penetrating) continue;
      // Half a turn from the device, either way round is as short: a tick may stop there, and says
      // that it has not converged.
      // What gets free after it has jammed falls for several ticks, each of which says so.
      const bool falls = jams && !all[i].converged && all[i].limited > 0;
      if (falls) {
        ++falling;
      } else if (all[i].device.q.angularDistance(all[i].separated.q) < 3.1) {
        ++contact;
        converged += all[i].converged;
      }
      if (!all[i].converged || i % static_cast<std::size_t>(every) != 0 ||
          all[i].depth < 1e-3 * probe->mass.radius)
        continue;
      ++looked_at;
      EXPECT_EQ(test::steepest_way_down(*probe, *fixed, all[i], tries, random), 0)
          << scene.name << ", tick " << i;
    }
    EXPECT_GT(looked_at, 2) << scene.name;
    EXPECT_GE(converged, contact - contact / 500) << scene.name;
    EXPECT_LE(falling, contact / 40) << scene.name;
  }
}

TEST(FittedParts, what_holds_a_probe_leaves_no_way_down) {
  expect_optima(test::fitted_scenes(), 600, 50, 200);
}
TEST(FittedParts, Full_what_holds_a_probe_leaves_no_way_down) {
  expect_optima(test::fitted_scenes(), 3000, 60, 1500);
}
TEST(FittedParts, what_holds_a_joint_leaves_no_way_down) {
  expect_optima(test::joint_scenes(), 1000, 100, 100);
}
TEST(FittedParts, Full_what_holds_a_joint_leaves_no_way_down) {
  expect_optima(test::joint_scenes(), 3000, 60, 1500);
}

// What a tick has no time for must not stop the next ones for ever: a device at rest is reached, or
// the probe is still on its way there (the loose nut, which turns through millimetres of thread).
TEST(FittedParts, a_device_at_rest_is_reached_however_little_a_tick_may_do) {
  constexpr std::int64_t work = 20000;  // some 0.2 ms: a whole tick may need a hundred times that
  constexpr int most_ticks = 1500, most_stuck = 60;
  std::vector<test::FittedScene> scenes = test::fitted_scenes();
  for (test::FittedScene& joint : test::joint_scenes()) scenes.push_back(std::move(joint));
  for (const test::FittedScene& scene : scenes) {
    const auto probe = test::body(scene.probe), fixed = test::body(scene.fixed);
    const std::vector<Pose> path = test::fitted_path(scene.path, 3000);
    CoherentSolver solver({probe, fixed});
    solver.reset(path.front());
    int longest_stuck = 0, reached = 0, rests = 0;
    for (std::size_t i = 0; i < path.size(); i += 600, ++rests) {
      double depth = -1;
      for (int tick = 0, stuck = 0; tick < most_ticks; ++tick) {
        const Separation& found = solver.tick(path[i], {.work = work});
        if (found.converged) {
          ++reached;
          break;
        }
        stuck = found.depth == depth ? stuck + 1 : 0;
        longest_stuck = std::max(longest_stuck, stuck);
        depth = found.depth;
      }
    }
    EXPECT_LE(longest_stuck, most_stuck) << scene.name;
    if (scene.name != "nut, loose") {
      EXPECT_EQ(reached, rests) << scene.name;
    }
  }
}

// The shape is the same: so is what is felt, but where a tick says that it fell.
TEST(FittedParts, how_walls_are_cut_changes_nothing) {
  constexpr int ticks = 700;
  const std::vector<test::FittedScene> plain = test::fitted_scenes_cut({});
  for (std::size_t s = 0; s < plain.size(); ++s) {
    const std::vector<Separation> want = follow(plain[s], ticks);
    double deepest = 0;
    for (const Separation& w : want) deepest = std::max(deepest, w.depth);
    for (const std::vector<double>& cuts : {test::even_strips(2), test::even_strips(3),
                                            test::even_strips(7), test::random_strips(4, 9)}) {
      const std::vector<Separation> got = follow(test::fitted_scenes_cut(cuts)[s], ticks);
      const auto probe = test::body(plain[s].probe);
      int other_way = 0;
      bool apart = false;  // after a fall they may lie at different optima
      for (std::size_t i = 0; i < got.size(); ++i) {
        apart = (apart || got[i].jumped || want[i].jumped) && got[i].status == Status::penetrating;
        const double off = farthest_move(probe->mass, got[i].separated, want[i].separated);
        if (off > 1e-3 * deepest) ++other_way;
        if (apart) continue;
        EXPECT_NEAR(got[i].depth, want[i].depth, 1e-3 * deepest)
            << plain[s].name << ", " << cuts.size() << " cuts, tick " << i;
      }
      EXPECT_LT(other_way, ticks / 20) << plain[s].name << ", " << cuts.size() << " cuts";
    }
  }
}

/// In parts of the largest energy: what a path neither stored nor gave back to the hand, at ticks
/// that jumped and at others. The work is that of the mean force of two ticks.
struct Ledger {
  double flagged = 0, unflagged = 0;
};
Ledger ledger(const test::FittedScene& scene, int ticks, const Budget& budget = {},
              std::size_t refused = 0) {
  const auto probe = test::body(scene.probe);
  const std::vector<Separation> all = follow(scene, ticks, budget, refused);
  double largest = 0, unsaid = 0;
  Ledger out;
  Wrench last;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const bool contact = all[i].status == Status::penetrating;
    const Wrench now =
        contact ? object_norm_wrench(probe->mass, all[i].device, all[i].separated, k) : Wrench();
    const SeparationMotion step = separation_motion(probe->mass, all[i - 1].device, all[i].device);
    const double given = 0.5 * (now.force + last.force).dot(step.t) +
                         0.5 * (now.torque + last.torque).dot(step.theta);
    const double lost = 0.5 * k * (all[i - 1].sigma - all[i].sigma) - given;
    (all[i].jumped ? out.flagged : out.unflagged) += lost;
    EXPECT_EQ(all[i].released > 0, all[i].jumped) << scene.name << ", tick " << i;
    const bool in_step = all[i].converged && all[i - 1].converged;
    unsaid = in_step ? 0 : std::max(0.0, unsaid + lost);
    if (all[i].jumped) {
      const double owed = all[i].lagged ? unsaid : std::max(unsaid, lost);
      EXPECT_NEAR(0.5 * k * all[i].released, owed, 0.05 * owed + 1e-5 * 0.5 * k * all[i].sigma)
          << scene.name << ", tick " << i;
      EXPECT_FALSE(all[i].lagged && in_step) << scene.name << ", tick " << i;
      unsaid = 0;
    }
    largest = std::max(largest, 0.5 * k * all[i].sigma);
    last = now;
  }
  return {out.flagged / largest, out.unflagged / largest};
}

// The mean force of two ticks is a good reference only where the device moves by far less than the
// depth in a tick, and not half a turn from the device, where a jammed nut is.
TEST(FittedParts, what_a_joint_lets_go_is_said) {
  for (const test::FittedScene& scene : test::joint_scenes()) {
    if (scene.name.ends_with("jammed")) continue;
    const int ticks = scene.name.starts_with("nut") ? 27000 : 6000;
    EXPECT_LT(std::abs(ledger(scene, ticks).unflagged), 1e-3) << scene.name;
  }
}

TEST(FittedParts, what_is_let_go_is_said) {
  for (const test::FittedScene& scene : test::fitted_scenes())
    for (const int ticks : {3000, 9000}) {
      const Ledger books = ledger(scene, ticks);
      EXPECT_LT(std::abs(books.unflagged), 1e-3) << scene.name << ", " << ticks << " ticks";
    }
}

// With little work a tick, the probe falls behind again and again, and what it loses is spread over
// the ticks in which it catches up.
TEST(FittedParts, what_is_let_go_behind_the_device_is_said) {
  constexpr Budget little{.work = 30'000};
  int behind = 0, lagged = 0, fell = 0;
  for (const test::FittedScene& scene : test::joint_scenes()) {
    if (!scene.name.starts_with("ball") && !scene.name.starts_with("studs")) continue;
    EXPECT_LT(std::abs(ledger(scene, 3000, little).unflagged), 2e-3) << scene.name;
    // A pose that is refused in between says nothing of what was held before.
    EXPECT_LT(std::abs(ledger(scene, 3000, little, 3).unflagged), 2e-3) << scene.name;
    for (const Separation& tick : follow(scene, 3000, little))
      behind += !tick.converged, lagged += tick.lagged, fell += tick.fell();
  }
  EXPECT_GT(behind, 100);
  EXPECT_GT(lagged, 50);
  EXPECT_GT(fell, 10);
}

}  // namespace
}  // namespace sonde
