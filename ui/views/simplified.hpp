// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace sonde::ui {

/// A simplified surface has at most this many triangles.
constexpr int simplified_triangles = 8000;

/// The surface in far fewer triangles, for pictures of what moves: vertices are merged within the
/// cells of a grid. Slow for a large surface: call it in a worker. The surface may be drawn
/// meanwhile if its bounds are computed.
vtkSmartPointer<vtkPolyData> simplified(vtkPolyData& surface);

}  // namespace sonde::ui
