// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that lie on each other: how finely they are cut does not change what is felt. References:
// closed forms, where the free space is a wedge of planes; and the same shape in the coarsest mesh
// there is of it, which the first test of each scene compares with its closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/engine/penetration/conforming_checks.hpp"

namespace sonde {
namespace {

using test::ConformingScene;
using test::Cutting;
using test::expect_felt_as;
using test::expect_followed;
using test::expect_free_at_the_ends;
using test::expect_no_friction_and_no_glue;
using test::Felt;
using test::follow;
using test::Skew;

const char* name(Cutting::Kind kind) {
  return kind == Cutting::Kind::regular  ? "regular"
         : kind == Cutting::Kind::random ? "random"
                                         : "slivers";
}

std::string describe(const ConformingScene& scene, const Cutting& cutting, const Skew& skew) {
  return scene.name + ", n = " + std::to_string(cutting.n) + " " + name(cutting.kind) +
         (skew.world.isApprox(Quat::Identity()) ? "" : ", askew");
}

/// The coarsest mesh of a scene, and so what all others are compared with.
std::vector<Felt> coarsest(const ConformingScene& scene) {
  return follow(cut_bodies(scene, {}), scene.path);
}

/// The scene as finely cut as that gives what the coarsest gives.
std::vector<Felt> expect_as_coarsest(const ConformingScene& scene, const std::vector<Felt>& want,
                                     double arm, const Cutting& cutting, const Skew& skew = {}) {
  const std::string what = describe(scene, cutting, skew);
  const auto felt = follow(cut_bodies(scene, cutting, skew), scene.path, skew);
  expect_followed(felt, 0, what);
  expect_free_at_the_ends(felt, what);
  expect_felt_as(felt, want, arm, 0.01, what);
  return felt;
}

const std::vector<int> sample = {2, 7, 24};
const std::vector<int> all = {2, 3, 4, 5, 6, 8, 10, 13, 16, 20, 24, 27, 31, 36, 40};

// Half sizes, the arms that torques are measured with.
constexpr double block_arm = 0.03, rod_arm = 0.015, wedge_arm = 0.02;

/// Where a tilt is too small to feel, the force is along the slab's normal.
void expect_block_felt(const ConformingScene& scene, const std::vector<Felt>& want,
                       const Cutting& cutting, const Skew& skew = {}) {
  const auto felt = expect_as_coarsest(scene, want, block_arm, cutting, skew);
  expect_no_friction_and_no_glue(felt, Vec3::UnitZ(), describe(scene, cutting, skew));
}

// Reference: the mass of the coarsest mesh, and its topology.
TEST(Conforming, shapes_stay_the_same_however_they_are_cut) {
  std::vector<ConformingScene> scenes = {test::block_on_slab(), test::cylinder_in_hole(),
                                         test::wedge_in_notch()};
  for (const double clearance : {1e-5, 1e-4, 5e-4})
    scenes.push_back(test::peg_in_hole(clearance, {}));
  for (const ConformingScene& scene : scenes)
    for (const auto& shape : {scene.probe, scene.fixed}) {
      const auto coarse = test::body(shape({}));
      ASSERT_TRUE(coarse->solid) << scene.name << coarse->why;
      ASSERT_FALSE(coarse->turned) << scene.name;
      for (const int n : {2, 9})
        for (const auto kind :
             {Cutting::Kind::regular, Cutting::Kind::random, Cutting::Kind::slivers}) {
          const auto fine = test::body(shape({n, kind}));
          const std::string what = describe(scene, {n, kind}, {});
          EXPECT_TRUE(fine->topology.closed) << what << fine->why;
          EXPECT_EQ(fine->topology.nonmanifold_edges, 0u) << what;
          EXPECT_EQ(fine->degenerate, 0u) << what;
          EXPECT_FALSE(fine->turned) << what;
          EXPECT_GT(fine->soup.triangles.size(), coarse->soup.triangles.size()) << what;
          const MassProperties &a = coarse->mass, &b = fine->mass;
          EXPECT_NEAR(a.measure, b.measure, 1e-12 * a.measure) << what;
          EXPECT_LE((a.com - b.com).norm(), 1e-12 * a.radius) << what;
          EXPECT_LE((a.inertia - b.inertia).norm(), 1e-11 * a.inertia.norm()) << what;
          EXPECT_NEAR(a.radius, b.radius, 1e-12 * a.radius) << what;
        }
    }
}

// Reference: the closed form. The face's plane is the only row, so depth is how far it is below.
TEST(Conforming, block_pressed_on_a_slab_feels_its_depth_along_the_normal) {
  const ConformingScene scene = test::block_on_slab();
  const auto felt = coarsest(scene);
  expect_followed(felt, 0, scene.name);
  expect_free_at_the_ends(felt, scene.name);
  expect_no_friction_and_no_glue(felt, Vec3::UnitZ(), scene.name);
  std::vector<Felt> want(felt.size());
  for (std::size_t i = 0; i < felt.size(); ++i)
    want[i].force.z() =
        test::felt_stiffness * std::max(0.0, test::pressed_into_slab(scene.path[i]));
  EXPECT_NEAR(largest_force(want), test::felt_stiffness * 3e-3, 1e-9);
  expect_felt_as(felt, want, block_arm, 0.001, scene.name);
}

void block_in_every_cut(const std::vector<int>& cuts, const Skew& skew = {}) {
  const ConformingScene scene = test::block_on_slab();
  const auto want = coarsest(scene);
  for (const int n : cuts) expect_block_felt(scene, want, {n}, skew);
}

TEST(Conforming, block_on_a_slab_feels_the_same_however_it_is_cut) { block_in_every_cut(sample); }
TEST(Conforming, block_on_a_slab_feels_the_same_askew_to_the_axes) {
  block_in_every_cut({1, 6, 16}, test::askew());
}
TEST(Conforming, Full_block_on_a_slab_feels_the_same_however_it_is_cut) { block_in_every_cut(all); }
TEST(Conforming, Full_block_on_a_slab_feels_the_same_askew_to_the_axes) {
  block_in_every_cut(all, test::askew());
}

void block_in_odd_cuts(const std::vector<int>& cuts, int seeds) {
  const ConformingScene scene = test::block_on_slab();
  const auto want = coarsest(scene);
  for (const int n : cuts) {
    for (int seed = 0; seed < seeds; ++seed)
      expect_block_felt(scene, want, {n, Cutting::Kind::random, std::uint64_t(seed)});
    expect_block_felt(scene, want, {n, Cutting::Kind::random, 77}, test::askew());
    expect_block_felt(scene, want, {n, Cutting::Kind::slivers});
    expect_block_felt(scene, want, {n, Cutting::Kind::slivers}, test::askew());
  }
}

TEST(Conforming, block_on_a_slab_feels_the_same_cut_at_random_or_into_slivers) {
  block_in_odd_cuts({4, 12}, 1);
}
TEST(Conforming, Full_block_on_a_slab_feels_the_same_cut_at_random_or_into_slivers) {
  block_in_odd_cuts(all, 3);
}

void block_off_by_little(const std::vector<int>& cuts) {
  const ConformingScene scene = test::block_on_slab_off(1.745e-4);  // 0.01°
  const auto want = coarsest(scene);
  expect_followed(want, 0, "coarsest");
  for (const int n : cuts) {
    expect_as_coarsest(scene, want, block_arm, {n});
    expect_as_coarsest(scene, want, block_arm, {n, Cutting::Kind::random}, test::askew());
  }
}

TEST(Conforming, block_a_hundredth_of_a_degree_off_feels_the_same_however_it_is_cut) {
  block_off_by_little(sample);
}
TEST(Conforming, Full_block_a_hundredth_of_a_degree_off_feels_the_same_however_it_is_cut) {
  block_off_by_little(all);
}

// 300 copies of each triangle are the same set of points, and of the same mass.
TEST(Conforming, copies_of_a_triangle_change_nothing) {
  const ConformingScene scene = test::block_on_slab();
  const auto want = coarsest(scene);
  for (const int n : {1, 3}) {
    const Cutting cutting{n};
    const auto probe = test::body(test::repeated(scene.probe(cutting), 300));
    const auto fixed = test::body(test::repeated(scene.fixed(cutting), 300));
    ASSERT_TRUE(probe->solid && fixed->solid);
    for (const auto& bodies : {test::BodyPairCut{probe, test::body(scene.fixed(cutting))},
                               test::BodyPairCut{test::body(scene.probe(cutting)), fixed},
                               test::BodyPairCut{probe, fixed}}) {
      const std::string what = "copies, n = " + std::to_string(n);
      const auto felt = follow(bodies, scene.path);
      expect_followed(felt, 0, what);
      expect_free_at_the_ends(felt, what);
      expect_felt_as(felt, want, block_arm, 0.01, what);
      expect_no_friction_and_no_glue(felt, Vec3::UnitZ(), what);
    }
  }
}

// Reference: the closed form, until it turns: the facet's plane is the only row.
TEST(Conforming, cylinder_pressed_sideways_feels_its_depth_along_the_facets_normal) {
  const ConformingScene scene = test::cylinder_in_hole();
  const auto felt = coarsest(scene);
  expect_followed(felt, 0, scene.name);
  expect_free_at_the_ends(felt, scene.name);
  std::vector<Felt> pure, want;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    if (!scene.path[i].q.isApprox(Quat::Identity())) continue;
    pure.push_back(felt[i]);
    want.emplace_back();
    want.back().force = test::felt_stiffness *
                        std::max(0.0, test::pressed_into_hole(scene.path[i])) * test::hole_normal();
  }
  EXPECT_GT(largest_force(want), test::felt_stiffness * 4e-4);
  expect_felt_as(pure, want, rod_arm, 0.001, scene.name);
  expect_no_friction_and_no_glue(pure, test::hole_normal(), scene.name);
}

void in_every_cut(const ConformingScene& scene, double arm, const std::vector<int>& cuts) {
  const auto want = coarsest(scene);
  expect_followed(want, 0, scene.name + ", coarsest");
  for (const int n : cuts) {
    expect_as_coarsest(scene, want, arm, {n});
    expect_as_coarsest(scene, want, arm, {n, Cutting::Kind::random}, test::askew());
    expect_as_coarsest(scene, want, arm, {n, Cutting::Kind::slivers});
  }
}

TEST(Conforming, cylinder_in_a_hole_feels_the_same_however_it_is_cut) {
  in_every_cut(test::cylinder_in_hole(), rod_arm, {3, 12});
}
TEST(Conforming, Full_cylinder_in_a_hole_feels_the_same_however_it_is_cut) {
  in_every_cut(test::cylinder_in_hole(), rod_arm, all);
}

// Reference: the closed form. Two planes meet in the seat, and as long as the push is between
// their normals the nearest free place is there.
TEST(Conforming, wedge_pressed_into_a_notch_is_seated) {
  const ConformingScene scene = test::wedge_in_notch();
  const auto felt = coarsest(scene);
  expect_followed(felt, 0, scene.name);
  expect_free_at_the_ends(felt, scene.name);
  std::vector<Felt> want(felt.size());
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const Vec3& p = scene.path[i].p;
    if (p.z() < 0) want[i].force = -test::felt_stiffness * Vec3(p.x(), 0, p.z());
  }
  expect_felt_as(felt, want, wedge_arm, 0.001, scene.name);
}

