// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/stage.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <utility>
#include <vector>

#include "engine/geometry/defect_edges.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui {
namespace {

vtkSmartPointer<vtkPolyData> lines_of(const Soup& soup,
                                      const std::vector<DefectEdges::Edge>& edges) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const DefectEdges::Edge& edge : edges) {
    const vtkIdType ends[2] = {points->InsertNextPoint(soup.vertices[edge[0]].data()),
                               points->InsertNextPoint(soup.vertices[edge[1]].data())};
    lines->InsertNextCell(2, ends);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

DefectLines defects_of(const Body& body) {
  const DefectEdges edges = body.topology.closed ? DefectEdges{} : defect_edges(body.soup);
  return {lines_of(body.soup, edges.open), lines_of(body.soup, edges.flipped)};
}

}  // namespace

Stage make_stage(Opened opened) {
  Stage stage;
  stage.probe_surface = make_surface(opened.pair.probe().soup);
  stage.fixed_surface = make_surface(opened.pair.fixed().soup);
  stage.probe_defects = defects_of(opened.pair.probe());
  stage.fixed_defects = defects_of(opened.pair.fixed());
  stage.session = std::make_unique<Session>(std::move(opened));
  return stage;
}

}  // namespace sonde::ui
