// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// A picked point on a body; it moves with the body.
struct MeasuredPoint {
  bool on_probe = false;
  Vec3 x = Vec3::Zero();  ///< in that body's mesh frame, m
  double gap = 0;         ///< to the other body when it was picked, m
};

/// The picked points. For one: where it is and how far from the other body. For two: their
/// distance.
class MeasureView : public Overlay {
 public:
  static constexpr std::size_t most = 2;
  MeasureView(vtkRenderer& renderer, GlyphShapes& shapes);
  /// After two points it starts over.
  void add(const MeasuredPoint& point);
  void clear() { points_.clear(); }
  const std::vector<MeasuredPoint>& points() const { return points_; }

 private:
  void draw(const Frame& frame) override;
  void hide() override;

  std::array<std::unique_ptr<Ball>, most> balls_;
  Arrow line_;
  std::vector<MeasuredPoint> points_;
};

}  // namespace sonde::ui
