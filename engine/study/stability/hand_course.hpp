// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// The motion of a hand with the probe, which starts at rest where it touches.
enum class HandCourse {
  step,      ///< the whole push immediately, from 0.1 s on
  ramp,      ///< the push grows from 0.1 to 0.5 s, and stays
  slide,     ///< presses from 0.1 to 0.2 s, then moves along the surface from 0.4 to 0.8 s
  reversal,  ///< the push from 0.1 s, a quarter of it in the opposite direction from 0.4 s, back
             ///< from 0.5 s
};
constexpr HandCourse all_hand_courses[] = {HandCourse::step, HandCourse::ramp, HandCourse::slide,
                                           HandCourse::reversal};
const char* name_of(HandCourse course);
constexpr double course_time = 1.2;  ///< s, duration of each
/// s: the hand is steady from then on.
double steady_from(HandCourse course);

/// The place of a course.
struct CoursePlace {
  Pose X_FM;         ///< the probe at the beginning, free
  Wrench push;       ///< the whole push, about the centre of mass
  Vec3 along;        ///< unit vector in F of the slide, perpendicular to the push
  double slide = 0;  ///< m, its length
};
/// `along` is perpendicular to the push; the length of the slide is a tenth of the probe's radius.
CoursePlace course_place(const Pose& X_FM, const Wrench& push, double radius);

/// The hand at a time, s: the target of its spring, and its push in addition to that.
struct HandInput {
  Pose X_FH;
  Wrench push;
};
HandInput hand_at(HandCourse course, const CoursePlace& place, double t);

}  // namespace sonde
