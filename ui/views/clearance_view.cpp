// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/clearance_view.hpp"

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double end_pixels = 3.5;
constexpr double room_pixels = 1.6;

}  // namespace

ClearanceView::ClearanceView(vtkRenderer& renderer, GlyphShapes& shapes)
    : on_probe_(renderer, shapes, colour::clearance),
      on_fixed_(renderer, shapes, colour::clearance),
      line_(renderer, shapes, colour::clearance) {}

void ClearanceView::draw(const Frame& frame) {
  hide();
  if (!frame.clearance || !(frame.clearance->distance > 0)) return;
  const GaugedClearance& room = *frame.clearance;
  on_probe_.set(room.on_probe, end_pixels * frame.pixel);
  on_fixed_.set(room.on_fixed, end_pixels * frame.pixel);
  line_.set(room.on_fixed, room.on_probe, room_pixels * frame.pixel, false);
  label(0.5 * (room.on_probe + room.on_fixed),
        QStringLiteral("%1 clear").arg(frame.unit.text(room.distance)), colour::clearance,
        {room.on_fixed, room.on_probe});
}

void ClearanceView::hide() {
  on_probe_.hide();
  on_fixed_.hide();
  line_.hide();
}

}  // namespace sonde::ui
