// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "engine/geometry/soup.hpp"

class vtkCellArray;
class vtkPolyData;

namespace sonde::ui {

/// A soup as VTK draws it: smooth, with sharp edges above 35°. Slow for a large mesh: call it in a
/// worker.
vtkSmartPointer<vtkPolyData> make_surface(const Soup& soup);

/// Does each of its points have a colour of its own?
bool has_colours(vtkPolyData& surface);

/// The triangles of a surface for another thread than draws it: a vtkCellArray remembers how far it
/// was traversed, so that each thread needs one of its own, round the same indices.
vtkSmartPointer<vtkCellArray> own_cells(vtkPolyData& surface);
/// The same surface for another thread; to be called in the one that draws it.
vtkSmartPointer<vtkPolyData> shell_of(vtkPolyData& surface);

}  // namespace sonde::ui
