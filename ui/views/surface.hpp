// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "engine/geometry/soup.hpp"

class vtkPolyData;

namespace sonde::ui {

/// A soup as VTK draws it: smooth, with sharp edges above 35°. Slow for a large mesh: call it in a
/// worker.
vtkSmartPointer<vtkPolyData> make_surface(const Soup& soup);

/// The same points and triangles for another thread. What is drawn here is traversed here, and a
/// vtkCellArray remembers how far it was: the shell has one of its own, round the same indices.
vtkSmartPointer<vtkPolyData> shell_of(vtkPolyData& surface);

}  // namespace sonde::ui
