// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkGLTFExporter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "engine/base/progress.hpp"
#include "engine/text/output_file.hpp"
#include "ui/base/theme.hpp"
#include "ui/export/vtk_scene.hpp"
#include "ui/views/probe_view.hpp"

namespace sonde::ui {
namespace {

void add(vtkRenderer& renderer, vtkPolyData& data, const QColor& colour, double opacity = 1) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  actor->GetProperty()->SetOpacity(opacity);
  renderer.AddActor(actor);
}

void add_arrow(vtkRenderer& renderer, const Vec3& from, const Vec3& along, const QColor& colour) {
  const double length = along.norm();
  if (!(length > 0)) return;
  vtkNew<vtkArrowSource> arrow;
  arrow->Update();
  const Pose pose{Quat::FromTwoVectors(Vec3::UnitX(), along), Vec3::Zero()};
  const auto turned = surface_at(*arrow->GetOutput(), pose);
  for (vtkIdType i = 0; i < turned->GetNumberOfPoints(); ++i) {
    const Vec3 at = from + length * Vec3(turned->GetPoint(i));
    turned->GetPoints()->SetPoint(i, at.data());
  }
  add(renderer, *turned, colour);
}

}  // namespace

void write_gltf(const std::filesystem::path& file, const Surfaces& surfaces,
                const ExportedInstant& instant, const std::function<bool(double)>& progress) {
  check_writable(file);
  vtkNew<vtkRenderer> renderer;
  const Separation& s = instant.separation;
  add(*renderer, *surfaces.fixed, colour::fixed);
  add(*renderer, *surface_at(*surfaces.probe, instant.probe), colour::probe);
  double size = 0;
  double box[6];
  surfaces.probe->GetBounds(box);
  for (int i = 0; i < 3; ++i) size = std::max(size, box[2 * i + 1] - box[2 * i]);
  if (s.status == Status::penetrating) {
    add(*renderer, *surface_at(*surfaces.probe, s.separated), colour::ghost, ghost_opacity);
    for (const ContactCluster& c : s.clusters)
      add_arrow(*renderer, c.contact.on_fixed, 0.25 * size * c.contact.normal, colour::contact);
    if (const double force = instant.wrench.force.norm(); force > 0)
      add_arrow(*renderer, s.device * surfaces.com, 0.6 * size / force * instant.wrench.force,
                colour::force);
  }
  vtkNew<vtkRenderWindow> window;  // never shown: the exporter asks it for what there is
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->InlineDataOn();
  exporter->SaveNormalOn();
  report(progress, 0.2);
  PendingFile written(file, exporter->WriteToString());
  report(progress, 1);
  written.commit();
}

}  // namespace sonde::ui
