// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "engine/geometry/soup.hpp"

class vtkPolyData;

namespace sonde::ui {

/// A soup as VTK draws it: smooth, with sharp edges above 35°. Slow for a large mesh: call it in a
/// worker.
vtkSmartPointer<vtkPolyData> make_surface(const Soup& soup);

}  // namespace sonde::ui
