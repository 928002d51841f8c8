// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/drawn_bodies.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/defect_edges.hpp"
#include "engine/mending/edge_uses.hpp"
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

/// The edges of one cap triangle alone are those of the openings.
CapSurface caps_of(const Body& body) {
  if (body.caps.triangles.empty()) return {};
  std::vector<DefectEdges::Edge> border;
  for_each_edge(edge_uses(body.caps), [&](std::span<const EdgeUse> edge) {
    if (edge.size() % 2 == 1) border.push_back({edge[0].low, edge[0].high});
  });
  return {make_surface(body.caps), lines_of(body.caps, border)};
}

}  // namespace

DrawnBodies draw_bodies(const LoadedScene& loaded) {
  const Body &probe = loaded.pair.probe(), &fixed = loaded.pair.fixed();
  PartSurface parts;
  if (!loaded.parts.empty()) parts = make_part_surface(loaded.parts);
  return {.pair = loaded.pair,
          .first = loaded.here.value_or(loaded.start),
          .q_FW = loaded.scene.fixed.pose.q.conjugate(),
          .coupling = loaded.coupling,
          .camera = loaded.camera,
          .probe_surface = make_surface(probe.soup),
          .fixed_surface = loaded.parts.empty() ? make_surface(fixed.soup)
                                                : shown_parts(parts, looks_of(loaded.scene.fixed)),
          .probe_defects = defects_of(probe),
          .fixed_defects = defects_of(fixed),
          .probe_caps = caps_of(probe),
          .fixed_caps = caps_of(fixed),
          .parts = loaded.parts,
          .part_looks = looks_of(loaded.scene.fixed),
          .part_surface = std::move(parts)};
}

}  // namespace sonde::ui
