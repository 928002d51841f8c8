// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/surface.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTypeInt32Array.h>

namespace sonde::ui {
namespace {

constexpr double sharp_edge_of_body = 35;      // degrees
constexpr std::size_t smooth_up_to = 400'000;  // triangles; normals of more take over a second

/// With indices of 32 bits: half of what VTK takes by itself.
vtkSmartPointer<vtkPolyData> copy_of(const Soup& soup) {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(soup.vertices.size()));
  float* to = coordinates->GetPointer(0);
  for (const Vec3& vertex : soup.vertices)
    for (const double x : vertex) *to++ = static_cast<float>(x);
  vtkNew<vtkTypeInt32Array> corners, begins;
  corners->SetNumberOfValues(static_cast<vtkIdType>(3 * soup.triangles.size()));
  begins->SetNumberOfValues(static_cast<vtkIdType>(soup.triangles.size() + 1));
  int* corner = corners->GetPointer(0);
  for (const Triangle& triangle : soup.triangles)
    for (const auto index : triangle) *corner++ = static_cast<int>(index);
  for (vtkIdType i = 0; i < begins->GetNumberOfValues(); ++i)
    begins->SetValue(i, static_cast<int>(3 * i));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> cells;
  cells->SetData(begins, corners);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_surface(const Soup& soup) {
  auto surface = copy_of(soup);
  if (soup.triangles.size() > smooth_up_to) return surface;
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(sharp_edge_of_body);
  normals->ConsistencyOff();  // a soup's triangles stay as they are
  normals->Update();
  vtkSmartPointer<vtkPolyData> smooth = normals->GetOutput();
  smooth->GetPolys()->ConvertTo32BitStorage();
  smooth->Squeeze();
  return smooth;
}

bool has_colours(vtkPolyData& surface) { return surface.GetPointData()->GetScalars() != nullptr; }

vtkSmartPointer<vtkCellArray> own_cells(vtkPolyData& surface) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->ShallowCopy(surface.GetPolys());
  return cells;
}

vtkSmartPointer<vtkPolyData> shell_of(vtkPolyData& surface) {
  auto shell = vtkSmartPointer<vtkPolyData>::New();
  shell->ShallowCopy(&surface);  // which shares the cells
  shell->SetPolys(own_cells(surface));
  return shell;
}

}  // namespace sonde::ui
