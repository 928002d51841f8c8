// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>

#include "engine/geometry/mass_integrals.hpp"
#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::string refusal(const PolygonSoup& soup, Model asked) {
  try {
    make_body(soup, asked, "a.off");
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

PolygonSoup open_box() {
  PolygonSoup box = test::box({1, 1, 1});
  box.polygons.pop_back();
  return box;
}

PolygonSoup two_sided_square() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0.1, 0.3}, {1, 1.1, 0.6}, {0, 1, 0.3}};
  soup.polygons = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  return soup;
}

TEST(Body, closed_is_solid) {
  for (const Model asked : {Model::automatic, Model::solid}) {
    const auto body = make_body(test::box({1, 2, 3}), asked, "box");
    EXPECT_TRUE(body->solid);
    EXPECT_FALSE(body->turned);
    EXPECT_EQ(body->why, "closed: the inside counts");
    EXPECT_TRUE(body->mass.by_volume);
    EXPECT_NEAR(body->mass.measure, 6, 1e-14);
    EXPECT_EQ(body->name, "box");
  }
}

TEST(Body, surface_where_asked_for) {
  const auto body = make_body(test::box({1, 1, 1}), Model::surface, "box");
  EXPECT_FALSE(body->solid);
  EXPECT_EQ(body->why, "asked for: surface");
  EXPECT_FALSE(body->mass.by_volume);
  EXPECT_NEAR(body->mass.measure, 6, 1e-14);
}

TEST(Body, open_is_surface) {
  const auto body = make_body(open_box(), Model::automatic, "box");
  EXPECT_FALSE(body->solid);
  EXPECT_THAT(body->why, testing::MatchesRegex("4 open edges, open mouth 16 % .model solid closes "
                                               "it.: the inside does not count"));
  // Asked for, its inside counts. Reference: the box that it was.
  const auto closed = make_body(open_box(), Model::solid, "box");
  EXPECT_TRUE(closed->solid);
  EXPECT_NEAR(closed->mass.measure, 1, 1e-14);
  const auto as_it_is = make_body(open_box(), Model::automatic, "box", {}, Repair::none);
  EXPECT_EQ(as_it_is->why, "4 open edges: the inside does not count");
  try {
    make_body(open_box(), Model::solid, "a.off", {}, Repair::none);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.off: cannot be a solid: 4 open edges");
  }
}

TEST(Body, disagreeing_orientation_is_mended) {
  PolygonSoup box = test::box({1, 1, 1});
  std::reverse(box.polygons[0].begin(), box.polygons[0].end());
  EXPECT_EQ(make_body(box, Model::automatic, "box", {}, Repair::none)->why,
            "4 edges do not agree in orientation: the inside does not count");
  const auto mended = make_body(box, Model::automatic, "box");
  EXPECT_TRUE(mended->solid);
  EXPECT_EQ(mended->repairs.turned_triangles, 2u);
  EXPECT_NEAR(mended->mass.measure, 1, 1e-14);
}

TEST(Body, flat_closed_is_surface) {
  const auto body = make_body(two_sided_square(), Model::automatic, "flat");
  EXPECT_FALSE(body->solid);
  EXPECT_EQ(body->why, "closed but flat (no volume): the inside does not count");
  EXPECT_GT(body->mass.measure, 2);
  EXPECT_EQ(refusal(two_sided_square(), Model::solid),
            "a.off: cannot be a solid: closed but flat (no volume)");
}

TEST(Body, a_thin_plate_is_still_solid) {
  EXPECT_TRUE(make_body(test::box({1, 1, 1e-9}), Model::solid, "plate")->solid);
  EXPECT_TRUE(make_body(test::box({1e-20, 1e-20, 1e-29}), Model::solid, "tiny plate")->solid);
}

TEST(Body, inside_out_is_turned) {
  const auto body = make_body(test::turned_over(test::box({1, 2, 3})), Model::automatic, "box");
  EXPECT_TRUE(body->solid);
  EXPECT_TRUE(body->turned);
  EXPECT_GT(body->mass.measure, 0);
  EXPECT_NEAR(mass_by_volume(body->soup).measure, 6, 1e-14);
}

// Reference: V of a 3-cube with a 1-cube hollow is 26.
TEST(Body, a_cavity_counts_as_empty) {
  const PolygonSoup hollow =
      test::joined(test::box({3, 3, 3}), test::turned_over(test::box({1, 1, 1})), Vec3::Zero());
  const auto body = make_body(hollow, Model::automatic, "hollow");
  EXPECT_TRUE(body->solid);
  EXPECT_FALSE(body->turned);
  EXPECT_NEAR(body->mass.measure, 26, 1e-13);
  EXPECT_EQ(body->component_triangle.size(), 2u);
}

