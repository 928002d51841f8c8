// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that were mended, taken smaller.
#include <gtest/gtest.h>

#include "engine/geometry/mass_integrals.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/distance.hpp"
#include "tests/engine/offset/prisms.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::Outline;

/// Cracks as of a float STL, and edges cut on one side alone, off the edge: no piece moves by
/// itself. The references are the sound peg, its hole and its clearance.
TEST(OffsetMended, a_cracked_peg_is_taken_smaller_as_the_sound_one) {
  std::uint64_t seed = 1;
  for (const Outline& outline : test::pegs())
    for (const double crack : {1e-10, 3e-9}) {
      const PolygonSoup sound = test::prism(outline, 0.03);
      const PolygonSoup cut = test::cut_beyond(sound, Vec3(0, 0.3, 1), 0.015, crack);
      const auto block = test::body(test::block_with_hole(outline, 0.02));
      const auto shrunk = offset_faces(*test::body(sound), -1e-5);
      for (const PolygonSoup& mesh : {test::cracked(sound, crack, seed++), cut}) {
        const auto nominal = test::body(mesh);
        ASSERT_TRUE(nominal->solid && nominal->cracked);
        const auto peg = offset_faces(*nominal, -1e-5);
        EXPECT_FALSE(peg->cracked);
        EXPECT_TRUE(analyse_topology(peg->soup).closed);
        EXPECT_NEAR(mass_by_volume(peg->soup).measure, mass_by_volume(shrunk->soup).measure,
                    100 * crack * mass_by_area(nominal->soup).measure);
        const Distance gap = distance(*peg, *block, Transform());
        EXPECT_FALSE(gap.overlapping);
        EXPECT_NEAR(gap.distance, 1e-5, 4 * crack);
        EXPECT_EQ(separate_static({peg, block}, {}).status, Status::separated);
      }
    }
}

/// What closes an opening goes inwards with the rest, and is still told apart.
TEST(OffsetMended, caps_move_and_stay_caps) {
  const PolygonSoup ball = test::icosphere(1, 4);
  for (const std::size_t missing : {std::size_t{0}, std::size_t{333}}) {
    PolygonSoup open = ball;
    open.polygons.erase(open.polygons.begin() + static_cast<std::ptrdiff_t>(missing));
    const auto nominal = test::body(open);
    ASSERT_TRUE(nominal->solid && !nominal->caps.triangles.empty());
    const auto body = offset_faces(*nominal, -0.01);
    EXPECT_EQ(body->caps.triangles.size(), nominal->caps.triangles.size());
    Vec3 middle = Vec3::Zero(), before = Vec3::Zero();
    for (const Vec3& x : body->caps.vertices) middle += x / double(body->caps.vertices.size());
    for (const Vec3& x : nominal->caps.vertices)
      before += x / double(nominal->caps.vertices.size());
    EXPECT_NEAR((before - middle).norm(), 0.01, 1e-4);
  }
}

}  // namespace
}  // namespace sonde
