// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/grid_view.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double spacing_part = 0.15;  // of the body's larger side on the ground
constexpr double beyond = 0.6;         // of that side: how far the grid goes on beside the body

}  // namespace

GridView::GridView(vtkRenderer& renderer)
    : renderer_(&renderer),
      lines_(vtkSmartPointer<vtkPolyData>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines_);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetColor(colour::faint.redF(), colour::faint.greenF(),
                                  colour::faint.blueF());
  actor_->GetProperty()->SetOpacity(0.45);
  actor_->GetProperty()->LightingOff();
  actor_->VisibilityOff();
  renderer.AddActor(actor_);
}

GridView::~GridView() { renderer_->RemoveActor(actor_); }

void GridView::set(const Eigen::AlignedBox3d& box, const Quat& q_FW) {
  Eigen::AlignedBox3d world;
  for (int i = 0; i < 8; ++i)
    world.extend(q_FW.conjugate() * Vec3(box.corner(Eigen::AlignedBox3d::CornerType(i))));
  const double side = std::max(world.sizes().x(), world.sizes().y());
  spacing_ = round_down_125(spacing_part * std::max(side, 1e-9));
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto line = [&](const Vec3& from, const Vec3& to) {
    const vtkIdType ends[2] = {points->InsertNextPoint(Vec3(q_FW * from).data()),
                               points->InsertNextPoint(Vec3(q_FW * to).data())};
    cells->InsertNextCell(2, ends);
  };
  const Vec3 middle = world.center();
  const double reach = std::ceil((0.5 + beyond) * side / spacing_) * spacing_;
  // Lines lie at whole multiples of the spacing in the scene's coordinates.
  const double x0 = std::round(middle.x() / spacing_) * spacing_;
  const double y0 = std::round(middle.y() / spacing_) * spacing_;
  const double z = world.min().z();
  const int count = static_cast<int>(std::lround(reach / spacing_));
  for (int i = -count; i <= count; ++i) {
    line({x0 + i * spacing_, y0 - reach, z}, {x0 + i * spacing_, y0 + reach, z});
    line({x0 - reach, y0 + i * spacing_, z}, {x0 + reach, y0 + i * spacing_, z});
  }
  lines_->SetPoints(points);
  lines_->SetLines(cells);
}

void GridView::draw(const Frame& /*frame*/) { actor_->VisibilityOn(); }

void GridView::hide() { actor_->VisibilityOff(); }

}  // namespace sonde::ui
