// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/nudge.hpp"

#include <limits>

#include "ui/views/camera.hpp"

namespace sonde::ui {
namespace {

constexpr double steep = 0.5;  // of an axis, in the face: what is less is all but its normal
/// Of the line of sight: a direction that is seen end on counts as right, or up, if it goes away.
constexpr double end_on = 0.01;

Mat3 axes_of_face(const Vec3& normal, const Mat3& body, const ViewAxes& view) {
  const Vec3 rightwards = view.right - end_on * view.towards;
  const Vec3 upwards = view.up - end_on * view.towards;
  Vec3 right = Vec3::Zero();
  double best = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) {
      const Vec3 axis = sign * body.col(i);
      const Vec3 in_face = axis - normal * normal.dot(axis);
      if (in_face.norm() < steep) continue;
      const double agrees = in_face.normalized().dot(rightwards);
      if (agrees > best) best = agrees, right = in_face.normalized();
    }
  Vec3 up = normal.cross(right);
  if (up.dot(upwards) < 0) up = -up;
  Mat3 axes;
  axes << right, up, normal;
  return axes;
}

}  // namespace

std::optional<Mat3> nudge_axes(const Nudge& nudge, const Pose& X_FM, const ViewAxes& view) {
  switch (nudge.axes) {
    case Nudge::Axes::fixed:
      return Mat3(Mat3::Identity());
    case Nudge::Axes::probe:
      return X_FM.q.toRotationMatrix();
    case Nudge::Axes::world:
      return nudge.q_FW.toRotationMatrix();
    case Nudge::Axes::face: {
      if (!nudge.face) return std::nullopt;
      const Mat3 body = nudge.face->on_probe ? X_FM.q.toRotationMatrix() : Mat3(Mat3::Identity());
      return axes_of_face(body * nudge.face->normal, body, view);
    }
    case Nudge::Axes::picture:
      break;
  }
  Mat3 axes;
  axes << view.right, view.up, -view.towards;
  return axes;
}

}  // namespace sonde::ui
