// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is each course as its comment tells it, at times worked out by hand.
#include "engine/study/stability/hand_course.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

const Pose course_start{Quat::Identity(), {1, 2, 3}};
const Wrench push{{0, 0, -4}, {0.2, 0, 0}};

double share(HandCourse course, double t) {
  const HandInput hand = hand_at(course, course_place(course_start, push, 0.05), t);
  EXPECT_NEAR(hand.push.torque.x() / 0.2, hand.push.force.z() / -4, 1e-12);
  return hand.push.force.z() / -4;
}

TEST(HandCourse, pushes_as_it_says) {
  const struct {
    HandCourse course;
    double t, share;
  } at[] = {{HandCourse::step, 0.0999, 0},
            {HandCourse::step, 0.1, 1},
            {HandCourse::step, 1, 1},
            {HandCourse::ramp, 0.1, 0},
            {HandCourse::ramp, 0.3, 0.5},
            {HandCourse::ramp, 0.5, 1},
            {HandCourse::ramp, 1, 1},
            {HandCourse::slide, 0.15, 0.5},
            {HandCourse::slide, 0.5, 1},
            {HandCourse::reversal, 0.2, 1},
            {HandCourse::reversal, 0.45, -0.25},
            {HandCourse::reversal, 0.5, 1}};
  for (const auto& [course, t, wanted] : at)
    EXPECT_NEAR(share(course, t), wanted, 1e-9) << name_of(course) << " " << t;
}

TEST(HandCourse, only_a_slide_draws_and_at_right_angles_to_the_push) {
  const CoursePlace place = course_place(course_start, push, 0.05);
  EXPECT_NEAR(place.along.norm(), 1, 1e-12);
  EXPECT_NEAR(place.along.dot(push.force), 0, 1e-12);
  for (const HandCourse course : all_hand_courses)
    for (const double t : {0., 0.4, 0.6, 0.8, 1.}) {
      const Vec3 moved = hand_at(course, place, t).X_FH.p - course_start.p;
      const double part = course == HandCourse::slide ? (t < 0.5 ? 0 : t < 0.7 ? 0.5 : 1) : 0;
      EXPECT_LT((moved - part * 0.005 * place.along).norm(), 1e-12) << name_of(course) << " " << t;
    }
}

TEST(HandCourse, is_steady_from_where_it_says) {
  const CoursePlace place = course_place(course_start, push, 0.05);
  for (const HandCourse course : all_hand_courses) {
    const HandInput last = hand_at(course, place, course_time);
    for (double t = steady_from(course); t < course_time; t += 0.01) {
      EXPECT_EQ(hand_at(course, place, t).push.force, last.push.force) << name_of(course);
      EXPECT_EQ(hand_at(course, place, t).X_FH.p, last.X_FH.p) << name_of(course);
    }
  }
}

TEST(HandCourse, without_a_force_there_is_a_direction_too) {
  EXPECT_NEAR(course_place(course_start, {}, 0.05).along.norm(), 1, 1e-12);
}

}  // namespace
}  // namespace sonde
