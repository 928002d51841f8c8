// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/part_surface.hpp"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>

#include "engine/geometry/transform.hpp"
#include "ui/base/theme.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {
namespace {

constexpr int lighter = 145;  // QColor's: 100 is as it was

/// Quiet ones, unlike those of the probe and the overlays, of which the first is any fixed body's.
const std::array<QColor, 6>& colours() {
  static const std::array<QColor, 6> all{colour::fixed,         QColor(110, 140, 120),
                                         QColor(150, 125, 110), QColor(105, 140, 160),
                                         QColor(150, 145, 105), QColor(140, 115, 140)};
  return all;
}

Soup placed(const BodyPart& part) {
  Soup soup = part.body->soup;
  const Transform X(part.X_BP);
  for (Vec3& x : soup.vertices) x = X * x;
  return soup;
}

vtkSmartPointer<vtkUnsignedCharArray> colours_of(const PartSurface& parts,
                                                 const std::vector<PartLook>& looks) {
  auto out = vtkSmartPointer<vtkUnsignedCharArray>::New();
  out->SetNumberOfComponents(3);
  out->SetNumberOfTuples(parts.first_point.back());
  unsigned char* to = out->GetPointer(0);
  for (std::size_t i = 0; i < looks.size(); ++i)
    for (vtkIdType k = parts.first_point[i]; k < parts.first_point[i + 1]; ++k) {
      *to++ = static_cast<unsigned char>(looks[i].colour.red());
      *to++ = static_cast<unsigned char>(looks[i].colour.green());
      *to++ = static_cast<unsigned char>(looks[i].colour.blue());
    }
  return out;
}

}  // namespace

QColor part_colour(const SceneBody& body, std::size_t part) {
  const QColor own(QString::fromStdString(body.parts[part].colour));
  return own.isValid() ? own : colours().at(part % colours().size());
}

std::vector<PartLook> looks_of(const SceneBody& body, std::optional<std::size_t> chosen) {
  std::vector<PartLook> looks;
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    const QColor colour = part_colour(body, i);
    looks.push_back({chosen == i ? colour.lighter(lighter) : colour, body.parts[i].shown});
  }
  return looks;
}

PartSurface make_part_surface(const std::vector<BodyPart>& parts) {
  PartSurface out;
  vtkNew<vtkAppendPolyData> append;
  vtkIdType points = 0, cells = 0;
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  surfaces.reserve(parts.size());
  for (const BodyPart& part : parts) surfaces.push_back(make_surface(placed(part)));
  // All with normals, or none: what is appended has what all of it have.
  const bool bare = std::ranges::any_of(
      surfaces, [](const auto& s) { return s->GetPointData()->GetNormals() == nullptr; });
  for (const auto& surface : surfaces) {
    if (bare) surface->GetPointData()->SetNormals(nullptr);
    out.first_point.push_back(points);
    out.first_cell.push_back(cells);
    points += surface->GetNumberOfPoints();
    cells += surface->GetNumberOfPolys();
    append->AddInputData(surface);
  }
  out.first_point.push_back(points);
  out.first_cell.push_back(cells);
  append->Update();
  out.all = append->GetOutput();
  out.all->GetPolys()->ConvertTo32BitStorage();
  return out;
}

vtkSmartPointer<vtkPolyData> shown_parts(const PartSurface& parts,
                                         const std::vector<PartLook>& looks) {
  const int* const corners = parts.all->GetPolys()->GetConnectivityArray32()->GetPointer(0);
  vtkNew<vtkTypeInt32Array> kept, begins;
  vtkIdType cells = 0;
  for (std::size_t i = 0; i < looks.size(); ++i)
    if (looks[i].shown) cells += parts.first_cell[i + 1] - parts.first_cell[i];
  kept->SetNumberOfValues(3 * cells);
  begins->SetNumberOfValues(cells + 1);
  int* to = kept->GetPointer(0);
  for (std::size_t i = 0; i < looks.size(); ++i)
    if (looks[i].shown)
      to = std::copy(corners + 3 * parts.first_cell[i], corners + 3 * parts.first_cell[i + 1], to);
  for (vtkIdType i = 0; i <= cells; ++i) begins->SetValue(i, static_cast<int>(3 * i));
  vtkNew<vtkCellArray> polys;
  polys->SetData(begins, kept);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(parts.all->GetPoints());
  surface->GetPointData()->SetNormals(parts.all->GetPointData()->GetNormals());
  surface->GetPointData()->SetScalars(colours_of(parts, looks));
  surface->SetPolys(polys);
  return surface;
}

}  // namespace sonde::ui
