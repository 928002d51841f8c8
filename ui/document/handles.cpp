// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/handles.hpp"

#include <cmath>
#include <numbers>

namespace sonde::ui {
namespace {

constexpr double near_enough = 9;   // pixels
constexpr double free_part = 0.25;  // of an arrow, next to the centre: there they all meet
constexpr double least_motion = 8;  // pixels on screen of a whole arrow: less points at the eye
constexpr int points_of_ring = 96;
constexpr int points_of_arrow = 24;

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// How far the cursor has gone along a motion on screen, as a part of it.
double share_along(QPointF by, QPointF motion) {
  return (by.x() * motion.x() + by.y() * motion.y()) /
         (motion.x() * motion.x() + motion.y() * motion.y());
}

}  // namespace

Handles handles_at(const Pose& X_FM, const Vec3& com, bool local, double length) {
  return {X_FM * com, local ? X_FM.q.toRotationMatrix() : Mat3(Mat3::Identity()), length};
}

std::optional<Grip> grip_at(const Handles& handles, const Projection& on_screen, QPointF cursor) {
  std::optional<Grip> best;
  double nearest = near_enough;
  const auto try_point = [&](bool turns, Eigen::Index axis, const Vec3& point) {
    const double away = distance(on_screen(point), cursor);
    if (away >= nearest) return;
    nearest = away;
    best = Grip{turns, axis, point};
  };
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Vec3 along = handles.axes.col(axis) * handles.length;
    for (int i = 0; i <= points_of_arrow; ++i) {
      const double part = free_part + (1 - free_part) * i / points_of_arrow;
      try_point(false, axis, handles.centre + along * part);
    }
    const Vec3 one = handles.axes.col((axis + 1) % 3) * handles.length * ring_part;
    const Vec3 other = handles.axes.col((axis + 2) % 3) * handles.length * ring_part;
    for (int i = 0; i < points_of_ring; ++i) {
      const double angle = 2 * std::numbers::pi * i / points_of_ring;
      try_point(true, axis, handles.centre + one * std::cos(angle) + other * std::sin(angle));
    }
  }
  return best;
}

double follow(const Handles& handles, const Grip& grip, const Projection& on_screen, QPointF by) {
  const Vec3 axis = handles.axes.col(grip.axis);
  if (!grip.turns) {
    const QPointF motion =
        on_screen(handles.centre + axis * handles.length) - on_screen(handles.centre);
    if (std::hypot(motion.x(), motion.y()) < least_motion) return 0;
    return share_along(by, motion) * handles.length;
  }
  // A ring seen from its edge moves to and fro: what counts is the way it goes where it was taken.
  constexpr double little = 0.05;  // rad
  const Vec3 arm = grip.at - handles.centre;
  const Vec3 moved = handles.centre + Eigen::AngleAxisd(little, axis) * arm;
  const QPointF motion = on_screen(moved) - on_screen(grip.at);
  if (std::hypot(motion.x(), motion.y()) < little * least_motion) return 0;
  return share_along(by, motion) * little;
}

}  // namespace sonde::ui
