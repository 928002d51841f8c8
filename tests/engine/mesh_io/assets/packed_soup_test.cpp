// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/packed_soup.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(PackedSoup, comes_out_as_it_went_in) {
  PolygonSoup soup = test::torus(0.3, 0.1, 7, 5);
  soup.remarks = {"one", "", "two"};
  const PolygonSoup out = unpacked("f", packed(soup));
  EXPECT_EQ(out.points, soup.points);
  EXPECT_EQ(out.polygons, soup.polygons);
  EXPECT_EQ(out.remarks, soup.remarks);
}

TEST(PackedSoup, an_error_is_thrown_again) {
  try {
    unpacked("f", packed(InputError("g: why")));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "g: why");
  }
}

TEST(PackedSoup, whatever_does_not_fit_together_is_refused) {
  const std::string good = packed(test::tetrahedron(1));
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_THROW(unpacked("f", good.substr(0, size)), InputError) << size;
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(0xff);
    try {
      for (const Polygon& polygon : unpacked("f", bad).polygons)
        for (const std::size_t i : polygon) EXPECT_LT(i, 4u);
    } catch (const InputError&) {
      continue;
    }
  }
}

}  // namespace
}  // namespace sonde
