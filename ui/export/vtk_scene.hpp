// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>
#include <span>

#include "ui/export/exported_instant.hpp"

class vtkPolyData;

namespace sonde::ui {

/// The two bodies as they are drawn, each in its mesh frame.
struct Surfaces {
  vtkSmartPointer<vtkPolyData> probe, fixed;
  Vec3 com = Vec3::Zero();  ///< the probe's centre of mass, in its mesh frame
};

/// A surface at a pose, as data of its own.
vtkSmartPointer<vtkPolyData> surface_at(vtkPolyData& surface, const Pose& pose);
/// The clusters of contacts of an instant, each as one point on the fixed body with normal [1], on
/// probe [m], gap [m], multiplier [m], share of force and cluster (its id).
vtkSmartPointer<vtkPolyData> contact_points(const ExportedInstant& instant);
/// The centre of mass with force [N] and torque [N m].
vtkSmartPointer<vtkPolyData> wrench_point(const ExportedInstant& instant, const Vec3& com);

/// Writes a new folder for ParaView: sonde.vtm for one instant, else sonde_0000.vtm and so on with
/// sonde.vtm.series, which has their times. Each holds the blocks fixed, probe, ghost (the
/// separated probe), contacts and wrench; they are VTP files beside, the fixed body once for all.
/// Throws InputError, and Cancelled where `progress` says so; then there is no folder.
void write_vtk(const std::filesystem::path& folder, const Surfaces& surfaces,
               std::span<const ExportedInstant> instants,
               const std::function<bool(double fraction)>& progress = {});

/// Writes the same of one instant as a glTF 2.0 file, its data inside, in the colours of the view.
/// Throws InputError, and Cancelled where `progress` says so; then there is no file.
void write_gltf(const std::filesystem::path& file, const Surfaces& surfaces,
                const ExportedInstant& instant,
                const std::function<bool(double fraction)>& progress = {});

}  // namespace sonde::ui
