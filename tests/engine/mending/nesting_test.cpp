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

TEST(Nesting, a_copy_in_the_same_place_is_not_nested) {
  const PolygonSoup box = test::icosphere(1, 1);
  EXPECT_EQ(turned({box, test::turned_over(box)}), (Turned{false, true}));
}

}  // namespace
}  // namespace sonde
