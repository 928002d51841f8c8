// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/snap.hpp"

namespace sonde::ui {
namespace {

/// Half a turn that takes the unit vector n to -n: about the axis of the fixed body's frame that
/// lies nearest to the plane of n, the first of those that lie alike.
Quat turned_over(const Vec3& n) {
  constexpr double alike = 1e-6;
  const Vec3 tilt = n.cwiseAbs();
  int k = 0;
  while (tilt[k] > tilt.minCoeff() + alike) ++k;
  const Vec3 axis = (Vec3::Unit(k) - n[k] * n).normalized();
  return Quat(0, axis.x(), axis.y(), axis.z());
}

/// The least turn that takes one unit vector to the other. Near half a turn its axis is noise of
/// the two, so a defined one is taken, and the rest is turned after it.
Quat least_turn(const Vec3& from, const Vec3& to) {
  constexpr double noise = 1e-5;  // rad: of normals in files of single precision
  const bool opposed = from.dot(to) < 0 && from.cross(to).norm() < noise;
  if (!opposed) return Quat::FromTwoVectors(from, to);
  return Quat::FromTwoVectors(-from, to) * turned_over(from);
}

}  // namespace

Pose snapped(const Pose& X_FM, SnapKind kind, const Feature& own, const Feature& onto) {
  const bool of_planes = kind == SnapKind::face;
  const bool other_way = of_planes || own.along.dot(onto.along) < 0;
  const Vec3 wanted = other_way ? Vec3(-onto.along) : onto.along;
  const Quat turn = least_turn(own.along, wanted);
  const Vec3 way = onto.at - own.at;
  const Vec3 along = onto.along * onto.along.dot(way);
  Pose out;
  out.q = (turn * X_FM.q).normalized();
  out.p = own.at + turn * Vec3(X_FM.p - own.at) + (of_planes ? along : Vec3(way - along));
  return out;
}

}  // namespace sonde::ui
