// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/model_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <random>
#include <set>
#include <utility>

#include "engine/geometry/mass_integrals.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Sound meshes, each of its own kind and size.
std::vector<PolygonSoup> sound() {
  return {test::box({1, 2, 3}), test::icosphere(0.02, 3), test::torus(50, 12, 40, 20),
          test::prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, 2)};
}

void expect_same_mass(const Body& broken, const Body& whole, double tolerance) {
  EXPECT_TRUE(broken.solid) << broken.why;
  EXPECT_NEAR(broken.mass.measure, whole.mass.measure, tolerance * whole.mass.measure);
  EXPECT_LT((broken.mass.com - whole.mass.com).norm(), tolerance * whole.mass.radius);
  EXPECT_LT((broken.mass.inertia - whole.mass.inertia).norm(),
            4 * tolerance * whole.mass.inertia[2]);
}

// Reference, here and below: the mesh before it was broken.
TEST(ModelChoice, a_mirrored_part_counts_as_the_other) {
  for (const PolygonSoup& mesh : sound()) {
    const auto one = test::body(mesh);
    const Vec3 away(5 * one->mass.radius, 0, 0);
    const auto both = test::body(test::joined(mesh, test::placed(mesh, away)));
    const auto mixed = test::body(test::joined(mesh, test::turned_over(test::placed(mesh, away))));
    expect_same_mass(*mixed, *both, 1e-12);
    EXPECT_EQ(mixed->repairs.turned_parts, 1u);
    EXPECT_FALSE(mixed->turned);
  }
}

// The mirrored half of a part, closed or not at the plane, as it comes out inside out.
TEST(ModelChoice, a_mirrored_half_that_touches_counts) {
  for (const bool open : {false, true})
    for (const PolygonSoup& mesh :
         {test::box({1, 1, 1}), test::prism({{0, -1}, {2, 0}, {0, 1}}, 1)}) {
      PolygonSoup half = mesh;
      double low = 1e9;
      for (const Vec3& x : half.points) low = std::min(low, x.x());
      half = test::placed(half, {-low, 0, 0});  // its flat side in x = 0
      if (open) half = test::without(half, [](const Vec3& x) { return x.x() < 1e-9; });
      // Mirrored without turning its triangles: inside out.
      const PolygonSoup mirrored =
          test::moved(half, [](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); });
      const auto body = test::body(test::joined(half, mirrored));
      const auto whole = test::body(mesh);
      EXPECT_TRUE(body->solid) << body->why;
      EXPECT_NEAR(body->mass.measure, 2 * whole->mass.measure, 1e-12);
      EXPECT_NEAR(body->mass.com.x(), 0, 1e-12);
    }
}

TEST(ModelChoice, cracks_are_closed) {
  std::uint64_t seed = 0;
  for (const PolygonSoup& mesh : sound())
    for (const double by : {1e-15, 1e-8, 1e-6}) {
      const auto whole = test::body(mesh);
      const auto broken = test::body(test::cracked(mesh, by * whole->mass.radius, ++seed));
      expect_same_mass(*broken, *whole, 1e-12 + 10 * by);
      EXPECT_TRUE(broken->cracked);
      EXPECT_EQ(broken->repairs.caps, 0u);
      // No coordinate moves.
      EXPECT_EQ(broken->soup.vertices.size(), 3 * whole->soup.triangles.size());
    }
}

TEST(ModelChoice, corners_on_sides_are_cuts) {
  for (const PolygonSoup& mesh : sound())
    for (const double by : {0.0, 1e-7}) {
      const auto whole = test::body(mesh);
      const auto broken = test::body(test::cut_beyond(mesh, Vec3(1, 0.3, 0.2),
                                                      whole->mass.com.dot(Vec3(1, 0.3, 0.2)),
                                                      by * whole->mass.radius));
      expect_same_mass(*broken, *whole, 1e-12 + 10 * by);
      EXPECT_GT(broken->repairs.on_edges, 0u);
    }
}

