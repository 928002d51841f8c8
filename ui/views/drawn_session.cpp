// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/drawn_session.hpp"

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

DrawnSession draw_session(LoadedScene loaded) {
  DrawnSession drawn;
  drawn.probe_surface = make_surface(loaded.pair.probe().soup);
  drawn.fixed_surface = make_surface(loaded.pair.fixed().soup);
  drawn.probe_defects = defects_of(loaded.pair.probe());
  drawn.fixed_defects = defects_of(loaded.pair.fixed());
  drawn.session = std::make_unique<Session>(std::move(loaded));
  return drawn;
}

}  // namespace sonde::ui
