// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the torus's equation; a cell of the grid that merges vertices is what it may be off.
#include "ui/views/simplified.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "tests/support/shapes.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {
namespace {

TEST(Simplified, is_the_same_surface_in_few_triangles) {
  constexpr double ring = 0.05, tube = 0.02;
  const Soup soup = sonde::test::body(sonde::test::torus(ring, tube, 180, 120))->soup;
  const auto surface = make_surface(soup);
  surface->ComputeBounds();
  const auto coarse = simplified(*surface);
  EXPECT_GT(surface->GetNumberOfPolys(), 5 * simplified_triangles);
  EXPECT_LE(coarse->GetNumberOfPolys(), simplified_triangles);
  EXPECT_GT(coarse->GetNumberOfPolys(), simplified_triangles / 4);
  double worst = 0;
  for (vtkIdType i = 0; i < coarse->GetNumberOfPoints(); ++i) {
    double x[3];
    coarse->GetPoint(i, x);
    const double off = std::hypot(std::hypot(x[0], x[1]) - ring, x[2]) - tube;
    worst = std::max(worst, std::abs(off));
  }
  EXPECT_LT(worst, 2 * (ring + tube) / 20) << "m, a cell of a twentieth of the box";
}

}  // namespace
}  // namespace sonde::ui