TEST(Body, degenerate_triangles_are_set_aside_without_opening_the_mesh) {
  PolygonSoup box = test::box({2, 2, 2});
  box.points.push_back({0, -1, -1});
  // Splits the edge from 0 to 1 in the bottom face, and closes the gap with a sliver.
  box.polygons[0] = {0, 2, 3, 1, 8};
  box.polygons.push_back({0, 8, 1});
  const auto body = make_body(box, Model::automatic, "box");
  EXPECT_TRUE(body->solid);
  EXPECT_EQ(body->degenerate, 1u);
  EXPECT_EQ(body->soup.triangles.size(), 13u);
  EXPECT_EQ(body->component_triangle.size(), 1u);
}

TEST(Body, parts_joined_by_a_sliver_alone_are_two) {
  PolygonSoup two = test::joined(test::box({1, 1, 1}), test::box({1, 1, 1}), {3, 0, 0});
  two.points.push_back({1, -0.5, -0.5});
  two.polygons.push_back({1, 16, 8});  // in one line with the edges of both
  const auto body = make_body(two, Model::automatic, "two");
  EXPECT_EQ(body->degenerate, 1u);
  EXPECT_EQ(body->component_triangle.size(), 2u);
  EXPECT_EQ(body->soup.vertices.size(), 16u);
}

// Reference: the boxes are apart in z, and come in this order in the file.
TEST(Body, component_triangles_are_the_first_of_each_in_the_order_of_the_tree) {
  const auto body =
      make_body(test::joined(test::sphere(1, 8, 9), test::box({1, 1, 1}), {0.5, 0, 5}),
                Model::automatic, "two");
  const auto is_above = [&](const Triangle& t) { return body->soup.vertices[t[0]].z() > 2; };
  const auto& triangles = body->soup.triangles;
  const auto below = std::ranges::find_if_not(triangles, is_above) - triangles.begin();
  const auto above = std::ranges::find_if(triangles, is_above) - triangles.begin();
  EXPECT_THAT(body->component_triangle, testing::ElementsAre(below, above));
}

TEST(Body, unused_points_do_not_count) {
  PolygonSoup box = test::box({1, 1, 1});
  box.points.push_back({100, 100, 100});
  const auto body = make_body(box, Model::automatic, "box");
  EXPECT_EQ(body->soup.vertices.size(), 8u);
  EXPECT_LT(body->mass.radius, 1);
  EXPECT_LT(body->tree.high.x(), 1);
}

TEST(Body, nothing_with_an_area_is_refused) {
  PolygonSoup line;
  line.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.polygons = {{0, 1, 2}};
  EXPECT_EQ(refusal(line, Model::automatic), "a.off: no triangle has an area");
  EXPECT_EQ(refusal(PolygonSoup(), Model::automatic), "a.off: no triangle has an area");
}

TEST(Body, sizes_beyond_the_engine_are_refused) {
  EXPECT_EQ(refusal(test::box({1e31, 1, 1}), Model::automatic),
            "a.off: a coordinate is beyond 1e30 m");
  EXPECT_EQ(refusal(test::box({1e-31, 1e-31, 1e-31}), Model::automatic),
            "a.off: the mesh is smaller than 1e-30 m");
}

TEST(Body, reports_progress_from_zero_to_one) {
  for (const PolygonSoup& mesh : {test::box({1, 1, 1}), test::torus(1, 0.3, 110, 100)}) {
    std::vector<double> seen;
    make_body(mesh, Model::automatic, "mesh", [&](double f) {
      seen.push_back(f);
      return true;
    });
    EXPECT_TRUE(std::ranges::is_sorted(seen));
    EXPECT_EQ(seen.front(), 0);
    EXPECT_EQ(seen.back(), 1);
  }
}

/// Builds with a progress that says stop at this call, counted from 0: did that cancel it?
bool is_cancelled_at(std::size_t call, const PolygonSoup& mesh) {
  std::size_t calls = 0;
  try {
    make_body(mesh, Model::automatic, "mesh", [&](double) { return calls++ != call; });
  } catch (const Cancelled&) {
    EXPECT_EQ(calls, call + 1) << "asked again after it had cancelled";
    return true;
  }
  EXPECT_LE(calls, call) << "was told to stop and went on";
  return false;
}

