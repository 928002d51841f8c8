// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// The witness of the lower bound: a point deep in both bodies together, and a ball about it, drawn
/// as three rings. Whatever motion separates the bodies, the probe's point leaves that ball.
class WitnessView : public Overlay {
 public:
  WitnessView(vtkRenderer& renderer, GlyphShapes& shapes);

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  Ball point_;
  std::array<Arc, 3> rings_;
};

}  // namespace sonde::ui