TEST(ModelChoice, a_triangle_missing_or_turned_or_repeated_is_mended) {
  for (const PolygonSoup& mesh : {test::icosphere(0.02, 3), test::torus(50, 12, 40, 20),
                                  test::torus_knot(2, 3, 2, 0.7, 0.3, 90, 12)}) {
    const PolygonSoup triangles = test::triangulated(mesh);
    const auto whole = test::body(mesh);
    for (const std::size_t k : {std::size_t{0}, triangles.polygons.size() / 2}) {
      PolygonSoup missing = triangles, over = triangles, twice = triangles;
      missing.polygons.erase(missing.polygons.begin() + static_cast<std::ptrdiff_t>(k));
      std::swap(over.polygons[k][1], over.polygons[k][2]);
      twice.polygons.push_back(twice.polygons[k]);
      expect_same_mass(*test::body(missing), *whole, 1e-12);
      expect_same_mass(*test::body(over), *whole, 1e-12);
      expect_same_mass(*test::body(twice), *whole, 1e-12);
      EXPECT_EQ(test::body(missing)->repairs.caps, 1u);
      EXPECT_EQ(test::body(missing)->caps.triangles.size(), 1u);
      EXPECT_EQ(test::body(over)->repairs.turned_triangles, 1u);
    }
  }
}

// Coarse meshes, of which a triangle is no small opening; once more, twice more, a patch of them.
TEST(ModelChoice, triangles_repeated_by_accident_count_once) {
  for (const PolygonSoup& mesh :
       {test::icosphere(0.3, 0), test::icosphere(2, 2), test::box({1, 2, 3}),
        test::torus(5, 2, 7, 6), test::tetrahedron(0.01)}) {
    const PolygonSoup triangles = test::triangulated(mesh);
    const auto whole = test::body(triangles);
    for (const bool turned : {false, true})
      for (const std::vector<std::size_t>& which :
           {std::vector<std::size_t>{3}, {0, 1}, {2, 2}, {1, 1, 1}, {0, 1, 2}}) {
        const auto body = test::body(test::repeated(triangles, which, turned));
        expect_same_mass(*body, *whole, 1e-12);
        EXPECT_EQ(surface(*body).triangles.size(), surface(*whole).triangles.size());
        EXPECT_EQ(body->repairs.repeated, which.size());
        EXPECT_EQ(body->repairs.caps, 0u);
      }
  }
}

/// Blocks of unit cells from x = 0 to 2 and from 2 to 4, 3 cells wide and high, that share a wall;
/// no corner is where it should be, so that nothing is flat. And the number of triangles of the
/// first.
std::pair<PolygonSoup, std::size_t> blocks_with_a_wall(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PolygonSoup out;
  const auto point = [](int x, int y, int z) {
    return static_cast<std::size_t>((x * 4 + y) * 4 + z);
  };
  for (int x = 0; x <= 4; ++x)
    for (int y = 0; y <= 3; ++y)
      for (int z = 0; z <= 3; ++z)
        out.points.push_back(Vec3(x, y, z) + 0.2 * Vec3(test::uniform(random, -1, 1),
                                                        test::uniform(random, -1, 1),
                                                        test::uniform(random, -1, 1)));
  const auto side = [&out](std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                           bool turned) {
    const std::vector<Polygon> both{{a, b, c}, {a, c, d}};
    for (Polygon t : both) {
      if (turned) std::swap(t[1], t[2]);
      out.polygons.push_back(std::move(t));
    }
  };
  std::size_t first = 0;
  for (const int low : {0, 2}) {
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        for (const int x : {low, low + 2})
          side(point(x, i, k), point(x, i + 1, k), point(x, i + 1, k + 1), point(x, i, k + 1),
               x == low);
    for (int x = low; x < low + 2; ++x)
      for (int i = 0; i < 3; ++i)
        for (const int end : {0, 3}) {
          side(point(x, end, i), point(x, end, i + 1), point(x + 1, end, i + 1),
               point(x + 1, end, i), end == 0);
          side(point(x, i, end), point(x + 1, i, end), point(x + 1, i + 1, end),
               point(x, i + 1, end), end == 0);
        }
    if (low == 0) first = out.polygons.size();
  }
  return {out, first};
}

