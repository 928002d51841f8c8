// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/simplified.hpp"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>
#include <vtkStaticPointLocator.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "ui/views/surface.hpp"

namespace sonde::ui {
namespace {

// Cells along each side of the box. A ball in N of them has about 6 N² triangles, a crumpled sheet
// more: then the grid is made coarser.
constexpr int first_divisions = 48;
constexpr int least_divisions = 8;
// Degrees; the edges between cells are not the body's own.
constexpr double sharp_edge_of_cells = 50;

/// Only what the clustering is about: no normals.
vtkSmartPointer<vtkPolyData> bare(vtkPolyData& surface) {
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->SetPoints(surface.GetPoints());
  out->SetPolys(own_cells(surface));
  return out;
}

vtkSmartPointer<vtkPolyData> clustered(vtkPolyData& surface, int divisions) {
  vtkNew<vtkQuadricClustering> clustering;
  clustering->SetInputData(&surface);
  clustering->SetNumberOfDivisions(divisions, divisions, divisions);
  clustering->CopyCellDataOff();
  clustering->Update();
  return clustering->GetOutput();
}

/// The points that triangles have, with their colours.
vtkSmartPointer<vtkPolyData> coloured_points(vtkPolyData& surface, vtkDataArray& colours) {
  vtkNew<vtkIdList> ids;
  std::vector<bool> seen(static_cast<std::size_t>(surface.GetNumberOfPoints()));
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> own;
  own->SetNumberOfComponents(3);
  const auto cells = own_cells(surface);
  for (cells->InitTraversal(); cells->GetNextCell(ids);)
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k) {
      const vtkIdType id = ids->GetId(k);
      if (seen[static_cast<std::size_t>(id)]) continue;
      seen[static_cast<std::size_t>(id)] = true;
      points->InsertNextPoint(surface.GetPoint(id));
      own->InsertNextTuple(id, &colours);
    }
  auto out = vtkSmartPointer<vtkPolyData>::New();
  out->SetPoints(points);
  out->GetPointData()->SetScalars(own);
  return out;
}

/// Clusters have no colours: each point takes that of the nearest one of the surface.
void colour_as(vtkPolyData& surface, vtkPolyData& coarse) {
  vtkDataArray* const colours = surface.GetPointData()->GetScalars();
  if (!colours) return;
  const auto from = coloured_points(surface, *colours);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(from);
  locator->BuildLocator();
  vtkNew<vtkUnsignedCharArray> own;
  own->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < coarse.GetNumberOfPoints(); ++i)
    own->InsertNextTuple(locator->FindClosestPoint(coarse.GetPoint(i)),
                         from->GetPointData()->GetScalars());
  coarse.GetPointData()->SetScalars(own);
}

}  // namespace

vtkSmartPointer<vtkPolyData> simplified(vtkPolyData& surface) {
  const auto shell = bare(surface);
  int divisions = first_divisions;
  auto coarse = clustered(*shell, divisions);
  while (coarse->GetNumberOfPolys() > simplified_triangles && divisions > least_divisions) {
    const double share = simplified_triangles / double(coarse->GetNumberOfPolys());
    divisions = std::max(least_divisions, static_cast<int>(0.95 * divisions * std::sqrt(share)));
    coarse = clustered(*shell, divisions);
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(coarse);
  normals->SetFeatureAngle(sharp_edge_of_cells);
  normals->ConsistencyOff();
  normals->Update();
  vtkSmartPointer<vtkPolyData> out = normals->GetOutput();
  colour_as(surface, *out);
  return out;
}

}  // namespace sonde::ui
