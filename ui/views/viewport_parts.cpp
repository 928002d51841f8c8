// SPDX-License-Identifier: GPL-3.0-or-later
// What a Viewport draws of the bodies' meshes: the parts of the fixed one, and how finely.

#include <vtkOutlineSource.h>
#include <vtkPolyDataMapper.h>

#include <algorithm>

#include "engine/geometry/transform.hpp"
#include "ui/views/scenery.hpp"

namespace sonde::ui {
namespace {

Eigen::AlignedBox3d box_of(const Body& body) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : body.soup.triangles)
    for (const auto index : triangle) box.extend(body.soup.vertices[index]);
  return box;
}

}  // namespace

void Viewport::simplify_surfaces() {
  Scenery& s = *scenery_;
  const int small = s.software_drawn ? simplify_above : simplify_above_on_card;
  s.detail.clear();
  s.detail.add(*s.fixed_surface, small, {s.fixed_actor});
  s.detail.add(*s.probe_surface, small,
               {&s.probe->actor(), &s.ghost->actor(), &s.nearest->actor(), &s.straight->actor()});
}

/// Where the bodies are: what is felt of the fixed one, and what is only shown.
void Viewport::measure_scene() {
  Scenery& s = *scenery_;
  s.probe_box = box_of(s.pair->probe());
  s.fixed_box = box_of(s.pair->fixed());
  s.radius = s.pair->fixed().mass.radius;
  if (!s.parts.empty() && s.fixed_surface->GetNumberOfPolys() > 0) {
    double b[6];
    s.fixed_surface->GetCellsBounds(b);
    const Eigen::AlignedBox3d shown(Vec3(b[0], b[2], b[4]), Vec3(b[1], b[3], b[5]));
    s.fixed_box.extend(shown);
    for (int i = 0; i < 8; ++i)
      s.radius = std::max(
          s.radius, (Vec3(shown.corner(Eigen::AlignedBox3d::CornerType(i))) - s.centre).norm());
  }
  s.grid.set(s.fixed_box, s.q_FW);
}

vtkSmartPointer<vtkPolyData> Viewport::show_parts(const std::vector<PartLook>& looks) {
  Scenery& s = *scenery_;
  if (s.parts.empty() || looks.size() != s.parts.size()) return nullptr;
  if (looks == s.part_looks) return s.fixed_surface;
  s.part_looks = looks;
  s.fixed_surface = shown_parts(s.part_surface, looks);
  s.detail.clear();  // the actor has its own mapper again
  auto* mapper = vtkPolyDataMapper::SafeDownCast(s.fixed_actor->GetMapper());
  mapper->SetInputData(s.fixed_surface);
  simplify_surfaces();
  measure_scene();
  show_sections();
  invalidate();
  return s.fixed_surface;
}

void Viewport::choose_part(std::optional<std::size_t> part) {
  Scenery& s = *scenery_;
  const bool any = part && *part < s.parts.size();
  s.part_box->SetVisibility(any);
  invalidate();
  if (!any) return;
  Eigen::AlignedBox3d box;
  const Transform X(s.parts[*part].X_BP);
  for (const Vec3& x : s.parts[*part].body->soup.vertices) box.extend(X * x);
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(),
                     box.max().z());
  outline->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(outline->GetOutput());
  s.part_box->SetMapper(mapper);
}

}  // namespace sonde::ui
