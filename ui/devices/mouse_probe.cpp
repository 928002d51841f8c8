// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/mouse_probe.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr double wheel_step = 0.02;  // of the probe's radius, a notch
constexpr double notch = 120;        // Qt's units of a wheel's click
constexpr double zoom_per_notch = 1.15;
constexpr double roll_dead_zone = 12;  // pixels; nearer to the centre the angle is all noise

}  // namespace

MouseProbe::MouseProbe(Viewport& viewport, QObject* parent) : QObject(parent), viewport_(viewport) {
  viewport.canvas()->installEventFilter(this);
}

void MouseProbe::take(const MassProperties& mass, const Pose& X_FM) {
  mass_ = mass;
  pose_ = X_FM;
}

bool MouseProbe::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return drag(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) settle();
      return true;
    case QEvent::MouseButtonDblClick:
    case QEvent::ContextMenu:
      return true;
    case QEvent::Wheel:
      return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::KeyPress:
      return key(*static_cast<QKeyEvent*>(event));
    default:
      return QObject::eventFilter(watched, event);
  }
}

bool MouseProbe::press(const QMouseEvent& event) {
  viewport_.canvas()->setFocus(Qt::MouseFocusReason);
  last_ = event.localPos();
  settle();  // of a drag whose end somebody else got
  if (event.button() != Qt::LeftButton) return true;
  before_ = pose_;
  const auto handles = viewport_.handles(pose_);
  if (handles && event.modifiers() == Qt::NoModifier)
    grip_ = grip_at(
        *handles, [this](const Vec3& x) { return viewport_.on_screen(x); }, last_);
  return true;
}

void MouseProbe::drag_handle(QPointF by) {
  const auto handles = viewport_.handles(pose_);
  if (!handles) return;
  const auto on_screen = [this](const Vec3& x) { return viewport_.on_screen(x); };
  const double far = follow(*handles, *grip_, on_screen, by);
  const Vec3 axis = handles->axes.col(grip_->axis);
  if (!grip_->turns) return translate(axis * far);
  rotate(axis * far);
  grip_->at = handles->centre + Eigen::AngleAxisd(far, axis) * (grip_->at - handles->centre);
}

void MouseProbe::settle() {
  grip_.reset();
  const std::optional<Pose> before = std::exchange(before_, std::nullopt);
  if (!before || (before->p == pose_.p && before->q.coeffs() == pose_.q.coeffs())) return;
  emit settled(*before, false);
}

void MouseProbe::step(const std::function<void()>& move) {
  const Pose before = pose_;
  move();
  if (!before_) emit settled(before, true);
}

bool MouseProbe::drag(const QMouseEvent& event) {
  const QPointF by = event.localPos() - last_;
  last_ = event.localPos();
  if (event.buttons() & Qt::LeftButton && grip_)
    drag_handle(by);
  else if (event.buttons() & Qt::LeftButton)
    drag_probe(by, last_, event.modifiers());
  else if (event.buttons() & Qt::RightButton)
    drag_camera(by);
  else if (event.buttons() & Qt::MiddleButton)
    pan_camera(by);
  return true;
}

void MouseProbe::drag_probe(QPointF by, QPointF at, Qt::KeyboardModifiers modifiers) {
  const ViewAxes view = viewport_.camera().axes();
  const double side = std::max(std::min(viewport_.width(), viewport_.height()), 1);
  if (modifiers & Qt::ControlModifier) {
    const QPointF centre = viewport_.on_screen(com());
    const QPointF now = at - centre, before = now - by;
    if (std::hypot(now.x(), now.y()) < roll_dead_zone) return;
    // The screen's y points down: its angles run the other way.
    const double angle = std::atan2(before.y(), before.x()) - std::atan2(now.y(), now.x());
    rotate(view.towards * std::remainder(angle, 2 * std::numbers::pi));
  } else if (modifiers & Qt::ShiftModifier) {
    // Across the whole picture: half a turn. What faces the eye follows the cursor.
    rotate((view.up * by.x() + view.right * by.y()) * (std::numbers::pi / side) * gain_);
  } else {
    const double scale = viewport_.metres_per_pixel(com()) * gain_;
    translate((view.right * by.x() - view.up * by.y()) * scale);
  }
}

void MouseProbe::drag_camera(QPointF by) {
  const double side = std::max(std::min(viewport_.width(), viewport_.height()), 1);
  const double scale = std::numbers::pi / side;
  viewport_.camera().orbit(by.x() * scale, by.y() * scale);
  viewport_.invalidate();
}

void MouseProbe::pan_camera(QPointF by) {
  Camera camera = viewport_.camera();
  const ViewAxes view = camera.axes();
  const double scale = viewport_.metres_per_pixel(camera.target());
  camera.pan((view.up * by.y() - view.right * by.x()) * scale);
  viewport_.invalidate();
}

bool MouseProbe::wheel(const QWheelEvent& event) {
  const double notches = event.angleDelta().y() / notch;
  if (notches == 0) return true;
  if (event.modifiers() & Qt::ControlModifier) {
    viewport_.camera().zoom(std::pow(zoom_per_notch, notches));
    viewport_.invalidate();
  } else {
    const Vec3 away = -viewport_.camera().axes().towards;
    step([&] { translate(away * (notches * wheel_step * mass_.radius * gain_)); });
  }
  return true;
}

bool MouseProbe::key(const QKeyEvent& event) {
  struct Key {
    int key;
    Eigen::Index axis;
    int sign;
  };
  static constexpr Key keys[] = {{Qt::Key_Left, 0, -1},     {Qt::Key_Right, 0, 1},
                                 {Qt::Key_Down, 1, -1},     {Qt::Key_Up, 1, 1},
                                 {Qt::Key_PageDown, 2, -1}, {Qt::Key_PageUp, 2, 1}};
  const auto* const pressed = std::ranges::find(keys, event.key(), &Key::key);
  if (pressed == std::end(keys)) return false;
  const std::optional<Mat3> found = nudge_axes(nudge_, pose_, viewport_.camera().axes());
  if (!found) {
    emit say(QStringLiteral("The arrow keys go along a face: click on one first."));
    return true;
  }
  const Mat3& axes = *found;
  const Vec3 along = pressed->sign * axes.col(pressed->axis);
  step([&] {
    if (!(event.modifiers() & Qt::ShiftModifier)) return translate(along * nudge_.step);
    if (nudge_.axes != Nudge::Axes::picture) return rotate(along * nudge_.turn);
    // In the picture what faces the eye goes where the arrow points: about the other axis.
    const Vec3 about[] = {pressed->sign * axes.col(1), -pressed->sign * axes.col(0),
                          -pressed->sign * axes.col(2)};
    rotate(about[pressed->axis] * nudge_.turn);
  });
  return true;
}

void MouseProbe::translate(const Vec3& by) {
  pose_.p += by;
  emit moved(pose_);
}

void MouseProbe::rotate(const Vec3& by) {
  const double angle = by.norm();
  if (!(angle > 0)) return;
  const Vec3 centre = com();
  pose_.q = (Quat(Eigen::AngleAxisd(angle, by / angle)) * pose_.q).normalized();
  pose_.p = centre - pose_.q * mass_.com;
  emit moved(pose_);
}

}  // namespace sonde::ui
