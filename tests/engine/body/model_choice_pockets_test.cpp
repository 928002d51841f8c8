// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "engine/body/model_choice.hpp"
#include "engine/queries/body_queries.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A body with a hole that is a shell of its own, some of whose faces lie on the body's.
struct Holed {
  PolygonSoup body, hole;  // both outward
  double volume;           // m³, of what is left
  Vec3 in_hole;
};

std::vector<Holed> holed() {
  using Profile = std::vector<Eigen::Vector2d>;
  const Profile blind{{0, 0.2}, {0.3, 0.2}, {0.6, 1}, {0, 1}},
      through{{0, -1}, {0.5, -1}, {0.5, 1}, {0, 1}}, disc{{0, -1}, {3, -1}, {3, 1}, {0, 1}};
  const PolygonSoup block = test::box({2, 3, 2});
  const Profile slot{{-0.4, -0.3}, {0.4, -0.3}, {0, 0.5}};
  return {
      {block, test::placed(test::box({1, 1, 0.5}), {0.1, 0.2, 0.75}), 12 - 0.5, {0.1, 0.2, 0.8}},
      {block, test::lathed(blind, 24), 12 - test::lathed_volume(blind, 24), {0, 0, 0.7}},
      {block, test::lathed(through, 17), 12 - test::lathed_volume(through, 17), {0, 0, 0.1}},
      {test::lathed(disc, 40),
       test::placed(test::prism(slot, 2), {1.5, 0.4, -1}),
       test::lathed_volume(disc, 40) - 2 * 0.32,
       {1.5, 0.4, 0.1}},
      {test::box({2, 2, 2}),
       test::placed(test::box({1, 1, 1}), {0.5, 0.5, 0.5}),
       7,
       {0.4, 0.6, 0.5}}};  // a corner
}

// Reference: volumes of boxes, prisms and frusta.
TEST(ModelChoiceOfPockets, a_hole_whose_faces_lie_on_the_bodys_stays_one) {
  for (const Holed& h : holed())
    for (const double sunk : {0.0, 1e-9})
      for (const bool over : {false, true}) {
        PolygonSoup mesh =
            test::joined(h.body, test::turned_over(test::placed(h.hole, {0, 0, -sunk})));
        if (over) mesh = test::turned_over(mesh);
        const auto body = test::body(mesh);
        EXPECT_TRUE(body->solid);
        EXPECT_NEAR(body->mass.measure, h.volume, 1e-8 * h.volume);
        EXPECT_EQ(body->repairs.turned_parts, over ? 2u : 0u);
        EXPECT_FALSE(inside(*body, h.in_hole));
        // The same shell beside the body is a body that is inside out.
        const auto beside =
            test::body(test::joined(h.body, test::turned_over(test::placed(h.hole, {20, 0, 0}))));
        EXPECT_EQ(beside->repairs.turned_parts, 1u);
        EXPECT_TRUE(inside(*beside, h.in_hole + Vec3(20, 0, 0)));
      }
}

/// The triangles across mouths, by the remark on them; 0 where there is none.
int lids(const PolygonSoup& mesh) {
  const auto body = test::body(mesh);
  for (const std::string& remark : body->remarks)
    if (remark.find("across the mouths") != remark.npos) return std::stoi(remark);
  return 0;
}

// Reference: by hand, the triangles of the hole's faces that lie on the body's. They stay walls,
// since no triangle is left out or cut, and so it is said.
TEST(ModelChoiceOfPockets, what_lies_across_the_mouth_is_said_to_stay_a_wall) {
  std::vector<Holed> all = holed();
  all.back() = {
      all[0].body, test::placed(test::box({1, 1, 0.5}), {0.5, 0.2, 0.75}), 0, {}};  // an edge
  const int expected[] = {2, 24, 2 * 17, 2, 4};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PolygonSoup hole = test::turned_over(test::triangulated(all[i].hole));
    const PolygonSoup mesh = test::joined(all[i].body, hole);
    EXPECT_EQ(lids(mesh), expected[i]) << i;
    EXPECT_EQ(lids(test::turned_over(mesh)), expected[i]) << i;
    EXPECT_EQ(lids(test::joined(all[i].body, test::placed(hole, {20, 0, 0}))), 0) << i;
  }
  const PolygonSoup block = test::box({4, 4, 4});
  for (const PolygonSoup& cavity :
       {test::box({1, 2, 3}), test::icosphere(1.5, 2), test::torus(1, 0.4, 20, 8)}) {
    EXPECT_EQ(lids(test::joined(block, test::turned_over(cavity))), 0) << "within";
    EXPECT_EQ(lids(test::joined(block, cavity)), 0);
  }
}

