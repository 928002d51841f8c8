// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/camera.hpp"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sonde::ui {
namespace {

using Vec2 = Eigen::Vector2d;

double half_angle(vtkCamera& camera) {
  return camera.GetViewAngle() * std::numbers::pi / 360;  // half, and degrees to radians
}

}  // namespace

ViewAxes Camera::axes() const {
  double up[3];
  camera_->GetViewUp(up);
  const Vec3 towards = (eye() - target()).normalized();
  const Vec3 right = Vec3(up).cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

Vec3 Camera::eye() const { return Vec3(camera_->GetPosition()); }
Vec3 Camera::target() const { return Vec3(camera_->GetFocalPoint()); }

/// Where lines are parallel the scale tells it: the eye itself may stand anywhere on its line.
double Camera::distance() const {
  return parallel() ? camera_->GetParallelScale() / std::tan(half_angle(*camera_))
                    : (eye() - target()).norm();
}

bool Camera::parallel() const { return camera_->GetParallelProjection() != 0; }

void Camera::set_parallel(bool on) {
  if (on == parallel()) return;
  const double now = distance();
  camera_->SetParallelProjection(on);
  look_at(target(), axes().towards, axes().up, now);
}

double Camera::metres_per_pixel(const Vec3& at, int height) const {
  const double depth = parallel() ? distance() : (eye() - at).dot(axes().towards);
  // A point behind the eye has no scale; that of a near point keeps drags finite.
  const double nearest = 1e-3 * distance();
  return 2 * std::max(depth, nearest) * std::tan(half_angle(*camera_)) / std::max(height, 1);
}

void Camera::look_at(const Vec3& target, const Vec3& direction, const Vec3& up, double distance) {
  const Vec3 eye = target + direction.normalized() * distance;
  camera_->SetFocalPoint(target.data());
  camera_->SetPosition(eye.data());
  camera_->SetViewUp(up.data());
  camera_->OrthogonalizeViewUp();
  camera_->SetParallelScale(distance * std::tan(half_angle(*camera_)));
}

double Camera::frame(const std::vector<Vec3>& points, const QSize& picture, const QRectF& part) {
  if (points.empty()) return 0;
  constexpr double room = 1.14;  // for arrows and labels
  const ViewAxes view = axes();
  const Vec2 slope = std::tan(half_angle(*camera_)) / std::max(picture.height(), 1) *
                     Vec2(part.width(), part.height());
  const double depth_counts = parallel() ? 0 : 1;
  Vec3 middle = Eigen::AlignedBox3d(points.front()).center();
  double distance = 0;
  // Nearer points reach further out on screen: the middle of the picture is found in a few rounds.
  for (int round = 0; round < 6; ++round) {
    distance = 0;
    for (const Vec3& point : points) {
      const Vec3 x = point - middle;
      const Vec2 aside = Vec2(x.dot(view.right), x.dot(view.up)).cwiseAbs().cwiseQuotient(slope);
      distance = std::max(distance, depth_counts * x.dot(view.towards) + room * aside.maxCoeff());
    }
    Eigen::AlignedBox2d on_screen;
    for (const Vec3& point : points) {
      const Vec3 x = point - middle;
      const double depth = std::max(distance - depth_counts * x.dot(view.towards), 1e-6 * distance);
      on_screen.extend(Vec2(x.dot(view.right), x.dot(view.up)) / depth);
    }
    const Vec2 off = on_screen.center() * distance;
    middle += view.right * off.x() + view.up * off.y();
  }
  distance = std::max(distance, 1e-9);
  look_at(middle, view.towards, view.up, distance);
  // What is looked at goes to the middle of the part: the picture is shifted, not the eye. VTK's
  // unit is half a picture, upwards, and says where the picture's middle is seen from there.
  camera_->SetWindowCenter(1 - 2 * part.center().x() / std::max(picture.width(), 1),
                           2 * part.center().y() / std::max(picture.height(), 1) - 1);
  return distance;
}

void Camera::orbit(double about_up, double about_right) {
  const ViewAxes view = axes();
  const double distance = this->distance();
  // The eye goes the other way, so that the scene seems to follow the cursor.
  const Quat turn(Eigen::AngleAxisd(-about_up, view.up) *
                  Eigen::AngleAxisd(-about_right, view.right));
  look_at(target(), turn * view.towards, turn * view.up, distance);
}

void Camera::pan(const Vec3& shift) {
  const Vec3 eye_now = eye() + shift;
  const Vec3 target_now = target() + shift;
  camera_->SetPosition(eye_now.data());
  camera_->SetFocalPoint(target_now.data());
}

void Camera::zoom(double factor) {
  look_at(target(), axes().towards, axes().up, distance() / factor);
}

void Camera::clip_to(const Vec3& centre, double radius) {
  // With parallel lines the eye may step back to see all of it: nothing else changes.
  const double behind = (eye() - centre).dot(axes().towards) - 1.1 * radius;
  if (parallel() && behind < 0) {
    const Vec3 back = eye() - behind * axes().towards;
    camera_->SetPosition(back.data());
  }
  const double depth = (eye() - centre).dot(axes().towards);
  const double far = depth + radius;
  const double span = std::max(far, radius);
  camera_->SetClippingRange(std::max(depth - radius, 2e-3 * span), span * 1.01);
}

}  // namespace sonde::ui