TEST(Conforming, wedge_in_a_notch_feels_the_same_however_it_is_cut) {
  in_every_cut(test::wedge_in_notch(), wedge_arm, {3, 12});
}
TEST(Conforming, Full_wedge_in_a_notch_feels_the_same_however_it_is_cut) {
  in_every_cut(test::wedge_in_notch(), wedge_arm, all);
}

/// Reference: the closed forms, where the pressed pose is 3 mm below the slab's face, and where it
/// is 1.5 mm aside and 2 mm below the seat.
void search_in_every_cut(const std::vector<int>& cuts) {
  const ConformingScene block = test::block_on_slab(), wedge = test::wedge_in_notch();
  for (const int n : cuts)
    for (const Method method : {Method::pdg, Method::pdt})
      for (const auto& [scene, tick, depth] :
           {std::tuple{&block, 100, 3e-3}, std::tuple{&wedge, 70, 2.5e-3}}) {
        const auto bodies = cut_bodies(*scene, {n});
        StaticOptions options;
        options.method = method;
        options.want_lower_bound = false;
        const Separation s = separate_static({bodies.probe, bodies.fixed},
                                             scene->path[static_cast<std::size_t>(tick)], options);
        ASSERT_EQ(s.status, Status::penetrating) << describe(*scene, {n}, {});
        EXPECT_NEAR(s.depth, depth, 0.01 * depth)
            << describe(*scene, {n}, {}) << (method == Method::pdt ? ", translation only" : "");
      }
}

