// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <QColor>
#include <optional>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/scene/scene_body.hpp"

class vtkPolyData;

namespace sonde::ui {

/// How one part of a body is drawn.
struct PartLook {
  QColor colour;
  bool shown = true;
  bool operator==(const PartLook&) const = default;
};
/// Of each part of a body: the colours that it names, or one of a few in turn. The `chosen` part is
/// lighter.
std::vector<PartLook> looks_of(const SceneBody& body, std::optional<std::size_t> chosen = {});
/// The colour of that part, as no part is chosen.
QColor part_colour(const SceneBody& body, std::size_t part);

/// The parts of a body as they are drawn, one behind the other in one surface.
struct PartSurface {
  vtkSmartPointer<vtkPolyData> all;
  std::vector<vtkIdType> first_point, first_cell;  ///< of each part, and behind the last
};
/// Slow for large meshes: call it in a worker.
PartSurface make_part_surface(const std::vector<BodyPart>& parts);
/// The parts that are shown, in their colours: points and normals are shared, so that one actor
/// draws them as it does one mesh. Some ms for a million triangles.
vtkSmartPointer<vtkPolyData> shown_parts(const PartSurface& parts,
                                         const std::vector<PartLook>& looks);

}  // namespace sonde::ui
