// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/sonde.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <limits>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/app/run_program.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/contact_path.hpp"

namespace sonde {
namespace {

using ::testing::HasSubstr;
using Corners3 = std::array<std::uint32_t, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// A box about the origin, in triangles.
struct Box {
  std::vector<Vec3> vertices;
  std::vector<Corners3> triangles;
  explicit Box(const Vec3& size) {
    const PolygonSoup soup = test::box(size);
    vertices = soup.points;
    for (const Triangle& t : triangulate(soup).soup.triangles) triangles.push_back(t);
  }
  std::shared_ptr<const Body> body(Model model = Model::automatic) const {
    return make_body(vertices, triangles, model, "box");
  }
  std::string off() const {
    std::string out =
        "OFF\n" + std::to_string(vertices.size()) + " " + std::to_string(triangles.size()) + " 0\n";
    char line[100];
    for (const Vec3& x : vertices)
      std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", x[0], x[1], x[2]), out += line;
    for (const Corners3& t : triangles)
      std::snprintf(line, sizeof line, "3 %u %u %u\n", t[0], t[1], t[2]), out += line;
    return out;
  }
};
const Box brick({0.02, 0.03, 0.05}), block({0.3, 0.3, 0.1});

std::vector<Pose> some_poses() {
  const Quat q(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  return {{Quat::Identity(), Vec3(0.01, 0.02, 0.07)},
          {q, Vec3(0.14, -0.02, 0.03)},
          {q.conjugate(), Vec3(0, 0, 0.2)}};
}

void expect_same_bits(const Separation& x, const Separation& y) {
  EXPECT_EQ(x.status, y.status);
  EXPECT_EQ(x.depth, y.depth);
  EXPECT_EQ(x.separated.p, y.separated.p);
  EXPECT_EQ(x.separated.q.coeffs(), y.separated.q.coeffs());
  EXPECT_EQ(x.lower_bound, y.lower_bound);
  EXPECT_EQ(x.pdt, y.pdt);
  EXPECT_EQ(x.residual, y.residual);
  EXPECT_EQ(x.iterations, y.iterations);
  EXPECT_EQ(x.jumped, y.jumped);
  EXPECT_EQ(x.clusters.size, y.clusters.size);
}

std::string complaint_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

// Reference: a brick flat on a large block, 5 mm below its top, comes up by that.
TEST(Face, a_brick_pressed_into_a_block_comes_out_by_its_depth) {
  const Pair pair(brick.body(), block.body());
  const Pose X{Quat::Identity(), Vec3(0.01, 0.02, 0.05 + 0.025 - 0.005)};
  const Separation s = separate(pair, X);
  ASSERT_EQ(s.status, Status::penetrating);
  EXPECT_NEAR(s.depth, 0.005, 1e-3 * 0.005);
  ASSERT_TRUE(s.lower_bound.has_value());
  EXPECT_LE(*s.lower_bound, 0.005);
  Coupling coupling;
  coupling.k = 400;
  const Wrench w = wrench(pair, s, coupling);
  EXPECT_NEAR(w.force.z(), 2, 1e-2);
  EXPECT_LT(w.torque.norm(), 1e-3);
  EXPECT_FALSE(w.saturated);
}

TEST(Face, facts_are_those_of_the_box) {
  const BodyFacts of = facts(*brick.body());
  EXPECT_EQ(of.name, "box");
  EXPECT_EQ(of.triangles, 12u);
  EXPECT_EQ(of.degenerate, 0u);
  EXPECT_TRUE(of.solid);
  EXPECT_EQ(of.why, "closed: the inside counts");
  EXPECT_FALSE(of.turned);
  EXPECT_NEAR(of.mass.measure, 0.02 * 0.03 * 0.05, 1e-15);
  EXPECT_LT(of.mass.com.norm(), 1e-15);
  EXPECT_FALSE(facts(*brick.body(Model::surface)).solid);
}

TEST(Face, searches_are_those_of_the_engine_whoever_reads_the_mesh) {
  const test::TempFolder folder;
  const Pair made(brick.body(), block.body());
  const Pair read(read_body(folder.write("brick.off", brick.off())),
                  read_body(folder.write("block.off", block.off())));
  const Pair loaded(load_body((folder / "brick.off").string(), Model::automatic),
                    load_body((folder / "block.off").string(), Model::automatic));
  for (const Pose& X : some_poses())
    for (const Method method : {Method::pdg, Method::pdt}) {
      StaticOptions options;
      options.method = method;
      options.seed = 5;
      const Separation s = separate(made, X, options);
      expect_same_bits(s, separate(read, X, options));
      expect_same_bits(s, separate_static(loaded, X, options));
      options.two_threads = true;
      expect_same_bits(s, separate(made, X, options));
    }
}

std::string csv_of(const std::vector<Pose>& poses) {
  std::string out = "px,py,pz,qw,qx,qy,qz\n";
  char line[250];
  for (const Pose& X : poses)
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", X.p[0], X.p[1],
                  X.p[2], X.q.w(), X.q.x(), X.q.y(), X.q.z()),
        out += line;
  return out;
}

TEST(Face, searches_and_following_are_those_of_the_headless_program) {
  const test::TempFolder folder;
  folder.write("brick.off", brick.off());
  folder.write("block.off", block.off());
  folder.write("poses.csv", csv_of(some_poses()));
  const Pair pair(read_body(folder / "brick.off"), read_body(folder / "block.off"));
  Follower follower(pair);
  StaticOptions options;
  options.seed = 7;
  for (const std::string mode : {"static", "coherent"}) {
    const test::Outcome run = test::sonde_in(
        folder.path(),
        "query --probe brick.off --fixed block.off --poses poses.csv --seed 7 --mode " + mode);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const test::Csv rows(run.out);
    ASSERT_EQ(rows.rows.size(), some_poses().size());
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      const Pose X = some_poses()[i];
      StaticOptions own = options;
      own.seed = seed_of_pose(7, X);
      const Separation s = mode == "static" ? separate(pair, X, own)
                           : i == 0         ? follower.start(X, options)
                                            : follower.follow(X);
      EXPECT_EQ(rows.number(i, "depth"), s.depth) << mode << " " << i;
      EXPECT_EQ(rows.number(i, "px"), s.separated.p.x()) << mode << " " << i;
      EXPECT_EQ(rows.number(i, "qw"), s.separated.q.w()) << mode << " " << i;
      EXPECT_EQ(rows.number(i, "iterations"), s.iterations) << mode << " " << i;
    }
  }
}

TEST(Face, following_and_wrenches_are_those_of_the_haptic_loop_and_allocate_nothing) {
  constexpr double dt = 1e-3;
  constexpr int ticks = 200;
  for (const test::ContactPair& bodies : test::contact_pairs()) {
    const Pair pair(bodies.probe, bodies.fixed);
    for (const Coupling::Mode mode : {Coupling::Mode::object, Coupling::Mode::classic}) {
      Coupling coupling;
      coupling.mode = mode;
      coupling.k = coupling.k_t = 2000;
      coupling.b_t = 3;
      coupling.b_r = 1e-3;
      coupling.max_force = 8;
      HapticLoop loop(pair, Method::pdg, coupling);
      Follower follower(pair);
      const Pose first = test::contact_path(bodies, 0.4);
      loop.reset(first, {});
      expect_same_bits(loop.separation(), follower.start(first));
      EXPECT_EQ(loop.wrench().force, wrench(pair, follower.last(), coupling).force);
      // The loop takes its first rate from its second tick on.
      Separation before;
      int saturated = 0, in_contact = 0;
      for (int i = 0; i <= ticks; ++i) {
        const Pose X = test::contact_path(bodies, 0.4 + 0.6 * i / ticks);
        loop.tick(X, dt, {});
        test::AllocationCounter counter;
        const Separation& now = follower.follow(X);
        const Wrench felt = wrench(pair, now, before, dt, coupling);
        counter.stop();
        EXPECT_EQ(counter.allocations() + counter.frees(), 0u) << bodies.name;
        expect_same_bits(loop.separation(), now);
        ASSERT_EQ(loop.wrench().force, felt.force) << bodies.name << " " << i;
        ASSERT_EQ(loop.wrench().torque, felt.torque) << bodies.name << " " << i;
        ASSERT_EQ(loop.wrench().saturated, felt.saturated) << bodies.name << " " << i;
        saturated += felt.saturated;
        in_contact += now.status == Status::penetrating;
        before = now;
      }
      EXPECT_GT(in_contact, ticks / 10) << bodies.name;
      EXPECT_LT(in_contact, ticks) << bodies.name;
      EXPECT_GT(saturated, 0) << bodies.name;  // or the limits were not tested
    }
  }
}

TEST(Face, a_follower_that_has_not_started_says_so) {
  Follower follower(Pair(brick.body(), block.body()));
  EXPECT_EQ(follower.last().status, Status::failed);
  EXPECT_EQ(follower.follow({}).status, Status::failed);
  EXPECT_EQ(follower.start({Quat::Identity(), Vec3(0, 0, 1)}).status, Status::separated);
  EXPECT_EQ(follower.follow({Quat::Identity(), Vec3(nan, 0, 0)}).status, Status::failed);
  EXPECT_EQ(follower.follow({Quat::Identity(), Vec3(0, 0, 0.9)}).status, Status::separated);
}

TEST(Face, a_pose_that_is_no_pose_fails_with_a_reason) {
  const Pair pair(brick.body(), block.body());
  Follower follower(pair);
  ASSERT_EQ(follower.start({Quat::Identity(), Vec3(0, 0, 1)}).status, Status::separated);
  for (const auto& [X, word] : {std::pair{Pose{Quat::Identity(), Vec3(0, nan, 0)}, "finite"},
                                {Pose{Quat(0, 0, 0, 0), Vec3::Zero()}, "length"},
                                {Pose{Quat(1e160, 0, 0, 0), Vec3::Zero()}, "length"},
                                {Pose{Quat(1e-160, 0, 0, 0), Vec3::Zero()}, "length"},
                                {Pose{Quat(inf, 0, 0, 0), Vec3::Zero()}, "finite"}}) {
    const Separation s = separate(pair, X);
    EXPECT_EQ(s.status, Status::failed);
    EXPECT_THAT(s.reason, HasSubstr(word));
    EXPECT_EQ(wrench(pair, s, {}).force, Vec3::Zero().eval());
    EXPECT_EQ(follower.follow(X).status, Status::failed);
    EXPECT_THAT(follower.last().reason, HasSubstr(word));
  }
}

TEST(Face, options_that_make_no_sense_are_refused_by_name) {
  const Pair pair(brick.body(), block.body());
  const Pose X = some_poses()[0];
  const auto refused = [&](const StaticOptions& options, const std::string& word) {
    EXPECT_THAT(complaint_of([&] { separate(pair, X, options); }), HasSubstr(word));
    EXPECT_THAT(complaint_of([&] { signed_distance(pair, X, options); }), HasSubstr(word));
    Follower follower(pair);
    EXPECT_THAT(complaint_of([&] { follower.start(X, options); }), HasSubstr(word));
    EXPECT_EQ(follower.last().status, Status::failed) << "it has not started";
  };
  refused({.method = static_cast<Method>(7)}, "method");
  refused({.budget = {.steps = -1}}, "budget.steps");
  refused({.budget = {.microseconds = std::numeric_limits<double>::quiet_NaN()}},
          "budget.microseconds");
  refused({.starts = 0}, "starts");
  refused({.starts = -5}, "starts");
  refused({.agreement = -1}, "agreement");
  for (const double sure : {nan, -1.0, 0.0, 1.0, 5.0}) refused({.sure = sure}, "sure");
  for (const double share : {nan, -0.1, 1.1})
    refused({.share_for_bound = share}, "share_for_bound");
  for (const Budget& budget : {Budget{.steps = -1}, Budget{.microseconds = -1},
                               Budget{.microseconds = nan}, Budget{.work = -1}}) {
    refused({.budget = budget}, "budget");
    Follower follower(pair);
    follower.start({Quat::Identity(), Vec3(0, 0, 1)});
    EXPECT_THAT(follower.follow(X, budget).reason, HasSubstr("budget"));
    EXPECT_EQ(follower.follow(X).status, Status::penetrating) << "it goes on from before";
  }
}

TEST(Face, what_is_not_finite_does_not_reach_the_hand) {
  const Pair pair(brick.body(), block.body());
  const Separation s = separate(pair, some_poses()[0]);
  ASSERT_EQ(s.status, Status::penetrating);
  for (const double bad : {nan, inf}) {
    Coupling coupling;
    coupling.k = bad;
    const Wrench w = wrench(pair, s, coupling);
    EXPECT_EQ(w.force, Vec3::Zero().eval());
    EXPECT_TRUE(w.saturated);
  }
}

TEST(Face, triangles_that_are_none_are_refused_with_the_reason) {
  const auto made = [](const Box& box, Model model = Model::automatic) {
    return complaint_of([&] { box.body(model); });
  };
  Box box = brick;
  box.triangles.clear();
  EXPECT_EQ(made(box), "box: no triangles");
  box = brick;
  box.vertices[3].y() = nan;
  EXPECT_EQ(made(box), "box: vertex 3 is not finite");
  box = brick;
  box.triangles[2][1] = 8;
  EXPECT_EQ(made(box), "box: triangle 2: there is no vertex 8, only 8");
  box = brick;
  box.triangles.resize(11);
  EXPECT_EQ(made(box), "no InputError");                // a surface
  EXPECT_EQ(made(box, Model::solid), "no InputError");  // its opening is closed
  box.triangles.resize(1);                              // a sheet
  EXPECT_THAT(made(box, Model::solid), HasSubstr("box: cannot be a solid: 3 open edges"));
  box.triangles = {{0, 0, 1}};
  EXPECT_EQ(made(box), "box: no triangle has an area");
}

TEST(Face, files_that_are_no_meshes_are_refused_with_the_reason) {
  const test::TempFolder folder;
  const auto read = [&](const char* name, double scale = 1) {
    return complaint_of([&] { read_body(folder / name, Model::automatic, scale); });
  };
  folder.write("brick.off", brick.off());
  folder.write("empty.off", "OFF\n0 0 0\n");
  folder.write("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n");
  folder.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  EXPECT_THAT(read("missing.off"), HasSubstr("missing.off: "));
  EXPECT_THAT(read("empty.off"), HasSubstr("empty.off:2: "));
  EXPECT_THAT(read("nan.off"), HasSubstr("nan.off:4: "));
  EXPECT_THAT(read("flat.off"), HasSubstr("flat.off: no triangle has an area"));
  for (const double scale : {0.0, -1.0, nan, inf})
    EXPECT_THAT(read("brick.off", scale), HasSubstr("brick.off: the scale must be positive"));
  EXPECT_THROW(read_body(folder / "brick.off", Model::automatic, 1, [](double) { return false; }),
               Cancelled);
}

// The example of the manual, compiled with this header alone and linked with sonde::engine alone.
TEST(Face, the_example_prints_the_depth_of_two_files) {
  const test::TempFolder folder;
  Box askew = brick;
  for (Vec3& x : askew.vertices) x += Vec3(0.01, 0.02, 0.06);
  const auto probe = folder.write("askew.off", askew.off()),
             fixed = folder.write("block.off", block.off());
  const auto run = [&](const std::string& arguments) {
    const std::string to = (folder / "out").string();
    const int status =
        std::system(("'" SONDE_EXAMPLE "' " + arguments + " >'" + to + "' 2>&1").c_str());
    return std::pair(WEXITSTATUS(status), test::text_of(to));
  };
  const auto [code, text] = run("'" + probe.string() + "' '" + fixed.string() + "'");
  EXPECT_EQ(code, 0) << text;
  EXPECT_EQ(std::stod(text), separate({askew.body(), block.body()}, {}).depth);
  EXPECT_NEAR(std::stod(text), 0.015, 1.5e-5);  // straight up, out of the block
  const auto [bad, reason] = run("missing.off '" + fixed.string() + "'");
  EXPECT_EQ(bad, 1);
  EXPECT_THAT(reason, HasSubstr("missing.off: "));
}

// Reference: the boxes' faces: the way out along z is 0.005, and no answer is below the bound.
TEST(Face, one_knob_is_a_time_or_an_accuracy) {
  const Pair pair(brick.body(), block.body());
  const Pose pose{Quat::Identity(), Vec3(0.01, 0.02, 0.07)};
  for (const Knob& knob : {Knob{}, Knob{.time = 5e-3}, Knob{.accuracy = 0.05}}) {
    const Answer answer = separate(pair, pose, knob);
    ASSERT_EQ(answer.separation.status, Status::penetrating);
    EXPECT_LE(answer.separation.depth, 0.005 * 1.05);
    EXPECT_FALSE(answer.separation.lower_bound);
  }
  EXPECT_EQ(separate(pair, {Quat::Identity(), Vec3(1, 0, 0)}, Knob{.time = 1e-3}).claim.by,
            Claim::By::certified);
  for (const Knob& knob :
       {Knob{.time = -1}, Knob{.time = nan}, Knob{.time = inf}, Knob{.accuracy = -0.1},
        Knob{.accuracy = 1}, Knob{.accuracy = 10}, Knob{.accuracy = nan},
        Knob{.time = 1, .accuracy = 0.1}, Knob{.sure = 0}, Knob{.sure = 1}, Knob{.sure = nan}})
    EXPECT_THROW(separate(pair, pose, knob), InputError) << knob.time << ", " << knob.accuracy;
}

// Reference: of the same answers, fewer keep to a narrower claim: none is wider where less is
// asked.
TEST(Face, the_surer_the_wider_the_claim) {
  const Pair pair(brick.body(), block.body());
  const Pose pose{Quat::Identity(), Vec3(0.01, 0.02, 0.07)};
  double before = 0;
  for (const double sure : {0.5, 0.9, 0.99}) {
    const Answer answer = separate(pair, pose, {.time = 0.05, .sure = sure});
    ASSERT_EQ(answer.claim.by, Claim::By::expected);
    EXPECT_GE(answer.claim.within, before) << sure;
    before = answer.claim.within;
  }
  EXPECT_GT(before, 0);
}

// Reference: the clock: no search of two bodies takes a nanosecond.
TEST(Face, a_time_that_was_not_had_is_said) {
  const Pair pair(brick.body(), block.body());
  const Pose pose{Quat::Identity(), Vec3(0.01, 0.02, 0.07)};
  EXPECT_TRUE(separate(pair, pose, Knob{.time = 1e-9}).late);
  EXPECT_FALSE(separate(pair, pose, Knob{}).late) << "there is no limit";
}

}  // namespace
}  // namespace sonde
