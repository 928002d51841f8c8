// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/facing_features.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// Sine: edges more nearly parallel have no crossing.
constexpr double parallel = 1e-6;
/// In a hollow, sine: largest angle between a feature's normal and the direction of closest points.
constexpr double widest = 0.8;
/// In a hollow: share of the distance of two triangles that they must have along a feature's
/// normal.
constexpr double hollow = 0.5;
constexpr double same_face = 1e-18;  ///< square of the difference of unit normals
const Transform fixed_at;            ///< F itself
constexpr std::uint32_t none = 0xffffffffu;

/// Whether x lies on a triangle, seen along its face's normal, for either orientation of its
/// corners.
bool lies_on(const Vec3& x, const std::array<Vec3, 3>& at, const std::array<Vec3, 3>& edge,
             const Vec3& face, double border) {
  const double turn = edge[0].cross(edge[1]).dot(face) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (turn * face.cross(edge[i]).dot(x - at[i]) < -border) return false;
  return true;
}

bool agree(const Vec3& n, const Vec3& m, double sine) {
  return n.cross(m).squaredNorm() < sine * sine;
}

}  // namespace

FacingFeatures::Facing FacingFeatures::facing(const Soup& soup, std::uint32_t triangle,
                                              const Transform& X, const Vec3& normal,
                                              const Slack& slack) const noexcept {
  Facing out;
  out.vertex = soup.triangles[triangle];
  for (std::size_t i = 0; i < 3; ++i) out.at[i] = X * soup.vertices[out.vertex[i]];
  for (std::size_t i = 0; i < 3; ++i) {
    out.edge[i] = out.at[(i + 1) % 3] - out.at[i];
    out.length[i] = out.edge[i].norm();
    out.edge[i] /= out.length[i];
    out.lies[i] = std::abs(out.edge[i].dot(normal)) < slack.angle;
  }
  out.face = out.edge[0].cross(out.edge[1]).normalized();
  if (out.face.dot(normal) < 0) out.face = -out.face;
  out.faces = agree(out.face, normal, slack.angle);
  return out;
}

/// Compares faces too: a vertex may lie on two triangles of one face.
bool FacingFeatures::knows(FeatureRow::Kind kind, const Names& names,
                           const Vec3& face) const noexcept {
  for (std::size_t k = 0; k < size_; ++k) {
    if (rows_[k].kind != kind || names_[k] != names) continue;
    if (kind == FeatureRow::Kind::edge_on_edge || (face - faces_[k]).squaredNorm() < same_face)
      return true;
  }
  return false;
}

void FacingFeatures::push(const FeatureRow& row, const Names& names, const Vec3& face) noexcept {
  overflowed_ = overflowed_ || size_ == capacity;
  if (overflowed_) return;
  rows_[size_] = row;
  faces_[size_] = face;
  names_[size_++] = names;
}

bool FacingFeatures::add_vertex_on_face(const Facing& a, std::size_t i, const Facing& b,
                                        const Slack& slack) noexcept {
  if (b.face.dot(a.at[i] - b.at[0]) > reach_) return false;
  const Names names{a.vertex[i], none, none, none};
  if (knows(FeatureRow::Kind::vertex_on_face, names, b.face)) return true;
  if (gap_along(b.face, a.at, b.at) < slack.least ||
      !lies_on(a.at[i], b.at, b.edge, b.face, slack.border))
    return false;
  push({FeatureRow::Kind::vertex_on_face, surface(probe_).vertices[a.vertex[i]], Vec3::Zero(),
        b.at[0], b.face, 1},
       names, b.face);
  return true;
}

bool FacingFeatures::add_face_on_vertex(const Facing& a, const Facing& b, std::size_t j,
                                        const Slack& slack) noexcept {
  if (a.face.dot(a.at[0] - b.at[j]) > reach_) return false;
  const Names names{none, none, b.vertex[j], none};
  if (knows(FeatureRow::Kind::face_on_vertex, names, a.face)) return true;
  if (gap_along(a.face, a.at, b.at) < slack.least ||
      !lies_on(b.at[j], a.at, a.edge, a.face, slack.border))
    return false;
  push({FeatureRow::Kind::face_on_vertex, surface(probe_).vertices[a.vertex[0]],
        X_.R.transpose() * a.face, b.at[j], Vec3::Zero(), 1},
       names, a.face);
  return true;
}