// At the rim of a wall between two bodies three skins meet: each is settled by itself.
TEST(ModelChoice, skin_repeated_beside_a_wall_leaves_the_wall_alone) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto [blocks, first] = blocks_with_a_wall(seed);
    const auto whole = test::body(blocks);
    ASSERT_TRUE(whole->solid);
    std::mt19937_64 random(seed);
    for (const bool turned : {false, true})
      for (const std::size_t count : {1, 4, 9, 30}) {
        // Of the first block's long sides, which come after its two ends.
        std::vector<std::size_t> which;
        for (std::size_t i = 36; i < first; ++i) which.push_back(i);
        std::ranges::shuffle(which, random);
        which.resize(count);
        const auto body = test::body(test::repeated(blocks, which, turned));
        expect_same_mass(*body, *whole, 1e-12);
        EXPECT_EQ(body->repairs.caps, 0u);
      }
  }
}

PolygonSoup joined_all(const std::vector<PolygonSoup>& parts) {
  PolygonSoup out;
  for (const PolygonSoup& part : parts) out = test::joined(out, part);
  return out;
}

/// Triangle by triangle, each with its back.
PolygonSoup with_backs(const PolygonSoup& mesh) {
  PolygonSoup out{mesh.points, {}};
  for (const Polygon& t : test::triangulated(mesh).polygons) {
    out.polygons.push_back(t);
    out.polygons.push_back({t[0], t[2], t[1]});
  }
  return out;
}

// Reference: the body without its copies. They meet the other along a face, an edge, at a corner.
TEST(ModelChoice, a_neighbour_that_is_there_both_ways_round_counts_once) {
  const std::vector<std::vector<PolygonSoup>> all{
      {test::box({1, 1, 1}), test::placed(test::box({1, 1, 1}), {1, 0, 0})},
      {test::box({1, 1, 1}), test::placed(test::box({1, 1, 1}), {1, 1, 0})},
      {test::box({2, 1, 1}), test::placed(test::box({2, 1, 1}), {2, 1, 1})},
      {test::box({1, 1, 1}), test::placed(test::box({1, 1, 3}), {1, 0, 1})},
      {test::box({1, 1, 1}), test::placed(test::box({1, 1, 1}), {1, 0, 0}),
       test::placed(test::box({1, 1, 1}), {2, 0, 0})}};
  for (const auto& parts : all) {
    const PolygonSoup both = test::triangulated(joined_all(parts));
    const auto whole = test::body(both);
    for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
      const PolygonSoup part = test::triangulated(parts[which]);
      const PolygonSoup turned = test::turned_over(part);
      std::vector<PolygonSoup> interleaved = parts;
      interleaved[which] = with_backs(parts[which]);
      for (const PolygonSoup& mesh :
           {test::joined(both, turned), test::joined(turned, both), joined_all(interleaved)}) {
        const auto body = test::body(mesh);
        ASSERT_TRUE(body->solid);
        expect_same_mass(*body, *whole, 1e-12);
      }
    }
  }
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto [blocks, first] = blocks_with_a_wall(seed);
    PolygonSoup second{
        blocks.points,
        {blocks.polygons.begin() + static_cast<std::ptrdiff_t>(first), blocks.polygons.end()}};
    expect_same_mass(*test::body(test::joined(blocks, test::turned_over(second))),
                     *test::body(blocks), 1e-12);
  }
}

