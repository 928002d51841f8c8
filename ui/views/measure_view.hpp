// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ui/views/glyphs.hpp"
#include "ui/views/overlay.hpp"

namespace sonde::ui {

/// A point that was picked on a body, with which it moves.
struct MeasuredPoint {
  bool on_probe = false;
  Vec3 x = Vec3::Zero();  ///< in that body's mesh frame, m
  double gap = 0;         ///< to the other body when it was picked, m
};

/// Points that were picked: of one, where it is and how far from the other body; of two, how far
/// apart they are.
class MeasureView : public Overlay {
 public:
  static constexpr std::size_t most = 2;
  MeasureView(vtkRenderer& renderer, GlyphShapes& shapes);
  /// Beyond two, it begins anew.
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
