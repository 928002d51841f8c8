// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "ui/document/handles.hpp"

class QMouseEvent;

namespace sonde::ui {

class Viewport;

/// The actions of the left button in the view before it moves the probe: it grabs the cut plane,
/// picks points while measuring, and chooses a clicked contact.
class ViewPick : public QObject {
  Q_OBJECT
 public:
  /// To be made after what moves the probe: it sees the mouse first.
  ViewPick(Viewport& viewport, QObject* parent);

  /// Clicks pick points, and the probe stays.
  void set_measuring(bool on) { measuring_ = on; }
  bool measuring() const { return measuring_; }

 signals:
  void picked(QPointF at);            ///< a point to measure
  void clicked(QPointF at);           ///< neither dragged nor measured
  void cut_moved(double along);       ///< m along its normal
  void cut_turned(const Vec3& turn);  ///< axis times angle

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
