// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/section.hpp"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/topology.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui {
namespace {

double area_of(vtkPolyData& filled) {
  double area = 0;
  for (vtkIdType i = 0; i < filled.GetNumberOfCells(); ++i) {
    auto* triangle = vtkTriangle::SafeDownCast(filled.GetCell(i));
    if (triangle) area += triangle->ComputeArea();
  }
  return area;
}

Soup soup_of(const PolygonSoup& polygons) { return compacted(triangulate(polygons).soup); }

// Reference: the area of a cube's sections: a square, and the hexagon across its diagonal, 3√3/4 of
// the square of the side's √2.
TEST(Section, of_a_cube_is_a_square_or_a_hexagon) {
  const Soup cube = soup_of(sonde::test::box({2, 2, 2}));
  const SectionFace square = section_of(cube, {0, 0, 0.3}, Vec3::UnitZ());
  EXPECT_NEAR(area_of(*square.filled), 4, 1e-9);
  EXPECT_GT(square.outline->GetNumberOfLines(), 3);
  const SectionFace hexagon = section_of(cube, Vec3::Zero(), Vec3(1, 1, 1).normalized());
  EXPECT_NEAR(area_of(*hexagon.filled), 3 * std::numbers::sqrt3, 1e-9);
  const SectionFace none = section_of(cube, {0, 0, 3}, Vec3::UnitZ());
  EXPECT_EQ(none.filled->GetNumberOfCells(), 0);
  EXPECT_EQ(none.outline->GetNumberOfLines(), 0);
}

// Reference: two concentric polygons of n corners, of area n/2 r² sin(2π/n) each.
TEST(Section, of_a_ring_has_its_hole) {
  constexpr int n = 64;
  const Soup ring = soup_of(sonde::test::torus(1, 0.25, n, 16));
  const SectionFace across = section_of(ring, {0, 0, 1e-9}, Vec3::UnitZ());
  const double each = n / 2.0 * std::sin(2 * std::numbers::pi / n);
  EXPECT_NEAR(area_of(*across.filled), each * (1.25 * 1.25 - 0.75 * 0.75), 1e-6);
  const SectionFace along = section_of(ring, Vec3::Zero(), Vec3(0.02, 1, 0.01).normalized());
  EXPECT_NEAR(area_of(*along.filled), 2 * 8 * 0.0625 * std::sin(std::numbers::pi / 8), 0.003)
      << "two discs";
}

// A plane through corners and along faces: it counts as a little beside them.
TEST(Section, through_corners_is_closed) {
  const Soup cube = soup_of(sonde::test::box({2, 2, 2}));
  EXPECT_NEAR(area_of(*section_of(cube, {1, 0, 0}, Vec3(1, 1, 0).normalized()).filled),
              2 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(area_of(*section_of(cube, Vec3::Zero(), Vec3(1, 1, 0).normalized()).filled),
              4 * std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace sonde::ui