// Reference: the block without a cavity, by its closed form.
TEST(ModelChoice, a_cavity_that_another_body_fills_is_none) {
  const std::vector<PolygonSoup> fillers{test::box({1, 1, 1}), test::icosphere(0.9, 2),
                                         test::torus(1, 0.3, 12, 8), test::tetrahedron(1)};
  for (const PolygonSoup& shape : fillers) {
    const PolygonSoup block = test::box({4, 5, 6}), filler = test::triangulated(shape),
                      cavity = test::turned_over(filler);
    for (const auto& parts : std::vector<std::vector<PolygonSoup>>{{block, cavity, filler},
                                                                   {block, filler, cavity},
                                                                   {filler, block, cavity},
                                                                   {cavity, filler, block}})
      for (const bool mirrored : {false, true}) {
        const PolygonSoup all = joined_all(parts);
        const auto body = test::body(mirrored ? test::turned_over(all) : all);
        ASSERT_TRUE(body->solid);
        EXPECT_NEAR(body->mass.measure, 120, 1e-9);
        EXPECT_NEAR(body->mass.com.norm(), 0, 1e-12);
      }
    // One is filled, the other is not; and a body beside a sheet, which has most of the area, is
    // not in it.
    const PolygonSoup more = test::placed(test::turned_over(test::icosphere(0.2, 1)), {1.6, 2, 2});
    const double hole = -test::body(test::turned_over(more))->mass.measure;
    EXPECT_NEAR(test::body(joined_all({block, cavity, more, filler}))->mass.measure, 120 + hole,
                1e-9);
    const PolygonSoup sheet{{{-9, -9, -4}, {9, -9, -4}, {0, 9, -4}}, {{0, 1, 2}}};
    for (const PolygonSoup& under : {sheet, test::placed(sheet, {0, 0, 8})}) {
      const auto body = test::body(joined_all({under, filler, cavity}));
      EXPECT_TRUE(body->solid);
      EXPECT_EQ(body->repairs.turned_parts, 0u);
      EXPECT_NEAR(body->mass.measure, 162 + mass_by_area(test::body(filler)->soup).measure, 1e-11);
    }
  }
}

// Seven boxes as a plus: the one in the middle is walled in by its neighbours all around.
TEST(ModelChoice, a_body_walled_in_by_others_stays) {
  std::vector<PolygonSoup> boxes{test::box({1, 1, 1})};
  for (int axis = 0; axis < 3; ++axis)
    for (const double way : {-1.0, 1.0})
      boxes.push_back(test::placed(test::box({1, 1, 1}), way * Vec3::Unit(axis)));
  const auto body = test::body(joined_all(boxes));
  EXPECT_NEAR(body->mass.measure, 7, 1e-12);
  EXPECT_NEAR(body->mass.com.norm(), 0, 1e-14);
}

TEST(ModelChoice, a_part_written_twice_counts_once) {
  for (const PolygonSoup& mesh : sound()) {
    const auto whole = test::body(mesh);
    expect_same_mass(*test::body(test::joined(mesh, mesh)), *whole, 1e-12);
    // Turned over, a concave polygon may be cut otherwise: then lines integrate what overlaps.
    expect_same_mass(*test::body(test::joined(mesh, test::turned_over(mesh))), *whole, 1e-5);
    // And another that is not.
    const PolygonSoup more = test::placed(mesh, {5 * whole->mass.radius, 0, 0});
    expect_same_mass(*test::body(test::joined(test::joined(mesh, mesh), more)),
                     *test::body(test::joined(mesh, more)), 1e-12);
  }
}

