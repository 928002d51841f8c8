// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/simplified.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>

#include <cmath>

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
  return normals->GetOutput();
}

}  // namespace sonde::ui
