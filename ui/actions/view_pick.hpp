// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

#include "ui/document/handles.hpp"

class QMouseEvent;

namespace sonde::ui {

class Viewport;

/// The actions of the left button in the view before it moves the probe: it grabs the cut plane,
/// picks points while measuring, and chooses a clicked contact.
class ViewPick : public QObject {
 public:
  /// To be made after what moves the probe: it sees the mouse first.
  ViewPick(Viewport& viewport, QObject* parent);

  /// Clicks pick points, and the probe stays.
  void set_measuring(bool on) { measuring_ = on; }
  bool measuring() const { return measuring_; }

  std::function<void(QPointF)> picked;               ///< a point to measure
  std::function<void(QPointF)> clicked;              ///< neither dragged nor measured
  std::function<void(double along)> cut_moved;       ///< m along its normal
  std::function<void(const Vec3& turn)> cut_turned;  ///< axis times angle

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void drag_cut(QPointF by);

  Viewport& viewport_;
  bool measuring_ = false;
  bool pressed_ = false;
  std::optional<Grip> grip_;
  QPointF from_, last_;
};

}  // namespace sonde::ui