TEST(Conforming, search_finds_the_same_depth_however_it_is_cut) { search_in_every_cut({1, 4}); }
TEST(Conforming, Full_search_finds_the_same_depth_however_it_is_cut) {
  search_in_every_cut({1, 3, 8, 16, 24, 40});
}

/// Every point moved by chance, by no more than so much (m), and the same for the same point: no
/// two triangles of a face lie in one plane, and none can be joined.
PolygonSoup shaken(PolygonSoup soup, double by) {
  for (Vec3& x : soup.points) {
    std::uint64_t seed = 1;
    for (const double at : x) seed = seed * 1000003 + std::uint64_t(std::llround(at * 1e9));
    std::mt19937_64 random(seed);
    x += by * Vec3(test::uniform(random, -1, 1), test::uniform(random, -1, 1),
                   test::uniform(random, -1, 1));
  }
  return soup;
}

/// Reference: the coarsest mesh of the same shapes. The rod has to go back into its hole, where
/// there is 1 % of room.
void search_unjoined_faces(const std::vector<int>& cuts) {
  constexpr double shake = 1e-7;
  const ConformingScene block = test::block_on_slab(), rod = test::cylinder_in_hole();
  for (const auto& [scene, tick] : {std::pair{&block, std::size_t{100}}, {&rod, 60}})
    for (const Method method : {Method::pdg, Method::pdt}) {
      double want = 0;
      for (const int n : cuts)
        for (const auto& skew : {Skew{}, test::askew()}) {
          const Cutting of_probe{n, Cutting::Kind::random};
          const Cutting of_fixed{n == 1 ? 1 : n + 3, Cutting::Kind::random, 1001};
          const auto probe =
              test::body(test::turned(shaken(scene->probe(of_probe), shake), skew.probe));
          const auto fixed =
              test::body(test::turned(shaken(scene->fixed(of_fixed), shake), skew.world));
          const Pose X = Pose{skew.world, Vec3::Zero()} * scene->path[tick] *
                         Pose{skew.probe.conjugate(), Vec3::Zero()};
          StaticOptions options;
          options.method = method;
          options.want_lower_bound = false;
          const Separation s = separate_static(Pair(probe, fixed), X, options);
          ASSERT_EQ(s.status, Status::penetrating) << describe(*scene, of_probe, skew);
          EXPECT_TRUE(s.converged) << describe(*scene, of_probe, skew);
          if (want == 0) want = s.depth;
          EXPECT_NEAR(s.depth, want, 0.01 * want) << describe(*scene, of_probe, skew);
        }
    }
}