// The larger one is built by two threads, and the number of its calls is not always the same.
TEST(Body, can_be_cancelled_at_any_point) {
  for (const PolygonSoup& mesh : {test::box({1, 1, 1}), test::torus(1, 0.3, 110, 100)}) {
    std::size_t calls = 0;
    while (is_cancelled_at(calls, mesh)) ++calls;
    EXPECT_GE(calls, 10u);
  }
}

TEST(Body, cancelling_leaves_nothing_allocated) {
  const PolygonSoup box = test::box({1, 1, 1});
  const std::string name = "a name too long for a string to keep in itself";
  for (std::size_t stop = 0, cancelled = 1; cancelled > 0; ++stop) {
    cancelled = 0;
    std::size_t calls = 0;
    const Progress progress = [&](double) { return calls++ < stop; };
    test::AllocationCounter counter;
    try {
      make_body(box, Model::automatic, name, progress);
    } catch (const Cancelled&) {
      ++cancelled;
    }
    counter.stop();
    EXPECT_GT(counter.allocations(), 0u);
    EXPECT_EQ(counter.allocations(), counter.frees()) << "cancelled at call " << stop;
  }
}

/// How often the steps before the tree report, for a torus of this many triangles.
std::size_t reports_before_the_tree(int triangles) {
  std::size_t n = 0;
  make_body(test::torus(1, 0.3, triangles / 200, 100), Model::automatic, "torus", [&](double f) {
    n += f < 0.425;
    return true;
  });
  return n;
}

// So that whoever cancels need not wait: every loop over triangles or vertices reports before each
// 65,536 of them. Seven go over the triangles (6 reports where there was 1), three over the
// vertices (3 where there was 1).
TEST(Body, reports_progress_within_each_step) {
  EXPECT_GE(reports_before_the_tree(330'000), reports_before_the_tree(30'000) + 7 * 5 + 3 * 2);
}

// Reference: the mass properties by themselves, which take one thread.
TEST(Body, mass_has_the_same_bits_where_two_threads_build) {
  const PolygonSoup mesh = test::torus(1, 0.3, 200, 100);
  const auto body = make_body(mesh, Model::automatic, "torus");
  const MassProperties alone = mass_by_volume(compacted(triangulate_all(mesh)));
  EXPECT_EQ(body->mass.measure, alone.measure);
  EXPECT_EQ(body->mass.com, alone.com);
  EXPECT_EQ(body->mass.R_MP, alone.R_MP);
  EXPECT_EQ(body->mass.inertia, alone.inertia);
  EXPECT_EQ(body->mass.radius, alone.radius);
}

// A sanitizer's allocator keeps no such figures.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(SONDE_SANITIZED)
std::size_t allocated_now() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// Reference: what the allocator of the C library says that it has handed out.
TEST(Body, bytes_are_what_is_allocated) {
  std::mt19937_64 random(1);
  for (const PolygonSoup& mesh :
       {test::torus(1, 0.3, 500, 200), test::random_soup(random, 20000, 1)}) {
    const std::size_t before = allocated_now();
    const auto body = make_body(mesh, Model::automatic, "mesh");
    const auto allocated = static_cast<double>(allocated_now() - before);
    EXPECT_NEAR(static_cast<double>(bytes(*body)), allocated, 0.01 * allocated);
  }
}
#endif

// 120 bytes a triangle is what is asked for; without the tree a closed mesh takes 24.
TEST(Body, a_closed_mesh_takes_little_memory) {
  const auto body = make_body(test::torus(1, 0.3, 500, 200), Model::automatic, "torus");
  const std::size_t triangles = body->soup.triangles.size();
  ASSERT_EQ(triangles, 200'000u);
  EXPECT_LE(bytes(*body), 120 * triangles);
  EXPECT_LE(sizeof(Vec3) * body->soup.vertices.capacity() +
                sizeof(Triangle) * body->soup.triangles.capacity() +
                sizeof(std::uint32_t) * body->component_triangle.capacity(),
            24 * triangles + 64);
}

TEST(Body, loads_and_scales) {
  const test::TempFolder folder;
  const auto file = folder.write("box.off", test::as_off(test::box({1, 2, 3})));
  std::vector<double> seen;
  const auto body = load_body(file.string(), Model::automatic, 0.001, [&](double f) {
    seen.push_back(f);
    return true;
  });
  EXPECT_NEAR(body->mass.measure, 6e-9, 1e-22);
  EXPECT_EQ(body->name, file.string());
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_EQ(seen.back(), 1);
}

}  // namespace
}  // namespace sonde
