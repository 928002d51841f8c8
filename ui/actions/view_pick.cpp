// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/view_pick.hpp"

#include <QMouseEvent>
#include <cmath>

#include "ui/views/cut_view.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr double still = 4;  // pixels: who moves further has dragged

double length(QPointF by) { return std::hypot(by.x(), by.y()); }

}  // namespace

ViewPick::ViewPick(Viewport& viewport, QObject* parent) : QObject(parent), viewport_(viewport) {
  viewport.canvas()->installEventFilter(this);
}

bool ViewPick::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return release(*static_cast<QMouseEvent*>(event));
    default:
      return QObject::eventFilter(watched, event);
  }
}

bool ViewPick::press(const QMouseEvent& event) {
  grip_.reset();
  pressed_ = event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier;
  if (!pressed_) return false;
  from_ = last_ = event.localPos();
  if (const auto handles = viewport_.cut_handles()) {
    grip_ = grip_at(
        *handles, [this](const Vec3& x) { return viewport_.on_screen(x); }, from_);
    if (grip_ && !CutView::draws(*grip_)) grip_.reset();
  }
  if (grip_ || measuring_) viewport_.canvas()->setFocus(Qt::MouseFocusReason);
  return grip_ || measuring_;
}

bool ViewPick::move(const QMouseEvent& event) {
  if (!pressed_) return false;
  const QPointF by = event.localPos() - last_;
  last_ = event.localPos();
  if (grip_) drag_cut(by);
  return grip_ || measuring_;
}

bool ViewPick::release(const QMouseEvent& event) {
  if (!pressed_ || event.button() != Qt::LeftButton) return false;
  pressed_ = false;
  const bool taken = grip_ || measuring_;
  if (!grip_ && length(event.localPos() - from_) < still) {
    if (measuring_) emit picked(from_);
    if (!measuring_) emit clicked(from_);
  }
  grip_.reset();
  return taken;
}

void ViewPick::drag_cut(QPointF by) {
  const auto handles = viewport_.cut_handles();
  if (!handles) return;
  const auto on_screen = [this](const Vec3& x) { return viewport_.on_screen(x); };
  const double far = follow(*handles, *grip_, on_screen, by);
  const Vec3 axis = handles->axes.col(grip_->axis);
  if (!grip_->turns) {
    emit cut_moved(far);
    return;
  }
  grip_->at = handles->centre + Eigen::AngleAxisd(far, axis) * (grip_->at - handles->centre);
  emit cut_turned(axis * far);
}

}  // namespace sonde::ui
