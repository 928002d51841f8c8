// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "engine/geometry/soup.hpp"

class vtkPolyData;

namespace sonde::ui {

/// A soup as VTK draws it: smooth where it is smooth, sharp at edges above 35°. Takes a while for a
/// large mesh: call it in a worker.
vtkSmartPointer<vtkPolyData> make_surface(const Soup& soup);

}  // namespace sonde::ui
