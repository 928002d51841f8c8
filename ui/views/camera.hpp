// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QSize>
#include <vector>

#include "engine/geometry/pose.hpp"

class vtkCamera;

namespace sonde::ui {

/// The axes of the picture: unit vectors in the fixed body's mesh frame.
struct ViewAxes {
  Vec3 right;
  Vec3 up;
  Vec3 towards;  ///< out of the picture, to the eye
};

/// The camera of the view, moved by the mouse. Angles in radians.
class Camera {
 public:
  explicit Camera(vtkCamera& camera) : camera_(&camera) {}

  ViewAxes axes() const;
  Vec3 eye() const;
  Vec3 target() const;

  /// Parallel lines stay parallel, whatever their depth; what is looked at keeps its size.
  void set_parallel(bool on);
  bool parallel() const;
  /// Of the eye from what it looks at, as the size on screen has it; m.
  double distance() const;

  /// Metres per pixel at a point, in a picture of the given height.
  double metres_per_pixel(const Vec3& at, int height) const;

  void look_at(const Vec3& target, const Vec3& direction, const Vec3& up, double distance);
  /// Keeps its direction and shows all points, as large as they fit, in a part of a picture of that
  /// size (pixels, from the upper left). Returns the distance of the eye from the point it looks
  /// at.
  double frame(const std::vector<Vec3>& points, const QSize& picture, const QRectF& part);
  /// The scene turns with the cursor: about the picture's up and right axes.
  void orbit(double about_up, double about_right);
  void pan(const Vec3& shift);
  void zoom(double factor);
  /// Sets the clipping planes around a ball.
  void clip_to(const Vec3& centre, double radius);

 private:
  vtkCamera* camera_;  ///< owned by the renderer
};

}  // namespace sonde::ui
