// SPDX-License-Identifier: GPL-3.0-or-later
// What a Viewport does to let people see inside.

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/proximity/queries/ray_hit.hpp"
#include "ui/base/theme.hpp"
#include "ui/views/body_look.hpp"
#include "ui/views/scenery.hpp"

namespace sonde::ui {
namespace {

constexpr double square_part = 1.05;  // of the fixed body's radius: the outline is beside the body
constexpr double around = 2.5;        // times a place's size is in the picture, and at least
constexpr double least_part = 0.15;   // of the body's radius
constexpr double along_sight = 0.95;  // the cosine: such a line of sight has no up but the camera's

constexpr double flat = 1e-3;  // 1 - cosine: faces that meet at less have no edge there

Vec3 normal_of(const Soup& soup, const Triangle& t) {
  const Vec3 &a = soup.vertices[t[0]], &b = soup.vertices[t[1]], &c = soup.vertices[t[2]];
  return (b - a).cross(c - a).stableNormalized();
}

double distance_to(const Vec3& a, const Vec3& b, const Vec3& x) {
  const double part = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + part * (b - a) - x).norm();
}

/// Whether the surface has an edge at that side: no other face goes on flat behind it.
bool is_edge(const Soup& soup, std::uint32_t triangle, std::uint32_t a, std::uint32_t b) {
  const Vec3 own = normal_of(soup, soup.triangles[triangle]);
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const auto has = [&](std::uint32_t v) { return t[0] == v || t[1] == v || t[2] == v; };
    if (i != triangle && has(a) && has(b) && normal_of(soup, t).dot(own) > 1 - flat) return false;
  }
  return true;
}

/// The edge of a triangle that is nearest to x: a corner of it, and along it, unit; zero where none
/// of its sides is one.
struct EdgeLine {
  Vec3 at = Vec3::Zero(), along = Vec3::Zero();
};
EdgeLine edge_beside(const Soup& soup, std::uint32_t triangle, const Vec3& x) {
  const Triangle& t = soup.triangles[triangle];
  EdgeLine best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
    const Vec3 &from = soup.vertices[a], &to = soup.vertices[b];
    const double distance = distance_to(from, to, x);
    if (distance >= nearest || !is_edge(soup, triangle, a, b)) continue;
    nearest = distance;
    best = {from, (to - from).stableNormalized()};
  }
  return best;
}

}  // namespace

void Viewport::set_seeing(const Seeing& seeing) {
  scenery_->seeing = seeing;
  apply_seeing();
  if (scenery_->probe) update_legend();
  invalidate();
}

const Seeing& Viewport::seeing() const { return scenery_->seeing; }

void Viewport::apply_seeing() {
  Scenery& s = *scenery_;
  const CutPlane& cut = s.seeing.cut;
  s.cut.set(cut, square_part * s.radius);
  if (!s.probe) return;
  vtkPlane* const through_fixed = cut.on && cut.fixed ? &s.cut.plane() : nullptr;
  vtkPlane* const through_probe = cut.on && cut.probe ? &s.cut.plane() : nullptr;
  apply_look(*s.fixed_actor, s.seeing.fixed, colour::fixed, s.fixed_is_solid, through_fixed);
  apply_look(s.probe->actor(), s.seeing.probe, colour::probe, s.pair->probe().solid, through_probe);
  s.probe->set_visible(s.seeing.probe != Look::hidden);
  s.defects->set_cut(through_probe, through_fixed);
  s.caps->set_seeing(s.seeing, through_probe, through_fixed);
  s.fixed_gaps.set_cut(through_fixed);
  s.fixed_crossings.set_cut(through_fixed);
  s.probe_crossings.set_cut(through_probe);
  s.probe_gaps.set_cut(through_probe);
  show_sections();
}

/// Of what is opaque, and on show.
void Viewport::show_sections() {
  Scenery& s = *scenery_;
  const CutPlane& cut = s.seeing.cut;
  std::vector<CutBody> fixed;
  std::optional<CutBody> probe;
  if (cut.on && cut.fixed && s.seeing.fixed == Look::opaque) {
    if (s.parts.empty()) fixed.push_back({&s.pair->fixed(), Pose{}, cut_colour(colour::fixed)});
    for (std::size_t i = 0; i < s.parts.size(); ++i)
      if (s.part_looks[i].shown)
        fixed.push_back(
            {s.parts[i].body.get(), s.parts[i].X_BP, cut_colour(s.part_looks[i].colour)});
  }
  if (cut.on && cut.probe && s.seeing.probe == Look::opaque)
    probe = CutBody{&s.pair->probe(), s.last_device, cut_colour(colour::probe)};
  s.sections.set_fixed(std::move(fixed));
  s.sections.set_probe(probe);
}

std::optional<Handles> Viewport::cut_handles() const {
  const Scenery& s = *scenery_;
  if (!s.pair || !s.seeing.cut.on || !shown(Layer::cut)) return std::nullopt;
  return s.cut.handles(HandleView::pixels * metres_per_pixel(s.seeing.cut.point));
}

void Viewport::choose_contact(std::uint64_t id) {
  scenery_->contacts.choose(id);
  invalidate();
}

