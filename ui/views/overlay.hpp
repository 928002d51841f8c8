// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <utility>
#include <vector>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/clearance_gauge.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/penetration/search/pair.hpp"
#include "ui/base/format.hpp"
#include "ui/views/force_note.hpp"

namespace sonde::ui {

/// The content of one picture. Everything is in the fixed body's mesh frame, metres.
struct Frame {
  const Snapshot& snapshot;
  const MassProperties& mass;  ///< the probe's
  const LengthUnit& unit;
  double pixel = 0;  ///< metres per pixel at the probe: glyphs keep their size on screen
  double swing = 1;  ///< where the ghost is on its way from O (0) to Q (1)
  const BackgroundResult* searched = nullptr;  ///< of this device pose; null: not yet
  /// Pixels that OpenGL draws for one of `pixel`: 2 on a screen of twice the usual density, more in
  /// a large picture for a file. VTK's widths of lines are OpenGL's.
  float density = 1;
  const GaugedClearance* clearance =
      nullptr;                 ///< at this device pose; null: it is held, or not known
  const Pair* pair = nullptr;  ///< null: there is no session
};

/// Text at a point of the scene, and the line that leads there: an arrow, an arc. Without text, the
/// line alone: no other label may lie on it.
struct Label {
  Vec3 at;
  QString text;
  QColor colour;
  std::vector<Vec3> stroke{};
  ForceNote note{};  ///< below the text
};

/// Draws something from a snapshot. It makes its actors once and hides them while there is nothing
/// to show.
class Overlay {
 public:
  Overlay() = default;
  virtual ~Overlay() = default;
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  void show(const Frame& frame) {
    labels_.clear();
    if (visible_)
      draw(frame);
    else
      hide();
  }
  void set_visible(bool visible) { visible_ = visible; }
  bool visible() const { return visible_; }
  const std::vector<Label>& labels() const { return labels_; }

 protected:
  virtual void draw(const Frame& frame) = 0;
  virtual void hide() = 0;
  void label(const Vec3& at, const QString& text, const QColor& colour,
             std::vector<Vec3> stroke = {}, ForceNote note = {}) {
    labels_.push_back({at, text, colour, std::move(stroke), std::move(note)});
  }

 private:
  bool visible_ = true;
  std::vector<Label> labels_;
};

}  // namespace sonde::ui
