// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/components.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "engine/body/body.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

PolygonSoup moved(PolygonSoup soup, const Vec3& by) {
  for (Vec3& x : soup.points) x += by;
  return soup;
}

PolygonSoup inside_out(PolygonSoup soup) {
  for (Polygon& polygon : soup.polygons) std::reverse(polygon.begin(), polygon.end());
  return soup;
}

PolygonSoup together(const std::vector<PolygonSoup>& soups) {
  PolygonSoup all;
  for (const PolygonSoup& soup : soups) {
    const std::size_t first = all.points.size();
    all.points.insert(all.points.end(), soup.points.begin(), soup.points.end());
    for (Polygon polygon : soup.polygons) {
      for (std::size_t& corner : polygon) corner += first;
      all.polygons.push_back(polygon);
    }
  }
  return all;
}

/// As STL has it: no two triangles share a corner.
PolygonSoup corner_by_corner(const PolygonSoup& soup) {
  PolygonSoup out;
  for (const Polygon& polygon : soup.polygons) {
    Polygon own;
    for (const std::size_t corner : polygon) {
      own.push_back(out.points.size());
      out.points.push_back(soup.points[corner]);
    }
    out.polygons.push_back(own);
  }
  return out;
}

PolygonSoup cube(double side) { return test::box(Vec3::Constant(side)); }

std::vector<double> volumes(const std::vector<PolygonSoup>& parts) {
  std::vector<double> out;
  for (const PolygonSoup& part : parts)
    out.push_back(make_body(part, Model::automatic, "part")->mass.measure);
  return out;
}

// Reference: the volumes of the cubes, by their sides.
TEST(Components, what_hangs_together_by_places_is_one_in_the_order_of_the_file) {
  const PolygonSoup three =
      together({cube(2), moved(cube(1), {5, 0, 0}), moved(cube(3), {-5, 0, 0})});
  for (const PolygonSoup& soup : {three, corner_by_corner(three)}) {
    const auto parts = components_of(soup);
    ASSERT_EQ(parts.size(), 3u);
    const auto v = volumes(parts);
    EXPECT_NEAR(v[0], 8, 1e-12);
    EXPECT_NEAR(v[1], 1, 1e-12);
    EXPECT_NEAR(v[2], 27, 1e-12);
  }
}

// Reference: the volumes of the cubes: a shell with a cavity, a grain in it with one of its own.
TEST(Components, a_cavity_stays_with_what_it_is_in_and_what_lies_in_it_is_by_itself) {
  const std::vector<PolygonSoup> nested{inside_out(cube(8)), cube(10), cube(4),
                                        inside_out(cube(2))};
  for (const bool turned : {false, true}) {
    auto soups = nested;
    if (turned)
      for (PolygonSoup& soup : soups) soup = inside_out(soup);
    const auto parts = components_of(together(soups));
    ASSERT_EQ(parts.size(), 2u);
    const auto v = volumes(parts);
    EXPECT_NEAR(v[0], 1000 - 512, 1e-9);
    EXPECT_NEAR(v[1], 64 - 8, 1e-9);
  }
}

/// A part with its cavity, one that clashes with it and covers the cavity's first corner, and the
/// volumes of both.
struct Clashing {
  std::vector<PolygonSoup> soups;
  std::vector<double> volumes;
};

std::vector<Clashing> clashing() {
  const PolygonSoup ball = test::icosphere(3, 2), hollow = test::icosphere(2, 2);
  const double ball_volume = volumes({ball})[0], hollow_volume = volumes({hollow})[0];
  return {
      {{cube(4), inside_out(cube(2)), moved(cube(2.5), {-1.5, -1.5, -1.5})}, {56, 15.625}},
      {{inside_out(cube(4)), cube(2), inside_out(moved(cube(2.5), {-1.5, -1.5, -1.5}))},
       {56, 15.625}},
      {{ball, inside_out(hollow), moved(test::icosphere(2.5, 2), hollow.points.front())},
       {ball_volume - hollow_volume, ball_volume * 2.5 * 2.5 * 2.5 / 27}},
      // Hollow both: each cavity lies in both parts.
      {{ball, inside_out(hollow), moved(ball, {0, 0, 0.5}), inside_out(moved(hollow, {0, 0, 0.5}))},
       {ball_volume - hollow_volume, ball_volume - hollow_volume}}};
}

// Reference: the volumes of cubes, and of spheres by their scale.
TEST(Components, a_cavity_stays_with_its_part_where_others_clash_with_it) {
  for (const Clashing& c : clashing()) {
    const auto found = volumes(components_of(together(c.soups)));
    ASSERT_EQ(found.size(), c.volumes.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], c.volumes[i], 1e-9);
  }
}

// Reference: the volumes of boxes.
TEST(Components, a_hole_whose_faces_lie_on_the_parts_stays_with_it) {
  for (const Vec3& hole : {Vec3(2, 2, 4), Vec3(1, 3, 4), Vec3(4, 0.5, 0.5)})
    for (const bool first : {false, true}) {
      const PolygonSoup shell = inside_out(test::box(hole)), peg = test::box(0.9 * hole);
      const auto found = volumes(
          components_of(first ? together({shell, cube(4), peg}) : together({cube(4), peg, shell})));
      ASSERT_EQ(found.size(), 2u);
      EXPECT_NEAR(found[0], 64 - hole.prod(), 1e-9);
      EXPECT_NEAR(found[1], 0.729 * hole.prod(), 1e-9);
    }
}

