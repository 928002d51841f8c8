// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/surface.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkStaticCleanPolyData.h>

namespace sonde::ui {
namespace {

constexpr double sharp_edge = 35;              // degrees
constexpr std::size_t smooth_up_to = 400'000;  // triangles; normals of more take over a second

vtkSmartPointer<vtkPolyData> copy_of(const Soup& soup) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(static_cast<vtkIdType>(soup.vertices.size()));
  for (std::size_t i = 0; i < soup.vertices.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), soup.vertices[i].data());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(soup.triangles.size()),
                       static_cast<vtkIdType>(3 * soup.triangles.size()));
  for (const Triangle& triangle : soup.triangles)
    cells->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_surface(const Soup& soup) {
  auto surface = copy_of(soup);
  if (soup.triangles.size() > smooth_up_to) return surface;
  // A mesh written corner by corner has no shared vertices to smooth over until they are merged.
  vtkNew<vtkStaticCleanPolyData> merged;
  merged->SetInputData(surface);
  merged->ConvertPolysToLinesOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(merged->GetOutputPort());
  normals->SetFeatureAngle(sharp_edge);
  normals->ConsistencyOff();  // a soup's triangles stay as they are
  normals->Update();
  return normals->GetOutput();
}

}  // namespace sonde::ui
