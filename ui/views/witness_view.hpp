// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// What shows the lower bound: a point deep in the two bodies together, and a ball about it, as
/// three rings. Whatever the motion that separates them, the probe's point comes out of that ball.
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