/// With the corner of a hole moved to the place of one of the body's: they are one vertex then, and
/// connected, though no edge is of both.
PolygonSoup tetrahedron_in_corner(double size) {
  return {.points = {{1, 1, 1}, {1, 0.8 - size, 1}, {0.9 - size, 0.7, 1}, {0.9, 0.7, 0.7 - size}},
          .polygons = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

double signed_volume(const PolygonSoup& mesh) {
  double six = 0;
  for (const Polygon& p : mesh.polygons)
    for (std::size_t k = 2; k < p.size(); ++k)
      six += mesh.points[p[0]].dot(mesh.points[p[k - 1]].cross(mesh.points[p[k]]));
  return six / 6;
}

// Reference: by hand: the one triangle of the hole on the body's upper face. A shell that shares a
// corner or an edge with the body's shell is a shell of its own all the same.
TEST(ModelChoiceOfPockets, the_wall_is_said_where_a_pocket_shares_a_corner_or_an_edge) {
  const PolygonSoup block = test::box({2, 2, 2});
  for (const double size : {0.05, 0.2, 0.5}) {
    PolygonSoup hole = tetrahedron_in_corner(size);
    if (signed_volume(hole) > 0) hole = test::turned_over(hole);
    const PolygonSoup mesh = test::joined(block, hole);
    EXPECT_EQ(lids(mesh), 1) << size;
    EXPECT_EQ(lids(test::turned_over(mesh)), 1) << size;
    EXPECT_NEAR(test::body(mesh)->mass.measure, 8 + signed_volume(hole), 1e-12);
    // A corner within shares nothing that is a mouth.
    EXPECT_EQ(lids(test::joined(block, test::turned_over(test::placed(test::box({size, size, size}),
                                                                      {0.1, 0, 0})))),
              0);
  }
  for (const double depth : {0.2, 0.5, 1.0}) {  // a slot along the whole of an edge of the block
    const PolygonSoup slot =
        test::placed(test::box({depth, 2, depth}), {1 - depth / 2, 0, 1 - depth / 2});
    const PolygonSoup mesh = test::joined(block, test::turned_over(slot));
    EXPECT_EQ(lids(mesh), 8) << depth;
    EXPECT_NEAR(test::body(mesh)->mass.measure, 8 - 2 * depth * depth, 1e-8);
  }
}

// With what fills the hole exactly, in any order: material all through.
TEST(ModelChoiceOfPockets, one_that_another_body_fills_is_none) {
  for (const Holed& h : holed()) {
    const PolygonSoup filler = test::triangulated(h.hole), pocket = test::turned_over(filler);
    const double volume = test::body(h.body)->mass.measure;
    for (const auto& mesh : {test::joined(h.body, test::joined(pocket, filler)),
                             test::joined(h.body, test::joined(filler, pocket)),
                             test::joined(pocket, test::joined(h.body, filler))})
      for (const bool over : {false, true}) {
        const auto body = test::body(over ? test::turned_over(mesh) : mesh);
        EXPECT_NEAR(body->mass.measure, volume, 1e-6 * volume);
        EXPECT_TRUE(inside(*body, h.in_hole));
      }
    // An export of both sides of all: the hole is one.
    const PolygonSoup one_side = test::joined(test::triangulated(h.body), pocket);
    const auto sides = test::body(test::joined(one_side, test::turned_over(one_side)));
    EXPECT_NEAR(sides->mass.measure, h.volume, 1e-6 * h.volume);
  }
}

}  // namespace
}  // namespace sonde
