// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

#include "engine/geometry/mass.hpp"
#include "engine/geometry/pose.hpp"
#include "ui/devices/nudge.hpp"
#include "ui/document/handles.hpp"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace sonde::ui {

class Viewport;

/// All six degrees of freedom of the probe from mouse and keyboard, and the camera from the other
/// buttons. HintView::keys() explains them to the user.
///
/// The probe follows the cursor: a drag across the picture moves it as far as the cursor, at its
/// depth, times the gain. It turns about its centre of mass.
class MouseProbe : public QObject {
  Q_OBJECT
 public:
  MouseProbe(Viewport& viewport, QObject* parent);

  /// Takes over a probe at its present pose.
  void take(const MassProperties& mass, const Pose& X_FM);
  void set_gain(double gain) { gain_ = gain; }
  /// What keys do; the gain is that of the mouse alone.
  void set_nudge(const Nudge& nudge) { nudge_ = nudge; }

 signals:
  /// With each new device pose.
  void moved(const Pose& X_FM);
  /// A drag that began at that pose has ended, or a key or the wheel has moved the probe a step
  /// from there: many of those in quick succession are one motion.
  void settled(const Pose& before, bool one_of_many);
  void say(const QString& what);  ///< in passing

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  bool drag(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  void settle();
  void step(const std::function<void()>& move);
  void drag_probe(QPointF by, QPointF at, Qt::KeyboardModifiers modifiers);
  void drag_handle(QPointF by);
  void drag_camera(QPointF by);
  void pan_camera(QPointF by);
  void translate(const Vec3& by);
  /// About the centre of mass; the vector is axis times angle.
  void rotate(const Vec3& by);
  Vec3 com() const { return pose_ * mass_.com; }

  Viewport& viewport_;
  MassProperties mass_;
  Pose pose_;
  std::optional<Pose> before_;  ///< where the drag began that is going on
  std::optional<Grip> grip_;    ///< of a handle that is being dragged
  QPointF last_;
  double gain_ = 1;
  Nudge nudge_;
};

}  // namespace sonde::ui
