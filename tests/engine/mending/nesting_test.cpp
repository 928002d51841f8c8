// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/nesting.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/mass_integrals.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Which of some closed meshes are turned.
std::vector<bool> turned(const std::vector<PolygonSoup>& meshes) {
  Sealed sealed;
  std::vector<PartFacts> facts;
  PolygonSoup all;
  for (std::uint32_t p = 0; p < meshes.size(); ++p) {
    const Soup soup = test::soup_of(meshes[p]);
    sealed.part.insert(sealed.part.end(), soup.triangles.size(), p);
    facts.push_back({.triangles = soup.triangles.size(), .volume = mass_by_volume(soup).measure});
    all = test::joined(all, meshes[p]);
  }
  sealed.soup = test::soup_of(all);
  sealed.cap.assign(sealed.part.size(), Sealed::no_cap);
  return parts_to_turn(sealed, facts, std::vector<bool>(meshes.size(), true));
}

using Turned = std::vector<bool>;

TEST(Nesting, an_outermost_part_is_turned_by_itself) {
  const PolygonSoup shapes[] = {test::box({1, 1, 1}), test::icosphere(0.5, 2),
                                test::torus(0.5, 0.2, 20, 10)};
  for (const PolygonSoup& a : shapes)
    for (const PolygonSoup& b : shapes) {
      const PolygonSoup other = test::placed(b, {3, 0, 0});
      EXPECT_EQ(turned({a, other}), (Turned{false, false}));
      EXPECT_EQ(turned({a, test::turned_over(other)}), (Turned{false, true}));
      EXPECT_EQ(turned({test::turned_over(a), test::turned_over(other)}), (Turned{true, true}));
      // Overlapping: neither is nested in the other.
      EXPECT_EQ(turned({a, test::turned_over(test::placed(b, {0.6, 0.1, 0.2}))}),
                (Turned{false, true}));
    }
}

TEST(Nesting, a_cavity_and_what_is_in_it_turn_with_what_holds_them) {
  const PolygonSoup outer = test::box({4, 4, 4}),
                    cavity = test::turned_over(test::icosphere(1.5, 2)),
                    core = test::box({1, 1, 1});
  const auto over = [](const PolygonSoup& mesh) { return test::turned_over(mesh); };
  EXPECT_EQ(turned({outer, cavity}), (Turned{false, false}));
  EXPECT_EQ(turned({outer, cavity, core}), (Turned{false, false, false}));
  EXPECT_EQ(turned({over(core), over(cavity), over(outer)}), (Turned{true, true, true}));
  // Beside it one that is sound.
  EXPECT_EQ(turned({over(outer), over(cavity), test::placed(core, {9, 0, 0})}),
            (Turned{true, true, false}));
}

// A cavity that lies in two halves together stays one, whichever half is mirrored; and what is in
// it is material.
TEST(Nesting, a_cavity_across_two_halves_is_one) {
  const auto over = [](const PolygonSoup& mesh) { return test::turned_over(mesh); };
  for (const PolygonSoup& hollow :
       {test::box({2, 2, 2}), test::icosphere(1.1, 2), test::torus(0.9, 0.4, 20, 10)})
    for (const double overlap : {0.0, 0.3}) {
      const PolygonSoup right =
                            test::placed(test::box({2 + overlap, 4, 4}), {1 - overlap / 2, 0, 0}),
                        left =
                            test::placed(test::box({2 + overlap, 4, 4}), {overlap / 2 - 1, 0, 0}),
                        shifted = test::placed(hollow, {0.02, 0, 0}), cavity = over(shifted),
                        core = test::placed(test::box({0.2, 0.2, 0.2}), {0.02, 0, 0});
      EXPECT_EQ(turned({right, left, cavity}), (Turned{false, false, false}));
      EXPECT_EQ(turned({right, over(left), cavity}), (Turned{false, true, false}));
      EXPECT_EQ(turned({over(right), left, cavity}), (Turned{true, false, false}));
      EXPECT_EQ(turned({over(right), over(left), shifted}), (Turned{true, true, true}));
      EXPECT_EQ(turned({right, left, cavity, core}), (Turned{false, false, false, false}));
      EXPECT_EQ(turned({over(right), over(left), shifted, over(core)}),
                (Turned{true, true, true, true}));
    }
}

/// A body, and a pocket or a hole in it as a shell, some of whose faces lie on the body's.
struct Pocketed {
  PolygonSoup body, pocket;
};
std::vector<Pocketed> pocketed() {
  const auto rod = [](double radius, double low, double high, int n) {
    return test::lathed({{0, low}, {radius, low}, {radius, high}, {0, high}}, n);
  };
  return {{test::box({2, 2, 2}), test::placed(test::box({1, 1, 1}), {0.1, 0.2, 0.5})},
          {test::box({2, 3, 2}), rod(0.6, 0.2, 1, 24)},  // blind
          {test::box({2, 3, 2}), rod(0.6, -1, 1, 17)},   // through
          {rod(3, -1, 1, 40), test::placed(rod(0.5, -0.3, 1, 9), {1.2, 0.3, 0})},
          {test::prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, 2),
           test::placed(test::box({1, 1, 0.7}), {0.5, 0.8, 1.65})}};  // in an edge, and in the top
}

