// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <QColor>
#include <numbers>
#include <vector>

#include "engine/geometry/pose.hpp"

class vtkActor;
class vtkMapper;
class vtkPolyData;
class vtkRenderer;

namespace sonde::ui {

/// Moves an actor to the pose.
void place(vtkActor& actor, const Pose& pose);

/// Lines on a body, hidden at first: the body hides those behind it, and not those in front.
vtkSmartPointer<vtkActor> lines_on_body(vtkRenderer& renderer, vtkPolyData& lines,
                                        const QColor& colour);

/// The shapes of glyphs, of unit size. Each has one mapper that all actors share.
class GlyphShapes {
 public:
  GlyphShapes();
  ~GlyphShapes();
  GlyphShapes(const GlyphShapes&) = delete;
  GlyphShapes& operator=(const GlyphShapes&) = delete;

  vtkMapper& shaft();  ///< a cylinder of radius 1 round y, from 0 to 1
  vtkMapper& head();   ///< a cone of radius 1 round y, its tip at 1
  vtkMapper& ball();   ///< radius 1

 private:
  vtkSmartPointer<vtkMapper> shaft_, head_, ball_;
};

/// A ball of given radius.
class Ball {
 public:
  Ball(vtkRenderer& renderer, GlyphShapes& shapes, const QColor& colour);
  ~Ball();
  Ball(const Ball&) = delete;
  Ball& operator=(const Ball&) = delete;
  void set(const Vec3& centre, double radius);
  void hide();

 private:
  vtkSmartPointer<vtkActor> actor_;
};

/// An arrow: a shaft and a head. `thickness` is the radius of the shaft; the head is three times as
/// wide and shrinks with an arrow too short for it. Without a head it is a rod.
class Arrow {
 public:
  Arrow(vtkRenderer& renderer, GlyphShapes& shapes, const QColor& colour);
  ~Arrow();
  Arrow(const Arrow&) = delete;
  Arrow& operator=(const Arrow&) = delete;
  void set(const Vec3& from, const Vec3& to, double thickness, bool with_head = true);
  void hide();

 private:
  vtkSmartPointer<vtkActor> shaft_, head_;
};

/// All but a little of a ring: where it begins and ends, its head says which way it turns.
inline constexpr double ring_angle = 1.93 * std::numbers::pi;

/// An arc round an axis, with a head at its end.
class Arc {
 public:
  Arc(vtkRenderer& renderer, GlyphShapes& shapes, const QColor& colour);
  ~Arc();
  Arc(const Arc&) = delete;
  Arc& operator=(const Arc&) = delete;
  /// Begins at centre + start and turns by `angle` about the unit `axis`, which start is normal to.
  void set(const Vec3& centre, const Vec3& axis, const Vec3& start, double angle, double thickness);
  void hide();

 private:
  vtkSmartPointer<vtkPolyData> path_;
  vtkSmartPointer<vtkActor> tube_, head_;
};

/// Points along an arc as Arc draws it.
std::vector<Vec3> arc_points(const Vec3& centre, const Vec3& axis, const Vec3& start, double angle);

/// A unit vector normal to a unit vector.
Vec3 any_normal(const Vec3& axis);

}  // namespace sonde::ui
