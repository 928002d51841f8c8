// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// What a hand does with the probe, from rest where it touches.
enum class HandCourse {
  step,      ///< the whole push at once, from 0.1 s on
  ramp,      ///< the push grows from 0.1 to 0.5 s, and stays
  slide,     ///< presses from 0.1 to 0.2 s, then draws along the surface from 0.4 to 0.8 s
  reversal,  ///< the push from 0.1 s, a quarter of it the other way from 0.4 s, back from 0.5 s
};
constexpr HandCourse all_hand_courses[] = {HandCourse::step, HandCourse::ramp, HandCourse::slide,
                                           HandCourse::reversal};
const char* name_of(HandCourse course);
constexpr double course_time = 1.2;  ///< s, of each
/// From then on the hand changes nothing any more, s.
double steady_from(HandCourse course);

/// Where a course takes place.
struct CoursePlace {
  Pose X_FM;         ///< the probe at the beginning, free
  Wrench push;       ///< the whole push, about the centre of mass
  Vec3 along;        ///< unit vector in F of the slide, at right angles to the push
  double slide = 0;  ///< m, its length
};
/// Along: at right angles to the push; its length is a tenth of the probe's radius.
CoursePlace course_place(const Pose& X_FM, const Wrench& push, double radius);

/// The hand at a time, s: where its spring draws the probe, and its push beside that.
struct HandInput {
  Pose X_FH;
  Wrench push;
};
HandInput hand_at(HandCourse course, const CoursePlace& place, double t);

}  // namespace sonde
