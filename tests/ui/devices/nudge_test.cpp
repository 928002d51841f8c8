// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/nudge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/views/camera.hpp"

namespace sonde::ui {
namespace {

const ViewAxes from_front{Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()};
const Pose askew{Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized())), Vec3(1, 2, 3)};

Nudge along(Nudge::Axes axes, const PickedFace& face = {}) {
  Nudge nudge;
  nudge.axes = axes;
  nudge.face = face;
  return nudge;
}

/// Columns: right, up, Page Up.
void expect_axes(const std::optional<Mat3>& axes, const Vec3& right, const Vec3& up,
                 const Vec3& out) {
  ASSERT_TRUE(axes);
  Mat3 wanted;
  wanted << right, up, out;
  EXPECT_LT((*axes - wanted).norm(), 1e-12) << *axes;
}

TEST(Nudge, goes_along_the_picture_a_body_or_the_scene) {
  expect_axes(nudge_axes(along(Nudge::Axes::picture), askew, from_front), Vec3::UnitX(),
              Vec3::UnitZ(), Vec3::UnitY());
  expect_axes(nudge_axes(along(Nudge::Axes::fixed), askew, from_front), Vec3::UnitX(),
              Vec3::UnitY(), Vec3::UnitZ());
  const Mat3 R = askew.q.toRotationMatrix();
  expect_axes(nudge_axes(along(Nudge::Axes::probe), askew, from_front), R.col(0), R.col(1),
              R.col(2));
  Nudge scene = along(Nudge::Axes::world);
  scene.q_FW = askew.q;
  expect_axes(nudge_axes(scene, {}, from_front), R.col(0), R.col(1), R.col(2));
}

TEST(Nudge, along_a_face_there_is_nowhere_to_go_before_one_was_clicked) {
  Nudge none;
  none.axes = Nudge::Axes::face;
  EXPECT_FALSE(nudge_axes(none, askew, from_front));
}

TEST(Nudge, page_up_goes_out_of_a_face_and_the_arrows_across_it_as_they_point) {
  const Nudge front = along(Nudge::Axes::face, {"", false, -Vec3::UnitY()});
  expect_axes(nudge_axes(front, askew, from_front), Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY());
  const Nudge top = along(Nudge::Axes::face, {"", false, Vec3::UnitZ()});
  expect_axes(nudge_axes(top, askew, from_front), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ());
  // Of a face that is seen end on, right is away from the eye.
  const Nudge side = along(Nudge::Axes::face, {"", false, Vec3::UnitX()});
  expect_axes(nudge_axes(side, askew, from_front), Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX());
}

TEST(Nudge, the_steps_across_a_face_are_the_same_from_a_little_aside) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  const ViewAxes aside{Vec3(c, s, 0), Vec3::UnitZ(), Vec3(s, -c, 0)};
  const Nudge slope = along(Nudge::Axes::face, {"", false, Vec3(0, -0.6, 0.8)});
  expect_axes(nudge_axes(slope, askew, aside), Vec3::UnitX(), Vec3(0, 0.8, 0.6),
              Vec3(0, -0.6, 0.8));
}

TEST(Nudge, a_face_of_the_probe_turns_with_it) {
  const Pose turned{Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())), Vec3::Zero()};
  const Mat3 R = turned.q.toRotationMatrix();
  const Nudge face = along(Nudge::Axes::face, {"", true, -Vec3::UnitY()});
  expect_axes(nudge_axes(face, turned, from_front), R.col(0), R.col(2), -R.col(1));
}

}  // namespace
}  // namespace sonde::ui
