// SPDX-License-Identifier: GPL-3.0-or-later
// References: the pinhole's closed form, and VTK's own projection of a point.
#include "ui/views/camera.hpp"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace sonde::ui {
namespace {

constexpr int width = 640, height = 400;

/// Pixels, from the upper left.
Vec3 on_screen(vtkCamera& camera, const Vec3& x) {
  vtkMatrix4x4* const m =
      camera.GetCompositeProjectionTransformMatrix(double(width) / height, -1, 1);
  const double in[4] = {x.x(), x.y(), x.z(), 1};
  double out[4];
  m->MultiplyPoint(in, out);
  return {(out[0] / out[3] + 1) / 2 * width, (1 - out[1] / out[3]) / 2 * height, out[3]};
}

std::vector<Vec3> corners() {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i)
    out.emplace_back(i & 1 ? 0.03 : -0.01, i & 2 ? 0.02 : 0.0, i & 4 ? 0.05 : -0.04);
  return out;
}

class CameraTest : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    camera.set_parallel(GetParam());
    camera.look_at(Vec3(0.01, 0.02, 0.03), Vec3(1, 2, 3), Vec3(0, 0, 1), 0.4);
  }
  vtkNew<vtkCamera> vtk;
  Camera camera{*vtk};
};

TEST_P(CameraTest, its_axes_are_right_handed_and_look_where_it_was_told) {
  const ViewAxes axes = camera.axes();
  EXPECT_NEAR((axes.towards - Vec3(1, 2, 3).normalized()).norm(), 0, 1e-12);
  EXPECT_NEAR((axes.right.cross(axes.up) - axes.towards).norm(), 0, 1e-12);
  EXPECT_NEAR(axes.right.z(), 0, 1e-12) << "up is up in the picture";
  EXPECT_NEAR(camera.distance(), 0.4, 1e-12);
}

TEST_P(CameraTest, a_pixel_is_as_many_metres_as_moves_a_point_by_one) {
  const Vec3 x(0.03, -0.01, 0.02);
  const double metres = camera.metres_per_pixel(x, height);
  const Vec3 before = on_screen(*vtk, x), after = on_screen(*vtk, x + metres * camera.axes().right);
  EXPECT_NEAR(after.x() - before.x(), 1, 1e-6);
  EXPECT_NEAR(after.y() - before.y(), 0, 1e-6);
}

TEST_P(CameraTest, what_is_framed_fills_its_part_and_stays_within) {
  const QRectF part(200, 40, 400, 300);
  camera.frame(corners(), {width, height}, part);
  double left = width, right = 0, top = height, bottom = 0;
  for (const Vec3& corner : corners()) {
    const Vec3 at = on_screen(*vtk, corner);
    left = std::min(left, at.x()), right = std::max(right, at.x());
    top = std::min(top, at.y()), bottom = std::max(bottom, at.y());
  }
  EXPECT_GE(left, part.left());
  EXPECT_LE(right, part.right());
  EXPECT_GE(top, part.top());
  EXPECT_LE(bottom, part.bottom());
  EXPECT_GT(std::max((right - left) / part.width(), (bottom - top) / part.height()), 0.75);
  EXPECT_NEAR((left + right) / 2, part.center().x(), 2);
  EXPECT_NEAR((top + bottom) / 2, part.center().y(), 2);
}

TEST_P(CameraTest, an_orbit_there_and_back_is_none_and_keeps_the_distance) {
  const Vec3 eye = camera.eye();
  camera.orbit(0.7, 0);
  EXPECT_NEAR(camera.distance(), 0.4, 1e-9);
  EXPECT_GT((camera.eye() - eye).norm(), 0.1);
  camera.orbit(-0.7, 0);
  EXPECT_NEAR((camera.eye() - eye).norm(), 0, 1e-9);
}

TEST_P(CameraTest, the_other_projection_keeps_the_size_of_what_is_looked_at) {
  const double before = camera.metres_per_pixel(camera.target(), height);
  camera.set_parallel(!GetParam());
  EXPECT_NEAR(camera.metres_per_pixel(camera.target(), height), before, 1e-12);
  camera.zoom(2);
  EXPECT_NEAR(camera.metres_per_pixel(camera.target(), height), before / 2, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Projections, CameraTest, testing::Bool());

}  // namespace
}  // namespace sonde::ui