std::optional<Pick> Viewport::pick(QPointF at) const {
  const Scenery& s = *scenery_;
  if (!s.pair) return {};
  vtkNew<vtkMatrix4x4> back;
  back->DeepCopy(
      s.bodies->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect(), -1, 1));
  back->Invert();
  const auto in_scene = [&](double depth) {
    const double in[4] = {2 * at.x() / width() - 1, 1 - 2 * at.y() / height(), depth, 1};
    double out[4];
    back->MultiplyPoint(in, out);
    return Vec3(Vec3(out[0], out[1], out[2]) / out[3]);
  };
  // Where lines are parallel each has an eye of its own, on the nearest plane.
  const Vec3 eye = camera().parallel() ? in_scene(-1) : camera().eye();
  const Vec3 along = (in_scene(0) - eye).normalized();
  std::optional<Pick> best;
  double nearest = 0;
  const auto try_body = [&](bool probe, const Body& body, const Pose& X_FB, Look look, bool cut,
                            std::optional<std::size_t> part = {}) {
    if (look == Look::hidden) return;
    const Pose X_BF = inverse(X_FB);
    const Vec3 from = X_BF * eye;
    const Vec3 direction = X_BF.q * along;
    const auto hit = ray_hit(body.soup, from, direction, [&](const Vec3& x) {
      return !cut || !s.seeing.cut.cuts_away(X_FB * x);
    });
    if (!hit || (best && hit->distance >= nearest)) return;
    nearest = hit->distance;
    const Vec3 x = from + hit->distance * direction;
    best = Pick{probe, probe ? x : X_FB * x, part};
    const Vec3 normal = normal_of(body.soup, body.soup.triangles[hit->triangle]);
    best->normal = X_FB.q * Vec3(normal.dot(direction) > 0 ? Vec3(-normal) : normal);
    const EdgeLine edge = edge_beside(body.soup, hit->triangle, x);
    best->edge = X_FB.q * edge.along;
    best->on_edge = X_FB * edge.at;
    best->triangle = hit->triangle;
  };
  if (s.parts.empty()) try_body(false, s.pair->fixed(), Pose{}, s.seeing.fixed, s.seeing.cut.fixed);
  for (std::size_t i = 0; i < s.parts.size(); ++i)
    if (s.part_looks[i].shown)
      try_body(false, *s.parts[i].body, s.parts[i].X_BP, s.seeing.fixed, s.seeing.cut.fixed, i);
  try_body(true, s.pair->probe(), s.last_device, s.seeing.probe, s.seeing.cut.probe);
  return best;
}

void Viewport::add_measured(const MeasuredPoint& point) {
  scenery_->measures.add(point);
  invalidate();
}

void Viewport::clear_measured() {
  scenery_->measures.clear();
  invalidate();
}

const std::vector<MeasuredPoint>& Viewport::measured() const { return scenery_->measures.points(); }

void Viewport::point_out(const std::optional<PointedPlace>& place) {
  scenery_->place.set(place);
  invalidate();
}

Pose Viewport::pose_of(bool probe) const { return probe ? scenery_->last_device : Pose{}; }

void Viewport::set_parallel(bool on) {
  camera().set_parallel(on);
  invalidate();
}

CameraPlace Viewport::place() const {
  const Camera now = camera();
  const ViewAxes axes = now.axes();
  return {now.target() + now.distance() * axes.towards, now.target(), axes.up};
}

CameraPlace Viewport::before(const PointedPlace& place) const {
  const Scenery& s = *scenery_;
  const Pose X_FB = pose_of(place.on_probe);
  const double body = (place.on_probe ? s.pair->probe() : s.pair->fixed()).mass.radius;
  const double radius = std::max(around * place.size, least_part * body);
  const double half_angle = s.bodies->GetActiveCamera()->GetViewAngle() * std::numbers::pi / 360;
  const bool faces = place.outward.norm() > 0;
  const Vec3 direction = faces ? Vec3(X_FB.q * place.outward) : camera().axes().towards;
  const Vec3 at = X_FB * place.at;
  const Vec3 up = s.q_FW * Vec3::UnitZ();
  const bool along_up = std::abs(up.dot(direction)) > along_sight;
  return {at + direction * (radius / std::sin(half_angle)), at, along_up ? camera().axes().up : up};
}

void Viewport::set_gaps(const Gaps& gaps) {
  Scenery& s = *scenery_;
  s.probe_gaps.set(gaps.probe, gaps.separated, gaps.reach);
  s.fixed_gaps.set(gaps.fixed, Pose{}, gaps.reach);
  s.gap_reach = gaps.reach;
  update_scale();
  invalidate();
}

void Viewport::set_crossings(const std::vector<std::uint32_t>& probe,
                             const std::vector<std::uint32_t>& fixed) {
  Scenery& s = *scenery_;
  if (s.pair) {
    s.probe_crossings.set(s.pair->probe().soup, probe);
    s.fixed_crossings.set(s.pair->fixed().soup, fixed);
  }
  invalidate();
}

void Viewport::set_force_note(const ForceNote& note) {
  if (note == scenery_->wrench.note()) return;
  scenery_->wrench.set_note(note);
  invalidate();
}

}  // namespace sonde::ui
