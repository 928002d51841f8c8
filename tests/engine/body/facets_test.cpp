// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "tests/engine/body/facets_checks.hpp"

namespace sonde::test {
namespace {

// Closed form: a block has six faces of two triangles.
TEST(Facets, a_block_is_twelve_triangles_however_it_is_cut) {
  const Vec3 size(0.1, 0.2, 0.3);
  for (const Cutting::Kind kind : kinds)
    for (const int n : {2, 5, 8, 20})
      for (const bool askew : {false, true}) {
        const PolygonSoup block = test::cut_block(size, {n, kind});
        const Soup soup = sewn(askew ? test::turned(block, some_turn()) : block);
        ASSERT_EQ(soup.triangles.size(), 12u * static_cast<std::size_t>(n * n));
        const Facets facets = merged(soup);
        const std::string what = std::string(name(kind)) + std::to_string(n) + (askew ? "a" : "");
        EXPECT_EQ(facets.soup.triangles.size(), 12u) << what;
        EXPECT_EQ(facets.merged, soup.triangles.size()) << what;
        EXPECT_EQ(facets.duplicates, 0u) << what;
        EXPECT_NEAR(area(facets.soup), 2 * (0.02 + 0.06 + 0.03), 1e-13) << what;
        EXPECT_NEAR(volume(facets.soup), 0.006, 1e-15) << what;
        check_same_surface(soup, facets, what);
      }
}

TEST(Facets, what_cannot_be_fewer_stays_as_it_is) {
  const Soup soup = sewn(test::cut_block({1, 2, 3}, {}));
  const Facets facets = merged(soup);
  EXPECT_EQ(facets.merged, 0u);
  EXPECT_EQ(triangle_set(facets.soup), triangle_set(soup));
}

// A tetrahedron smaller than rounding: each of its triangles lies in the plane of any other, and
// together they have no outline.
TEST(Facets, a_closed_speck_stays_as_it_is) {
  Soup soup = sewn(test::cut_block({1, 2, 3}, {}));
  const auto a = static_cast<std::uint32_t>(soup.vertices.size());
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    soup.vertices.emplace_back(1e-14 * x);
  for (const Triangle& t : {Triangle{a, a + 2, a + 1}, Triangle{a, a + 1, a + 3},
                            Triangle{a, a + 3, a + 2}, Triangle{a + 1, a + 2, a + 3}})
    soup.triangles.push_back(t);
  EXPECT_EQ(triangle_set(merged(soup).soup), triangle_set(soup));
}

// Closed forms: a flat face of n corners with h holes takes n + 2h - 2 triangles; a wall of a
// prism, two.
TEST(Facets, holes_and_concave_faces_keep_their_shape) {
  constexpr int sides = 16;
  for (const Cutting::Kind kind : kinds)
    for (const bool askew : {false, true}) {
      const auto check = [&](const PolygonSoup& polygons, std::size_t expected,
                             const std::string& shape) {
        const Soup soup = sewn(askew ? test::turned(polygons, some_turn()) : polygons);
        const Facets facets = merged(soup);
        const std::string what = shape + ", " + name(kind) + (askew ? ", askew" : "");
        EXPECT_EQ(facets.soup.triangles.size(), expected) << what;
        check_same_surface(soup, facets, what);
        EXPECT_TRUE(analyse_topology(facets.soup).closed) << what;
      };
      const Cutting cutting{9, kind};
      check(test::cut_bored_block(0.05, 0.03, 0.02, sides, cutting),
            2 * (4 + sides) + 4 * 2 + 2 * sides, "bored block");
      check(test::cut_rod(0.01, 0.05, sides, cutting), 2 * sides + 2 * (sides - 2), "rod");
      check(test::cut_notched_block(cutting), 8 * 2 + 2 * (8 - 2), "notched block");
      check(test::cut_wedge(cutting), 12, "wedge");
    }
}

TEST(Facets, a_peg_and_its_socket_are_the_same_however_they_are_cut) {
  for (const Cutting::Kind kind : kinds)
    for (const auto& [shape, whole] :
         {std::pair{test::cut_peg({6, kind}), test::cut_peg({1, kind})},
          std::pair{test::cut_socket(1e-4, {6, kind}), test::cut_socket(1e-4, {1, kind})}}) {
      const Soup soup = sewn(shape);
      const Facets facets = merged(soup);
      EXPECT_EQ(facets.soup.triangles.size(), merged(sewn(whole)).soup.triangles.size());
      check_same_surface(soup, facets, name(kind));
    }
}

// By hand: a square whose sides are cut, or one of them very often (minutes, were each vertex of a
// side looked at from each).
TEST(Facets, straight_sides_come_down_to_their_ends) {
  for (const std::uint32_t n : {2u, 3u, 4u, 5u, 7u, 8u, 9u, 100u, 100'000u}) {
    Soup strip;
    for (std::uint32_t i = 0; i <= n; ++i)
      for (const double y : {0.0, 1.0}) strip.vertices.emplace_back(double(i) / n, y, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      strip.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
      strip.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    const Facets facets = merged(strip, false);
    EXPECT_EQ(facets.soup.triangles.size(), 2u) << n;
    EXPECT_NEAR(area(facets.soup), 1, 1e-12) << n;
  }
}

// What a file of single precision makes of oblique faces is no longer flat: nothing is made of it,
// but where some neighbours happen to be.
TEST(Facets, oblique_faces_of_single_precision_are_left_alone) {
  for (const Cutting::Kind kind : {Cutting::Kind::regular, Cutting::Kind::random}) {
    PolygonSoup block = test::turned(test::cut_block({0.1, 0.2, 0.3}, {8, kind}), some_turn());
    for (Vec3& x : block.points) x = x.cast<float>().cast<double>();
    const Soup soup = sewn(block);
    const Facets facets = merged(soup);
    EXPECT_LE(facets.merged, soup.triangles.size() / 20);
    check_same_surface(soup, facets, name(kind));
  }
}

TEST(Facets, curved_meshes_stay_as_they_are) {
  for (const PolygonSoup& polygons :
       {test::sphere(0.3, 40, 60), test::torus(0.1, 0.03, 60, 40),
        test::torus_knot(2, 3, 0.06, 0.025, 0.012, 200, 12), test::sphere(1e-6, 200, 300)}) {
    const Soup soup = sewn(polygons);
    const Facets facets = merged(soup);
    EXPECT_EQ(facets.merged, 0u);
    EXPECT_EQ(triangle_set(facets.soup), triangle_set(soup));
    EXPECT_TRUE(test::body(polygons)->facets.triangles.empty());
  }
}

// Rounding of far coordinates may cost the joining, never the shape.
TEST(Facets, far_from_the_origin) {
  const PolygonSoup block = test::cut_block({0.1, 0.2, 0.3}, {6, Cutting::Kind::random});
  for (const double far : {1.0, 1e3, 1e6, 1e9})
    for (const bool askew : {false, true}) {
      const PolygonSoup there =
          moved(askew ? test::turned(block, some_turn()) : block, {far, -0.7 * far, 0.3 * far});
      const Soup soup = sewn(there);
      const Facets facets = merged(soup);
      const std::string what = std::to_string(far) + (askew ? " askew" : "");
      if (far <= 1e3) {
        EXPECT_EQ(facets.soup.triangles.size(), 12u) << what;
      }
      EXPECT_LE(rounding_flatness(soup), 1e-11 * size_of(soup)) << what;
      std::mt19937_64 random(6);
      const double rounding = 2e-11 * size_of(soup) + 1e-15 * far;
      EXPECT_LE(strays(soup, facets.soup, random), rounding) << what;
      EXPECT_LE(strays(facets.soup, soup, random), rounding) << what;
    }
}

TEST(Facets, nothing_depends_on_the_unit) {
  for (const double scale : {1e-9, 1e-3, 1e6}) {
    PolygonSoup block =
        test::turned(test::cut_block({0.1, 0.2, 0.3}, {6, Cutting::Kind::random}), some_turn());
    for (Vec3& x : block.points) x *= scale;
    EXPECT_EQ(merged(sewn(block)).soup.triangles.size(), 12u) << scale;
  }
}

// Reference: the winding numbers of one copy.
TEST(Facets, many_copies_of_a_solid_are_one) {
  const PolygonSoup block = test::cut_block({1, 1, 1}, {4});
  for (const int times : {2, 3, 300}) {
    const auto body = make_body(test::repeated(block, times), Model::automatic, "copies");
    EXPECT_TRUE(body->solid);
    EXPECT_EQ(body->duplicates, 0u);
    EXPECT_EQ(body->repairs.repeated, 192u * static_cast<std::size_t>(times - 1));
    EXPECT_EQ(surface(*body).triangles.size(), 12u);
    EXPECT_EQ(winding_number(*body, {0.1, 0.2, 0.3}), 1);
    EXPECT_EQ(winding_number(*body, {1, 2, 3}), 0);
    EXPECT_NEAR(body->mass.com.norm(), 0, 1e-12);
    EXPECT_NEAR(body->mass.inertia.x(), 1.0 / 6, 1e-12);
  }
  const auto as_it_is =
      make_body(test::repeated(block, 3), Model::automatic, "copies", {}, Repair::none);
  EXPECT_EQ(as_it_is->duplicates, 384u);
  EXPECT_EQ(surface(*as_it_is).triangles.size(), 12u);
  EXPECT_EQ(winding_number(*as_it_is, {0.1, 0.2, 0.3}), 1);
}

// By hand: two, three or four copies of a part, and what is left in proportion; once where it is
// mended.
TEST(Facets, copies_of_a_solids_parts_stay_in_proportion) {
  const PolygonSoup block = test::box({1, 1, 1}), other = moved(block, {3, 0, 0});
  const auto windings = [&](int times, int times_other, Repair repair = Repair::none) {
    const auto body =
        make_body(joined(test::repeated(block, times), test::repeated(other, times_other)),
                  Model::automatic, "parts", {}, repair);
    EXPECT_TRUE(body->solid);
    return std::pair(winding_number(*body, {0.1, 0.2, 0.3}),
                     winding_number(*body, {3.1, 0.2, 0.3}));
  };
  EXPECT_EQ(windings(2, 4), std::pair(1, 2));
  EXPECT_EQ(windings(2, 3), std::pair(2, 3));
  EXPECT_EQ(windings(1, 3), std::pair(1, 3));
  EXPECT_EQ(windings(2, 4, Repair::automatic), std::pair(1, 1));
  EXPECT_EQ(windings(2, 3, Repair::automatic), std::pair(1, 1));
}

TEST(Facets, a_surface_keeps_one_of_each_orientation) {
  const PolygonSoup block = test::box({1, 1, 1});
  const Soup same = sewn(test::repeated(block, 5));
  EXPECT_EQ(merged(same, false).soup.triangles.size(), 12u);
  EXPECT_EQ(merged(same, false).duplicates, 48u);
  const Soup both =
      sewn(joined(test::repeated(block, 5), test::repeated(test::turned_over(block), 3)));
  const Facets facets = merged(both, false);
  EXPECT_EQ(facets.duplicates, 72u);
  const auto left = triangle_set(facets.soup);
  EXPECT_EQ(left.size(), 24u);
  EXPECT_EQ(std::set<Triangle>(left.begin(), left.end()).size(), 24u);
  // The mass of a surface is that of what is there once.
  const auto body =
      make_body(test::repeated(test::cut_block({1, 1, 1}, {3}), 4), Model::surface, "copies");
  EXPECT_NEAR(body->mass.measure, 6, 1e-12);
}

// By hand: a wall in a solid that has two sides is no boundary of it, and still there to be
// touched; once, or as it is in the file.
TEST(Facets, a_wall_of_two_sides_within_a_solid_stays) {
  PolygonSoup wall;
  wall.points = {{0, -0.3, -0.3}, {0, 0.3, -0.3}, {0, 0.3, 0.3}, {0, -0.3, 0.3}};
  wall.polygons = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  for (const Repair repair : {Repair::automatic, Repair::none}) {
    const bool mended = repair == Repair::automatic;
    const auto body = make_body(joined(test::cut_block({1, 1, 1}, {3}), test::repeated(wall, 3)),
                                Model::automatic, "walled", {}, repair);
    ASSERT_TRUE(body->solid);
    EXPECT_EQ(body->repairs.repeated, mended ? 10u : 0u);
    EXPECT_EQ(body->duplicates, mended ? 0u : 8u);
    EXPECT_EQ(surface(*body).triangles.size(), mended ? 12u + 2u : 12u + 4u);
    EXPECT_EQ(winding_number(*body, {0.1, 0.05, 0.02}), 1);
    EXPECT_EQ(winding_number(*body, {-0.1, 0.05, 0.02}), 1);
  }
}

// Reference: where the triangles are; the parts lie apart.
TEST(Facets, each_component_has_its_first_triangle) {
  PolygonSoup all;
  for (int i = 0; i < 7; ++i) {
    const Cutting cutting{1 + i, kinds[i % 3]};
    const PolygonSoup part = i % 2 ? test::cut_rod(0.2, 0.8, 12, cutting)
                                   : test::cut_block(Vec3::Constant(0.5), cutting);
    all = joined(all, moved(part, {2.0 * i, 0, 0}));
  }
  const auto body = test::body(all);
  const Soup& soup = surface(*body);
  const auto part_of = [&](std::size_t triangle) {
    return std::lround(soup.vertices[soup.triangles[triangle][0]].x() / 2);
  };
  ASSERT_EQ(body->component_triangle.size(), 7u);
  std::set<long> parts;
  for (const std::uint32_t first : body->component_triangle) {
    ASSERT_LT(first, soup.triangles.size());
    parts.insert(part_of(first));
    for (std::size_t i = 0; i < first; ++i) EXPECT_NE(part_of(i), part_of(first));
  }
  EXPECT_EQ(parts.size(), 7u);
}

TEST(Facets, the_order_of_triangles_does_not_matter) {
  std::mt19937_64 random(8);
  for (const Cutting::Kind kind : kinds) {
    const Soup soup =
        sewn(test::turned(test::cut_bored_block(0.05, 0.03, 0.02, 16, {9, kind}), some_turn()));
    const Facets first = merged(soup);
    for (int i = 0; i < 5; ++i) {
      Soup shuffled = soup;
      std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
      for (Triangle& t : shuffled.triangles)
        std::rotate(t.begin(), t.begin() + static_cast<long>(random() % 3), t.end());
      const Facets other = merged(shuffled);
      EXPECT_EQ(other.soup.triangles.size(), first.soup.triangles.size());
      EXPECT_EQ(other.merged, first.merged);
      const auto used = [](const Facets& facets) {
        std::set<std::uint32_t> out;
        for (const Triangle& t : facets.soup.triangles) out.insert(t.begin(), t.end());
        return out;
      };
      EXPECT_EQ(used(other), used(first));
      check_same_surface(shuffled, other, name(kind));
    }
  }
}

TEST(Facets, same_bits_twice) {
  for (const Cutting::Kind kind : kinds) {
    const Soup soup = sewn(test::turned(test::cut_peg({6, kind}), some_turn()));
    const Facets a = merged(soup), b = merged(soup);
    EXPECT_EQ(a.soup.triangles, b.soup.triangles);
    EXPECT_EQ(a.soup.vertices, b.soup.vertices);
    EXPECT_EQ(a.from, b.from);
  }
}

TEST(Facets, can_be_cancelled_at_any_time) {
  const Soup soup = sewn(test::cut_block({1, 1, 1}, {8}));
  const auto merge = [&](const Progress& progress) {
    return merge_flat(soup, rounding_flatness(soup), true, progress);
  };
  double last = 0;
  int calls = 0;
  merge([&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    ++calls;
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_GE(calls, 5);
  for (int stop = 1; stop <= calls; ++stop) {
    int left = stop;
    EXPECT_THROW(merge([&](double) { return --left > 0; }), Cancelled) << stop;
  }
}

TEST(Facets, of_nothing_is_nothing) {
  EXPECT_EQ(rounding_flatness({}), 0);
  const Facets none = merge_flat({}, 0, false);
  EXPECT_TRUE(none.soup.triangles.empty());
  EXPECT_EQ(none.merged + none.duplicates, 0u);
}

// Reference: as for the small meshes, on some 100 000 triangles.
TEST(Facets, Full_large_faces_come_down_to_a_few_triangles) {
  for (const Cutting::Kind kind : kinds) {
    const Soup block =
        sewn(test::turned(test::cut_block({0.1, 0.2, 0.3}, {90, kind}), some_turn()));
    const Facets facets = merged(block);
    EXPECT_EQ(facets.soup.triangles.size(), 12u) << name(kind);
    check_same_surface(block, facets, name(kind));
    const Soup bored = sewn(test::cut_bored_block(0.05, 0.03, 0.02, 64, {40, kind}));
    const Facets of_bored = merged(bored);
    EXPECT_EQ(of_bored.soup.triangles.size(), 2u * (4 + 64) + 8 + 2 * 64) << name(kind);
    check_same_surface(bored, of_bored, name(kind));
  }
}

}  // namespace
}  // namespace sonde::test
