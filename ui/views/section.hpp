// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "engine/geometry/soup.hpp"

class vtkPolyData;

namespace sonde::ui {

/// Where a plane cuts a surface: its outline as lines, and what they go round filled. Of a surface
/// that is not closed there, what its lines do go round. Vertices that are one have one index.
struct SectionFace {
  vtkSmartPointer<vtkPolyData> outline, filled;
};
/// In the soup's frame. Some ms for a million triangles.
SectionFace section_of(const Soup& soup, const Vec3& point, const Vec3& normal);

}  // namespace sonde::ui
