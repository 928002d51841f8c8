// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/hand_course.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr double begin = 0.1;                         // s
constexpr double ramp_end = 0.5;                      // s
constexpr double pressed = 0.2;                       // s, before the slide
constexpr double slide_begin = 0.4, slide_end = 0.8;  // s
constexpr double turned = 0.4, turned_back = 0.5;     // s
constexpr double pull = -0.25;                        // of the push
constexpr double slide_of_radius = 0.1;

/// From 0 to 1 between two times.
double rise(double t, double from, double to) {
  return std::clamp((t - from) / (to - from), 0., 1.);
}

/// The share of the push at a time.
double push_at(HandCourse course, double t) {
  switch (course) {
    case HandCourse::step:
      return t >= begin ? 1 : 0;
    case HandCourse::ramp:
      return rise(t, begin, ramp_end);
    case HandCourse::slide:
      return rise(t, begin, pressed);
    case HandCourse::reversal:
      return t < begin ? 0 : t >= turned && t < turned_back ? pull : 1;
  }
  return 0;
}

}  // namespace

const char* name_of(HandCourse course) {
  switch (course) {
    case HandCourse::step:
      return "step";
    case HandCourse::ramp:
      return "ramp";
    case HandCourse::slide:
      return "slide";
    case HandCourse::reversal:
      return "reversal";
  }
  return "";
}

double steady_from(HandCourse course) {
  switch (course) {
    case HandCourse::step:
      return begin;
    case HandCourse::ramp:
      return ramp_end;
    case HandCourse::slide:
      return slide_end;
    case HandCourse::reversal:
      return turned_back;
  }
  return 0;
}

CoursePlace course_place(const Pose& X_FM, const Wrench& push, double radius) {
  const Vec3 along = push.force.norm() > 0 ? push.force.unitOrthogonal() : Vec3(Vec3::UnitX());
  return {X_FM, push, along, slide_of_radius * radius};
}

HandInput hand_at(HandCourse course, const CoursePlace& place, double t) {
  const double share = push_at(course, t);
  HandInput out{place.X_FM, {share * place.push.force, share * place.push.torque}};
  if (course == HandCourse::slide)
    out.X_FH.p += rise(t, slide_begin, slide_end) * place.slide * place.along;
  return out;
}

}  // namespace sonde
