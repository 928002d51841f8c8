// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/glyphs.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <cmath>

namespace sonde::ui {
namespace {

constexpr int arc_segments = 48;
constexpr double head_width = 3;   // of the shaft's
constexpr double head_length = 9;  // of the shaft's radius

vtkSmartPointer<vtkMapper> mapper_of(vtkPolyDataAlgorithm& source) {
  source.Update();
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(source.GetOutput());
  return mapper;
}

vtkSmartPointer<vtkActor> actor_of(vtkRenderer& renderer, vtkMapper& mapper, const QColor& colour) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(&mapper);
  actor->SetUserMatrix(vtkNew<vtkMatrix4x4>());
  actor->PickableOff();
  actor->VisibilityOff();
  vtkProperty* property = actor->GetProperty();
  property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  property->SetAmbient(0.45);  // a glyph's colour is its meaning: it stays recognisable in shade
  property->SetDiffuse(0.6);
  renderer.AddActor(actor);
  return actor;
}

void set_matrix(vtkActor& actor, const Mat3& linear, const Vec3& origin) {
  vtkMatrix4x4* matrix = actor.GetUserMatrix();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, linear(row, column));
    matrix->SetElement(row, 3, origin[row]);
  }
  matrix->Modified();
}

/// Stands a unit shape round y on `from`, along a unit direction.
void stand(vtkActor& actor, const Vec3& from, const Vec3& direction, double radius, double length) {
  const Vec3 side = any_normal(direction);
  Mat3 linear;
  linear << side * radius, direction * length, side.cross(direction) * radius;
  set_matrix(actor, linear, from);
  actor.VisibilityOn();
}

}  // namespace

void place(vtkActor& actor, const Pose& pose) {
  if (!actor.GetUserMatrix()) actor.SetUserMatrix(vtkNew<vtkMatrix4x4>());
  set_matrix(actor, pose.q.toRotationMatrix(), pose.p);
}

std::vector<Vec3> arc_points(const Vec3& centre, const Vec3& axis, const Vec3& start,
                             double angle) {
  constexpr int pieces = 16;
  std::vector<Vec3> points;
  for (int i = 0; i <= pieces; ++i)
    points.push_back(centre + Eigen::AngleAxisd(angle * i / pieces, axis) * start);
  return points;
}

Vec3 any_normal(const Vec3& axis) {
  const Vec3 other = std::abs(axis.x()) < 0.8 ? Vec3::UnitX() : Vec3::UnitY();
  return axis.cross(other).normalized();
}

vtkSmartPointer<vtkActor> lines_on_body(vtkRenderer& renderer, vtkPolyData& lines,
                                        const QColor& colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&lines);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -8);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  actor->GetProperty()->LightingOff();
  actor->VisibilityOff();
  renderer.AddActor(actor);
  return actor;
}

GlyphShapes::GlyphShapes() {
  vtkNew<vtkCylinderSource> shaft;
  shaft->SetRadius(1);
  shaft->SetHeight(1);
  shaft->SetCenter(0, 0.5, 0);
  shaft->SetResolution(16);
  shaft_ = mapper_of(*shaft);
  vtkNew<vtkConeSource> head;
  head->SetDirection(0, 1, 0);
  head->SetCenter(0, 0.5, 0);
  head->SetHeight(1);
  head->SetRadius(1);
  head->SetResolution(24);
  head_ = mapper_of(*head);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(12);
  ball_ = mapper_of(*ball);
}

GlyphShapes::~GlyphShapes() = default;
vtkMapper& GlyphShapes::shaft() { return *shaft_; }
vtkMapper& GlyphShapes::head() { return *head_; }
vtkMapper& GlyphShapes::ball() { return *ball_; }

Ball::Ball(vtkRenderer& renderer, GlyphShapes& shapes, const QColor& colour)
    : actor_(actor_of(renderer, shapes.ball(), colour)) {}
Ball::~Ball() = default;

void Ball::set(const Vec3& centre, double radius) {
  set_matrix(*actor_, Mat3::Identity() * radius, centre);
  actor_->VisibilityOn();
}

void Ball::hide() { actor_->VisibilityOff(); }

Arrow::Arrow(vtkRenderer& renderer, GlyphShapes& shapes, const QColor& colour)
    : shaft_(actor_of(renderer, shapes.shaft(), colour)),
      head_(actor_of(renderer, shapes.head(), colour)) {}
Arrow::~Arrow() = default;

void Arrow::set(const Vec3& from, const Vec3& to, double thickness, bool with_head) {
  const double length = (to - from).norm();
  if (!(length > 0)) return hide();
  const Vec3 direction = (to - from) / length;
  if (!with_head) {
    head_->VisibilityOff();
    return stand(*shaft_, from, direction, thickness, length);
  }
  const double head = std::min(head_length * thickness, 0.6 * length);
  const double shrink = head / (head_length * thickness);
  stand(*shaft_, from, direction, thickness * std::max(shrink, 0.5), length - head);
  stand(*head_, to - direction * head, direction, head_width * thickness * shrink, head);
}

void Arrow::hide() {
  shaft_->VisibilityOff();
  head_->VisibilityOff();
}

Arc::Arc(vtkRenderer& renderer, GlyphShapes& shapes, const QColor& colour)
    : path_(vtkSmartPointer<vtkPolyData>::New()) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(arc_segments + 1);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(arc_segments + 1);
  for (int i = 0; i <= arc_segments; ++i) {
    points->SetPoint(i, std::cos(0.1 * i), std::sin(0.1 * i), 0);
    lines->InsertCellPoint(i);
  }
  path_->SetPoints(points);
  path_->SetLines(lines);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(path_);
  tube->SetNumberOfSides(12);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  tube_ = actor_of(renderer, *mapper, colour);
  head_ = actor_of(renderer, shapes.head(), colour);
}
Arc::~Arc() = default;

void Arc::set(const Vec3& centre, const Vec3& axis, const Vec3& start, double angle,
              double thickness) {
  const double radius = start.norm();
  if (!(angle > 1e-4) || !(radius > 0)) return hide();
  // The head's length, as an angle, is part of the arc: its tip is where the arc ends.
  const double head_angle = std::min(head_length * thickness / radius, 0.6 * angle);
  const double shrink = head_angle * radius / (head_length * thickness);
  const auto at = [&](double a) -> Vec3 {
    return centre + std::cos(a) * start + std::sin(a) * axis.cross(start);
  };
  for (int i = 0; i <= arc_segments; ++i)
    path_->GetPoints()->SetPoint(i, at((angle - head_angle) * i / arc_segments).data());
  path_->GetPoints()->Modified();
  path_->Modified();
  auto* tube = vtkTubeFilter::SafeDownCast(tube_->GetMapper()->GetInputAlgorithm());
  tube->SetRadius(thickness * std::max(shrink, 0.5));
  tube_->VisibilityOn();
  const Vec3 base = at(angle - head_angle);
  const Vec3 tip = at(angle);
  stand(*head_, base, (tip - base).normalized(), head_width * thickness * shrink,
        (tip - base).norm());
}

void Arc::hide() {
  tube_->VisibilityOff();
  head_->VisibilityOff();
}

}  // namespace sonde::ui