/// The upper block is pressed down by 0.03 m, and then moved aside and turned, so far that the
/// waves hold it in its seat.
std::vector<Pose> pressed_and_turned(int ticks) {
  std::vector<Pose> out;
  for (int k = 0; k < ticks; ++k) {
    const double down = std::min(1.0, 2.0 * k / ticks), on = std::max(0.0, 2.0 * k / ticks - 1);
    out.push_back({rotation_by(Vec3(0, 0, 0.01 * on)), {0.006 * on, 0, 0.001 - 0.031 * down}});
  }
  return out;
}

/// Checks the tick's depth against that of the way back to the seat, which the whole wavy face
/// holds: a closed form. The returned pose may lie above it by the promised clearance.
void expect_seated(const Body& probe, const Separation& found) {
  const Pose seat{Quat::Identity(), Vec3::Zero()};
  const double want = Chart(probe.mass, found.device).coordinates(seat).norm();
  EXPECT_TRUE(found.converged) << want << " m";
  EXPECT_NEAR(found.depth, want, allowed_clearance(probe.mass.radius, want)) << want << " m";
}

// Some 42 000 pairs of triangles touch.
TEST(Conforming, a_wavy_face_in_its_like_is_held_by_all_of_it) {
  const auto probe = test::body(test::wavy_block(test::WavyBlock::above, 40));
  const auto fixed = test::body(test::wavy_block(test::WavyBlock::below, 40));
  CoherentSolver solver({probe, fixed});
  const std::vector<Pose> path = pressed_and_turned(30);
  solver.reset(path.front());
  for (const Pose& device : path) {
    const Separation& found = solver.tick(device);
    if (device.p.z() < -1e-3) expect_seated(*probe, found);
  }
}

// Some 170 000 pairs touch, and no neighbour list holds them. The block is pressed and turned so
// far that it rides up on the waves. Reference: the way back to the seat, an upper bound.
TEST(Conforming, a_probe_with_more_pairs_than_lists_hold_arrives_while_the_device_rests) {
  const auto probe = test::body(test::wavy_block(test::WavyBlock::above, 80));
  const auto fixed = test::body(test::wavy_block(test::WavyBlock::below, 80));
  CoherentSolver solver({probe, fixed});
  const auto device = [](int k) {
    return Pose{rotation_by(Vec3(0, 0, k / 3e3)), {0, 0, 0.05 - k / 1e3}};
  };
  solver.reset(device(40));
  int k = 50, late = 0;
  for (; k < 80; ++k) late += !solver.tick(device(k)).converged;
  EXPECT_GT(late, 0) << "or the limit is not tested";
  int ticks = 0;
  while (!solver.last().converged && ++ticks < 60) {
    EXPECT_GT(solver.last().limited, 0);
    Pose trembling = device(k);
    trembling.p.x() += ticks % 2 * 1e-9;  // no device rests to the bit
    solver.tick(trembling);
  }
  EXPECT_TRUE(solver.last().converged);
  const double seated =
      Chart(probe->mass, device(k)).coordinates(Pose{Quat::Identity(), Vec3::Zero()}).norm();
  EXPECT_LT(solver.last().depth, seated + allowed_clearance(probe->mass.radius, seated));
}

TEST(Conforming, search_finds_the_same_depth_in_faces_that_cannot_be_joined) {
  search_unjoined_faces({1, 5, 10});
}
TEST(Conforming, Full_search_finds_the_same_depth_in_faces_that_cannot_be_joined) {
  search_unjoined_faces({1, 5, 10, 20});
}

}  // namespace
}  // namespace sonde