// A face of a pocket lies on the body's, which tells nothing; points below it do.
TEST(Nesting, a_pocket_whose_face_lies_on_the_bodys_is_a_cavity) {
  const auto over = [](const PolygonSoup& mesh) { return test::turned_over(mesh); };
  for (const auto& [body, pocket] : pocketed())
    for (const double sunk : {0.0, 1e-9, -1e-9}) {
      const PolygonSoup there = test::placed(pocket, {0, 0, -sunk});
      EXPECT_EQ(turned({body, over(there)}), (Turned{false, false})) << sunk;
      EXPECT_EQ(turned({over(there), body}), (Turned{false, false})) << sunk;
      EXPECT_EQ(turned({over(body), there}), (Turned{true, true})) << sunk;
      // Beside it one that is inside out by itself.
      EXPECT_EQ(turned({body, over(there), over(test::placed(body, {9, 0, 0}))}),
                (Turned{false, false, true}));
      // One that leans on the same face from outside lies in nothing.
      EXPECT_EQ(turned({body, over(test::placed(test::box({0.3, 0.3, 1}), {0.2, 0.2, -9}))}),
                (Turned{false, true}));
    }
}

// Of the body a frame is left: the pocket reaches all of its faces, as one shell or as three.
TEST(Nesting, holes_through_all_faces_are_cavities) {
  const auto over = [](const PolygonSoup& mesh) { return test::turned_over(mesh); };
  for (const double wide : {0.5, 1.2, 1.7}) {
    const PolygonSoup body = test::box({2, 2, 2}), along_x = over(test::box({2, wide, wide})),
                      along_y = over(test::box({wide * 0.9, 2, wide * 0.9})),
                      along_z = over(test::box({wide * 0.8, wide * 0.8, 2}));
    EXPECT_EQ(turned({body, along_x}), (Turned{false, false})) << wide;
    EXPECT_EQ(turned({body, along_x, along_y, along_z}), (Turned{false, false, false, false}))
        << wide;
    EXPECT_EQ(turned({over(body), over(along_x), over(along_y), over(along_z)}),
              (Turned{true, true, true, true}))
        << wide;
  }
}

// Two halves with a pocket in their common top, and one that reaches out of it.
TEST(Nesting, a_pocket_across_two_halves_is_a_cavity_unless_it_reaches_out) {
  const auto over = [](const PolygonSoup& mesh) { return test::turned_over(mesh); };
  const PolygonSoup right = test::placed(test::box({2, 4, 4}), {1, 0, 0}),
                    left = test::placed(right, {-2, 0, 0});
  for (const PolygonSoup& shape :
       {test::box({2, 2, 2}), test::lathed({{0, -1}, {1, -1}, {1, 1}, {0, 1}}, 11),
        test::placed(test::prism({{-1, -1}, {1, -1}, {0.3, 1}}, 2), {0, 0, -1})}) {
    const PolygonSoup pocket = test::placed(shape, {0.02, 0, 1});
    EXPECT_EQ(turned({right, left, over(pocket)}), (Turned{false, false, false}));
    EXPECT_EQ(turned({over(right), over(left), pocket}), (Turned{true, true, true}));
    EXPECT_EQ(turned({right, over(left), over(pocket)}), (Turned{false, true, false}));
    EXPECT_EQ(turned({right, over(left), pocket}), (Turned{false, true, false})) << "a body";
    EXPECT_EQ(turned({right, left, over(test::placed(pocket, {0, 0, 0.3}))}),
              (Turned{false, false, true}));
  }
}

// With other triangles, and off by rounding: not a cavity as large as all of it.
TEST(Nesting, a_copy_in_the_same_place_with_other_triangles_is_not_nested) {
  for (const double off : {0.0, 1e-9, -1e-8}) {
    const PolygonSoup fine = test::cut_beyond(test::box({1, 2, 3}), {0, 0, 1}, -9);
    EXPECT_EQ(turned({test::box({1, 2, 3}), test::turned_over(test::placed(fine, {off, 0, off}))}),
              (Turned{false, true}));
    const PolygonSoup halves[] = {test::placed(test::box({0.5, 2, 3}), {0.25, 0, 0}),
                                  test::placed(test::box({0.5, 2, 3}), {-0.25, 0, 0})};
    EXPECT_EQ(turned({halves[0], halves[1], test::turned_over(test::placed(fine, {off, 0, off}))}),
              (Turned{false, false, true}));
  }
}

TEST(Nesting, a_copy_in_the_same_place_is_not_nested) {
  const PolygonSoup box = test::icosphere(1, 1);
  EXPECT_EQ(turned({box, test::turned_over(box)}), (Turned{false, true}));
}

}  // namespace
}  // namespace sonde