bool FacingFeatures::add_edges(const Facing& a, std::size_t i, const Facing& b, std::size_t j,
                               const Vec3& normal, const Slack& slack) noexcept {
  const Vec3 &u = a.edge[i], &d = b.edge[j], across = u.cross(d);
  const double sine = across.norm();
  if (sine < parallel) return false;
  const double sign = across.dot(normal) < 0 ? -1 : 1;
  const Vec3 n = sign / sine * across;
  const Vec3 between = a.at[i] - b.at[j];
  if (n.dot(between) > reach_ || !agree(n, normal, slack.angle)) return false;
  const auto [a0, a1] = std::minmax(a.vertex[i], a.vertex[(i + 1) % 3]);
  const auto [b0, b1] = std::minmax(b.vertex[j], b.vertex[(j + 1) % 3]);
  const Names names{a0, a1, b0, b1};
  if (knows(FeatureRow::Kind::edge_on_edge, names, n)) return true;
  // Position of the crossing along each edge.
  const double s = -between.cross(d).dot(across) / (sine * sine),
               t = -between.cross(u).dot(across) / (sine * sine);
  if (s < -slack.border || s > a.length[i] + slack.border || t < -slack.border ||
      t > b.length[j] + slack.border || gap_along(n, a.at, b.at) < slack.least)
    return false;
  push({FeatureRow::Kind::edge_on_edge, surface(probe_).vertices[a.vertex[i]], X_.R.transpose() * u,
        b.at[j], d, sign},
       names, n);
  return true;
}

int FacingFeatures::add(const Facing& a, const Facing& b, const Vec3& normal,
                        const Slack& slack) noexcept {
  int found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (b.faces) found += add_vertex_on_face(a, i, b, slack);
    if (a.faces) found += add_face_on_vertex(a, b, i, slack);
    for (std::size_t j = 0; j < 3 && a.lies[i]; ++j)
      if (b.lies[j]) found += add_edges(a, i, b, j, normal, slack);
  }
  return found;
}

int FacingFeatures::add_pair(std::uint32_t a, std::uint32_t b, const Vec3& normal) noexcept {
  return add(facing(surface(probe_), a, X_, normal, close_),
             facing(surface(fixed_), b, fixed_at, normal, close_), normal, close_);
}

void FacingFeatures::find_around(const Vec3& on_probe, const Vec3& on_fixed, Around& out) noexcept {
  const double radius = std::max(reach_, 2 * (on_probe - on_fixed).norm());
  const Vec3 on_probe_M = X_.R.transpose() * (on_probe - X_.p);
  out.count_a = triangles_within(probe_, on_probe_M, radius, out.a);
  out.count_b = triangles_within(fixed_, on_fixed, radius, out.b);
  overflowed_ = overflowed_ || out.count_a == out.a.size() || out.count_b == out.b.size();
}

int FacingFeatures::add_around(const Vec3& on_probe, const Vec3& on_fixed,
                               const Vec3& normal) noexcept {
  Around around;
  find_around(on_probe, on_fixed, around);
  std::array<Facing, std::tuple_size_v<decltype(around.b)>> of_b;
  for (std::size_t j = 0; j < around.count_b; ++j)
    of_b[j] = facing(surface(fixed_), around.b[j], fixed_at, normal, close_);
  int found = 0;
  for (std::size_t i = 0; i < around.count_a; ++i) {
    const Facing a = facing(surface(probe_), around.a[i], X_, normal, close_);
    for (std::size_t j = 0; j < around.count_b; ++j) found += add(a, of_b[j], normal, close_);
  }
  return found;
}

void FacingFeatures::add_hollow(const Vec3& on_probe, const Vec3& on_fixed,
                                const Vec3& normal) noexcept {
  Around around;
  find_around(on_probe, on_fixed, around);
  for (std::size_t i = 0; i < around.count_a; ++i)
    for (std::size_t j = 0; j < around.count_b; ++j) {
      Slack slack{widest, reach_};
      const Facing a = facing(surface(probe_), around.a[i], X_, normal, slack);
      const Facing b = facing(surface(fixed_), around.b[j], fixed_at, normal, slack);
      const ClosestPoints nearest = closest_points(a.at, b.at, reach_);
      if (!(nearest.distance > 0) || nearest.distance > reach_) continue;
      slack.least = hollow * nearest.distance;
      add(a, b, normal, slack);
    }
}

}  // namespace sonde
