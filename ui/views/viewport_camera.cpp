// SPDX-License-Identifier: GPL-3.0-or-later
// Where a Viewport looks from, and where what it shows is on the screen.

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/document/view_direction.hpp"
#include "ui/views/scenery.hpp"

namespace sonde::ui {
namespace {

constexpr double least_area = 120;  // pixels: in less there is nothing to be seen

double aspect_of(const QSize& size) { return double(size.width()) / std::max(size.height(), 1); }

void add_corners(std::vector<Vec3>& points, const Eigen::AlignedBox3d& box, const Pose& pose) {
  if (box.isEmpty()) return;
  for (int i = 0; i < 8; ++i)
    points.push_back(pose * Vec3(box.corner(Eigen::AlignedBox3d::CornerType(i))));
}

}  // namespace

Camera Viewport::camera() const { return Camera(*scenery_->bodies->GetActiveCamera()); }

/// With the scene's up, which need not be the mesh's.
void Viewport::look_by_default() {
  const Quat& q_FW = scenery_->q_FW;
  camera().look_at(scenery_->centre, q_FW * default_view_direction(), q_FW * Vec3::UnitZ(), 1);
}

void Viewport::look(const CameraPlace& place) {
  const Vec3 direction = place.position - place.target;
  camera().look_at(place.target, direction, place.up, direction.norm());
  invalidate();
}

void Viewport::fit() {
  const Scenery& s = *scenery_;
  std::vector<Vec3> corners;
  add_corners(corners, s.fixed_box, Pose{});
  add_corners(corners, s.probe_box, s.last_device);
  add_corners(corners, s.probe_box, s.last_separated);
  // Below the legend or beside it: where it comes out larger.
  const std::vector<QRectF> areas = s.hints->clear_areas();
  const QRectF* best = nullptr;
  double nearest = 0;
  for (const QRectF& area : areas) {
    if (area.width() < least_area || area.height() < least_area) continue;
    const double distance = camera().frame(corners, size(), area);
    if (!best || distance < nearest) best = &area, nearest = distance;
  }
  camera().frame(corners, size(), best ? *best : QRectF(rect()));
  fitted_ = place();
  invalidate();
}

/// Nobody has turned or moved the picture since.
bool Viewport::is_as_fitted() const {
  const CameraPlace now = place();
  return now.position == fitted_.position && now.target == fitted_.target && now.up == fitted_.up;
}

void Viewport::find_probe(const Pose& X_FM) {
  Scenery& s = *scenery_;
  if (!s.pair) return;
  s.last_device = s.last_separated = X_FM;
  const Vec3 com = X_FM * s.mass.com;
  const bool before_the_eye = (camera().eye() - com).dot(camera().axes().towards) > 0;
  if (!before_the_eye || !QRectF(rect()).contains(on_screen(com))) fit();
}

/// Whether both bodies are seen as a whole, were the picture of that size.
bool Viewport::shows_all(const QSize& size) const {
  const Scenery& s = *scenery_;
  std::vector<Vec3> corners;
  add_corners(corners, s.fixed_box, Pose{});
  add_corners(corners, s.probe_box, s.last_device);
  vtkMatrix4x4* const seen =
      s.bodies->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect_of(size), -1, 1);
  return std::ranges::all_of(corners, [&](const Vec3& x) {
    const double in[4] = {x.x(), x.y(), x.z(), 1};
    double out[4];
    seen->MultiplyPoint(in, out);
    return out[3] > 0 && std::abs(out[0]) <= out[3] && std::abs(out[1]) <= out[3];
  });
}

double Viewport::metres_per_pixel(const Vec3& at) const {
  return camera().metres_per_pixel(at, height());
}

QPointF Viewport::on_screen(const Vec3& point) const {
  vtkCamera* camera = scenery_->bodies->GetActiveCamera();
  const double in[4] = {point.x(), point.y(), point.z(), 1};
  double out[4];
  camera->GetCompositeProjectionTransformMatrix(aspect(), -1, 1)->MultiplyPoint(in, out);
  if (!(std::abs(out[3]) > 0)) return {};
  const QSize view = view_size();
  return {(out[0] / out[3] + 1) / 2 * view.width(), (1 - out[1] / out[3]) / 2 * view.height()};
}

QPolygonF Viewport::polygon_on_screen(const std::vector<Vec3>& points) const {
  QPolygonF polygon;
  for (const Vec3& point : points) polygon << on_screen(point);
  return polygon;
}

double Viewport::aspect() const { return aspect_of(view_size()); }

}  // namespace sonde::ui