// Reference: the volumes of cubes and boxes: of each part, less its own cavity. Both cavities lie
// within both parts, in any order of the four shells.
TEST(Components, cavities_of_two_hollow_parts_that_clash_are_not_swapped) {
  for (const Vec3& by : {Vec3(0, 0, 0.5), Vec3(0.4, 0.3, 0), Vec3(0.2, -0.2, 0.3)}) {
    const PolygonSoup shells[] = {cube(6), moved(test::box({6, 6.5, 6}), by), inside_out(cube(2)),
                                  inside_out(moved(test::box({2, 3, 2}), by))};
    std::vector<std::size_t> order{0, 1, 2, 3};
    do {
      const auto parts = components_of(
          together({shells[order[0]], shells[order[1]], shells[order[2]], shells[order[3]]}));
      auto found = volumes(parts);
      ASSERT_EQ(found.size(), 2u);
      std::ranges::sort(found);
      EXPECT_NEAR(found[0], 216 - 8, 1e-9);
      EXPECT_NEAR(found[1], 234 - 12, 1e-9);
      for (const PolygonSoup& part : parts) EXPECT_EQ(part.remarks.size(), 1u) << "it is said";
    } while (std::ranges::next_permutation(order).found);
  }
}

// Reference: the volumes of boxes. A screw in the hole is by itself.
TEST(Components, parts_that_a_hole_of_one_shell_goes_through_are_one_and_say_so) {
  for (const int plates : {2, 3, 5})
    for (const Vec3& hole : {Vec3(1, 1, 0), Vec3(0.3, 2, 0), Vec3(3.9, 0.1, 0)}) {
      std::vector<PolygonSoup> all;
      for (int i = 0; i < plates; ++i)
        all.push_back(moved(test::box({4 + 0.25 * i, 4, 1}), {0, 0, i + 0.5}));
      const Vec3 size(hole.x(), hole.y(), plates);
      const Vec3 middle(0, 0, 0.5 * plates);
      all.push_back(inside_out(moved(test::box(size), middle)));
      all.push_back(moved(test::box(0.9 * size), middle));
      all.push_back(moved(cube(1), {20, 0, 0}));
      const auto parts = components_of(together(all));
      const auto found = volumes(parts);
      ASSERT_EQ(found.size(), 3u);
      EXPECT_NEAR(found[0], 16 * plates + 0.5 * plates * (plates - 1) - size.prod(), 1e-7);
      EXPECT_NEAR(found[1], 0.729 * size.prod(), 1e-9);
      EXPECT_NEAR(found[2], 1, 1e-12);
      ASSERT_EQ(parts[0].remarks.size(), 1u);
      EXPECT_NE(parts[0].remarks[0].find("goes through " + std::to_string(plates) + " parts"),
                std::string::npos);
      EXPECT_TRUE(parts[1].remarks.empty());
    }
}

TEST(Components, what_lies_in_material_turned_the_same_way_is_no_cavity) {
  EXPECT_EQ(components_of(together({cube(4), cube(1)})).size(), 2u);
}

// Reference: the volumes of the cubes. Which copy a polygon is of is told by its place in the file.
TEST(Components, what_is_there_several_times_is_as_many) {
  const PolygonSoup hollow = together({inside_out(cube(8)), cube(10)});
  const PolygonSoup sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  PolygonSoup begun_elsewhere = cube(2);
  for (Polygon& polygon : begun_elsewhere.polygons)
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  std::reverse(begun_elsewhere.polygons.begin(), begun_elsewhere.polygons.end());
  for (const bool apart : {false, true}) {
    const auto as_drawn = [&](const PolygonSoup& soup) {
      return apart ? corner_by_corner(soup) : soup;
    };
    const auto two = volumes(components_of(as_drawn(together({cube(2), begun_elsewhere}))));
    ASSERT_EQ(two.size(), 2u);
    for (const double v : two) EXPECT_NEAR(v, 8, 1e-12);
    const auto three = volumes(
        components_of(as_drawn(together({hollow, moved(cube(1), {20, 0, 0}), hollow, hollow}))));
    ASSERT_EQ(three.size(), 4u);
    for (const std::size_t i : {0u, 2u, 3u}) EXPECT_NEAR(three[i], 1000 - 512, 1e-9);
    EXPECT_NEAR(three[1], 1, 1e-12);
    EXPECT_EQ(components_of(as_drawn(together({sheet, sheet}))).size(), 2u);
    // Both sides of one surface, or some of its polygons again, are no second part.
    EXPECT_EQ(components_of(as_drawn(together({sheet, inside_out(sheet)}))).size(), 1u);
    PolygonSoup some = cube(2);
    some.polygons.push_back(some.polygons.front());
    EXPECT_EQ(components_of(as_drawn(some)).size(), 1u);
  }
}

TEST(Components, loose_triangles_are_each_one_and_remarks_go_with_the_first) {
  std::mt19937_64 random(4);
  PolygonSoup soup = test::random_soup(random, 20, 1);
  soup.remarks = {"odd"};
  const auto parts = components_of(soup);
  ASSERT_EQ(parts.size(), 20u);
  EXPECT_EQ(parts[0].remarks, soup.remarks);
  EXPECT_TRUE(parts[1].remarks.empty());
  EXPECT_TRUE(components_of({}).empty());
}

}  // namespace
}  // namespace sonde
