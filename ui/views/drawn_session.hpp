// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <memory>

#include "ui/document/session.hpp"

class vtkPolyData;

namespace sonde::ui {

/// The edges at which a mesh is not closed; empty where it is.
struct DefectLines {
  vtkSmartPointer<vtkPolyData> holes, flipped;
};

/// A session with its bodies as they are drawn. A worker makes it, because that takes long.
struct DrawnSession {
  std::unique_ptr<Session> session;
  vtkSmartPointer<vtkPolyData> probe_surface;
  vtkSmartPointer<vtkPolyData> fixed_surface;
  DefectLines probe_defects, fixed_defects;
};
DrawnSession draw_session(LoadedScene loaded);

}  // namespace sonde::ui
