// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/search/pair.hpp"
#include "ui/document/loaded_scene.hpp"
#include "ui/views/part_surface.hpp"

class vtkPolyData;

namespace sonde::ui {

/// The edges at which a mesh is not closed; empty where it is.
struct DefectLines {
  vtkSmartPointer<vtkPolyData> holes, flipped;
};

/// What closes the openings of a mesh, as a surface, and the lines where it meets the mesh; null
/// where nothing does.
struct CapSurface {
  vtkSmartPointer<vtkPolyData> faces, seams;
};

/// Two bodies as they are drawn, and how a picture of them begins.
struct DrawnBodies {
  std::optional<Pair> pair;           ///< none: nothing is drawn
  Pose first;                         ///< X_FM of the probe until the first instant
  Quat q_FW = Quat::Identity();       ///< the scene's axes in the fixed body's
  Coupling coupling;                  ///< its limits are the scales of force and torque
  std::optional<CameraPlace> camera;  ///< the scene's; none: the view chooses
  vtkSmartPointer<vtkPolyData> probe_surface;
  vtkSmartPointer<vtkPolyData> fixed_surface;
  DefectLines probe_defects, fixed_defects;
  CapSurface probe_caps, fixed_caps;
  std::vector<BodyPart> parts;       ///< of the fixed body, felt or not; empty where it is one mesh
  std::vector<PartLook> part_looks;  ///< of each of them
  PartSurface part_surface;  ///< and as they are drawn: `fixed_surface` is what is shown of it
};
/// Slow for large meshes: call it in a worker.
DrawnBodies draw_bodies(const LoadedScene& loaded);

}  // namespace sonde::ui
