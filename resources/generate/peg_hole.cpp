// SPDX-License-Identifier: GPL-3.0-or-later
// A keyed peg and a block with a blind hole to match, at 1 % clearance.
#include <algorithm>
#include <cmath>

#include "resources/generate/mesh.hpp"
#include "resources/generate/output.hpp"

namespace sonde::generate {
namespace {

constexpr double radius = 0.010;             ///< of the peg
constexpr double clearance = 0.01 * radius;  ///< all round
constexpr double key_half_width = 0.0025;
constexpr double key_height = 0.0020;
constexpr double chamfer = 0.0012;
constexpr double half_block = 0.025;
constexpr double block_height = 0.032;
constexpr double hole_depth = 0.024;

/// A circle with a key along +x, grown by `offset` everywhere, anticlockwise. Always the same
/// number of points, each where its neighbour in another such outline is.
Outline keyed_circle(double offset) {
  const double r = radius + offset;
  const double w = key_half_width + offset;
  const double h = r + key_height;
  Outline out;
  const double corner = std::asin(w / r);
  add_arc(out, {0, 0}, r, corner, two_pi - corner, 150);
  const double root = r * std::cos(corner);
  for (int i = 1; i <= 3; ++i) out.push_back({root + (h - root) * i / 3, -w});
  for (int i = 1; i <= 6; ++i) out.push_back({h, -w + 2 * w * i / 6});
  for (int i = 1; i < 3; ++i) out.push_back({h + (root - h) * i / 3, w});
  return out;
}

/// The outline thrown outwards onto a square, with a point in each of its corners.
Outline square_about(const Outline& inner) {
  Outline out;
  for (const Point2& p : inner) {
    const double grow = half_block / std::max(std::abs(p.x), std::abs(p.y));
    out.push_back({p.x * grow, p.y * grow});
  }
  for (const double x : {-half_block, half_block})
    for (const double y : {-half_block, half_block}) {
      const auto distance = [&](const Point2& p) { return std::hypot(p.x - x, p.y - y); };
      *std::min_element(out.begin(), out.end(), [&](const Point2& p, const Point2& q) {
        return distance(p) < distance(q);
      }) = {x, y};
    }
  return out;
}

Outline between(const Outline& a, const Outline& b, double share) {
  Outline out;
  for (std::size_t i = 0; i < a.size(); ++i)
    out.push_back({a[i].x + share * (b[i].x - a[i].x), a[i].y + share * (b[i].y - a[i].y)});
  return out;
}

/// Rings of one outline from z = a to z = b, both among them.
void add_wall(std::vector<Ring>& rings, const Outline& outline, double a, double b, int steps) {
  for (int i = 0; i <= steps; ++i) rings.push_back(at_height(outline, a + (b - a) * i / steps));
}

/// The peg stands on its tip at the origin: chamfered below, a round grip above.
Soup peg_mesh() {
  const Outline body = keyed_circle(0);
  const Outline tip = keyed_circle(-chamfer);
  Outline grip;
  for (const Point2& p : body) {
    const double grow = 0.016 / std::hypot(p.x, p.y);
    grip.push_back({p.x * grow, p.y * grow});
  }
  std::vector<Ring> rings = {at_height(between(tip, Outline(tip.size()), 0.5), 0)};
  rings.push_back(at_height(tip, 0));
  add_wall(rings, body, chamfer, 0.030, 14);
  rings.push_back(at_height(between(body, grip, 0.5), 0.030));
  add_wall(rings, grip, 0.030, 0.042, 6);
  rings.push_back(at_height(between(grip, Outline(grip.size()), 0.15), 0.044));
  rings.push_back(at_height(between(grip, Outline(grip.size()), 0.6), 0.044));
  return loft(rings, Ends::capped, Vec3::Zero(), Vec3(0, 0, 0.044));
}

/// The block's upper face is z = 0, the hole about the z axis.
Soup block_mesh() {
  const Outline hole = keyed_circle(clearance);
  const Outline mouth = keyed_circle(clearance + chamfer);
  const Outline square = square_about(mouth);
  const Outline axis(hole.size());
  std::vector<Ring> rings = {at_height(between(axis, square, 0.33), -block_height),
                             at_height(between(axis, square, 0.66), -block_height)};
  add_wall(rings, square, -block_height, 0, 8);
  for (const double share : {0.33, 0.66, 1.0})
    rings.push_back(at_height(between(square, mouth, share), 0));
  add_wall(rings, hole, -chamfer, -hole_depth, 14);
  rings.push_back(at_height(between(hole, axis, 0.5), -hole_depth));
  return loft(rings, Ends::capped, Vec3(0, 0, -block_height), Vec3(0, 0, -hole_depth));
}

}  // namespace

void write_peg_in_hole(const Output& out) {
  out.mesh("peg.ply", peg_mesh());
  out.mesh("block.ply", block_mesh());
  Path path({0.004, -0.003, 0.020}, {8, -6, 25});
  path.hold(0.2)
      .via(0.7, {0.003, -0.002, -0.004}, {6, -4, 20})    // beside the hole: onto the face
      .via(0.6, {-0.001, 0.001, -0.003}, {3, -2, 8})     // sliding towards it
      .rest(0.6, {0.00003, -0.00002, 0.002}, {0, 0, 0})  // lifted and aligned
      .via(0.7, {0.0001, 0, -0.010}, {0.1, 0.1, 0.1})
      .via(0.6, {0.0008, 0.0004, -0.018}, {1, 4, 2})      // jammed askew
      .via(0.6, {-0.0006, 0.0002, -0.027}, {-1, -2, -5})  // through the bottom, turned on the key
      .via(0.6, {0.0002, -0.0008, -0.020}, {-3, 1, 4})
      .rest(0.7, {0, 0, -0.008}, {0, 0, 0})
      .home(1.1)
      .hold(0.2);
  SceneText text{"peg-in-hole", "peg.ply", "block.ply", "auto"};
  text.k = 800;
  out.scene(text, path);
}

}  // namespace sonde::generate
