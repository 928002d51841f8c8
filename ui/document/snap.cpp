// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/snap.hpp"

namespace sonde::ui {

Pose snapped(const Pose& X_FM, SnapKind kind, const Feature& own, const Feature& onto) {
  const bool of_planes = kind == SnapKind::face;
  const bool other_way = of_planes || own.along.dot(onto.along) < 0;
  const Vec3 wanted = other_way ? Vec3(-onto.along) : onto.along;
  const Quat turn = Quat::FromTwoVectors(own.along, wanted);
  const Vec3 way = onto.at - own.at;
  const Vec3 along = onto.along * onto.along.dot(way);
  Pose out;
  out.q = (turn * X_FM.q).normalized();
  out.p = own.at + turn * Vec3(X_FM.p - own.at) + (of_planes ? along : Vec3(way - along));
  return out;
}

}  // namespace sonde::ui
