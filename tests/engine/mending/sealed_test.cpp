// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/sealed.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/mass.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/geometry/topology.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Sealed sealed_of(const PolygonSoup& mesh) {
  const Soup soup = test::welded(mesh);
  const Seams seams = find_seams(soup, edge_uses(soup));
  const Orientation orientation = find_orientation(soup, seams.uses);
  return seal(soup, seams, orientation, find_caps(soup, seams.uses, orientation));
}

// Reference: the volume of the mesh before it was cracked, or cut.
TEST(Sealed, is_closed_and_as_large_as_what_was_broken) {
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::icosphere(1, 3), test::torus(1, 0.3, 24, 12)}) {
    const double volume = mass_by_volume(test::soup_of(mesh)).measure;
    for (const PolygonSoup& broken :
         {test::cracked(mesh, 1e-6, 3), test::cut_beyond(mesh, Vec3(1, 2, 3), 0.1),
          test::cut_beyond(mesh, Vec3(0, 1, 0), -0.2, 1e-7)}) {
      const Sealed sealed = sealed_of(broken);
      EXPECT_EQ(analyse_topology(sealed.soup).open_edges, 0u);
      EXPECT_EQ(analyse_topology(sealed.soup).misoriented_edges, 0u);
      EXPECT_NEAR(mass_by_volume(sealed.soup).measure, volume, 1e-5 * volume);
    }
  }
}

TEST(Sealed, parts_can_be_taken_out) {
  const Sealed sealed =
      sealed_of(test::joined(test::box({1, 1, 1}), test::tetrahedron(1), {3, 0, 0}));
  const Sealed second = parts_of(sealed, {false, true});
  EXPECT_EQ(second.soup.triangles.size(), 4u);
  EXPECT_EQ(second.part, (std::vector<std::uint32_t>(4, 1)));
}

}  // namespace
}  // namespace sonde