// A cavity stays one, however often its shell and the outer one were written: for the mass, the
// inside and the search. Reference: each written once.
TEST(ModelChoice, a_cavity_stays_one_however_often_its_shells_are_written) {
  const auto probe = test::body(test::box({0.4, 0.4, 0.4}));
  for (const PolygonSoup& outer : {test::box({4, 4, 4}), test::icosphere(3, 2)})
    for (const PolygonSoup& hollow :
         {test::box({2, 2, 2}), test::icosphere(1.1, 1), test::cut_block({2, 2, 2}, {3})}) {
      const PolygonSoup cavity = test::turned_over(hollow);
      const auto once = test::body(test::joined(outer, cavity));
      for (const auto& [outers, cavities] :
           {std::pair{2, 1}, {1, 2}, {3, 1}, {1, 3}, {2, 3}, {2, 2}}) {
        const auto body = test::body(
            test::joined(test::repeated(outer, outers), test::repeated(cavity, cavities)));
        expect_same_mass(*body, *once, 1e-12);
        const Pair pair(probe, body);
        const Separation within = separate_static(pair, Pose{Quat::Identity(), Vec3::Zero()}, {});
        EXPECT_EQ(within.status, Status::separated) << outers << " " << cavities;
        const Pose crossing{Quat::Identity(), Vec3(0, 0, 1.05)};
        EXPECT_EQ(separate_static(pair, crossing, {}).depth,
                  separate_static(Pair(probe, once), crossing, {}).depth);
      }
    }
}

// Reference: the parts apart from each other.
TEST(ModelChoice, the_centre_of_mass_is_within_the_bounds) {
  const PolygonSoup box = test::box({1, 1, 1});
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 1, 1.0000001), Vec3(2, 0.5, 1)}) {
    const auto body = test::body(test::joined(box, test::turned_over(test::box(size)), {3, 0, 0}));
    Eigen::AlignedBox3d bounds;
    for (const Vec3& x : body->soup.vertices) bounds.extend(x);
    EXPECT_TRUE(bounds.contains(body->mass.com));
    EXPECT_GT(body->mass.measure, 1);
  }
}

TEST(ModelChoice, nothing_is_done_where_that_is_asked_for) {
  const PolygonSoup missing =
      test::without(test::icosphere(1, 3), [n = 0](const Vec3&) mutable { return n++ == 5; });
  const auto as_it_is = make_body(missing, Model::automatic, "a.off", {}, Repair::none);
  EXPECT_FALSE(as_it_is->solid);
  EXPECT_EQ(as_it_is->why, "3 open edges: the inside does not count");
  EXPECT_FALSE(as_it_is->repairs.any());
  EXPECT_TRUE(test::body(missing)->solid);
}

TEST(ModelChoice, clean_meshes_need_no_mending) {
  for (const PolygonSoup& mesh : sound()) {
    const auto body = test::body(mesh);
    EXPECT_FALSE(may_need_mending(*body));
    EXPECT_FALSE(body->repairs.any());
    EXPECT_TRUE(body->loose.empty());
    const auto none = make_body(mesh, Model::automatic, "a.off", {}, Repair::none);
    EXPECT_EQ(body->mass.measure, none->mass.measure);
    EXPECT_EQ(body->mass.com, none->mass.com);
    EXPECT_EQ(body->soup.triangles, none->soup.triangles);
  }
}

TEST(ModelChoice, a_body_tells_where_it_was_mended) {
  const auto sound = test::body(test::icosphere(1, 2));
  EXPECT_EQ(sound->places.all, 0u);
  const auto turned = test::body(test::turned_over(test::icosphere(1, 2)));
  ASSERT_EQ(turned->places.all, 1u);
  EXPECT_EQ(turned->places.places[0].kind, RepairKind::inside_out);
  // A ball within a box that nothing can touch.
  const auto full =
      test::body(test::joined(test::box({4, 4, 4}), test::icosphere(0.5, 2), Vec3(1, 0, 0)));
  ASSERT_EQ(full->places.all, 1u);
  EXPECT_EQ(full->places.places[0].kind, RepairKind::hidden);
  EXPECT_LT((full->places.places[0].at - Vec3(1, 0, 0)).norm(), 1e-12);
  const auto as_in_file =
      make_body(test::without(test::icosphere(1, 3), [](const Vec3& x) { return x.z() > 0.98; }),
                Model::automatic, "open", {}, Repair::none);
  EXPECT_EQ(as_in_file->places.all, 0u);
}

}  // namespace
}  // namespace sonde
