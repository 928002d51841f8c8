// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/handle_view.hpp"

#include "ui/document/handles.hpp"

namespace sonde::ui {
namespace {

constexpr double shaft_pixels = 1.6;
constexpr double handle_ring_pixels = 1.1;

struct Axis {
  const char* name;
  QColor colour;
};
const std::array<Axis, 3>& axes() {
  static const std::array<Axis, 3> all{
      {{"x", QColor(240, 110, 90)}, {"y", QColor(120, 205, 110)}, {"z", QColor(110, 160, 255)}}};
  return all;
}

}  // namespace

HandleView::HandleView(vtkRenderer& renderer, GlyphShapes& shapes) {
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    arrows_.at(i) = std::make_unique<Arrow>(renderer, shapes, axes().at(i).colour);
    rings_.at(i) = std::make_unique<Arc>(renderer, shapes, axes().at(i).colour);
  }
}

void HandleView::draw(const Frame& frame) {
  const Handles handles =
      handles_at(frame.snapshot.separation.device, frame.mass.com, local_, pixels * frame.pixel);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Vec3 axis = handles.axes.col(i);
    const Vec3 tip = handles.centre + axis * handles.length;
    arrows_.at(at)->set(handles.centre, tip, shaft_pixels * frame.pixel);
    rings_.at(at)->set(handles.centre, axis,
                       handles.axes.col((i + 1) % 3) * handles.length * ring_part, ring_angle,
                       handle_ring_pixels * frame.pixel);
    label(tip, QLatin1String(axes().at(at).name), axes().at(at).colour);
  }
}

void HandleView::hide() {
  for (const auto& arrow : arrows_) arrow->hide();
  for (const auto& ring : rings_) ring->hide();
}

}  // namespace sonde::ui
