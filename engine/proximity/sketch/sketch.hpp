// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "engine/proximity/sketch/distance_field.hpp"

namespace sonde {

/// Points that lie together.
struct PointGroup {
  Quad center;
  double radius;             // m
  std::vector<Quad> points;  // the fourth: how far from the center, m
};

/// A body for quick searches: some points of its surface (a few, or more of them) and, for a solid,
/// a field with the distance of any point. (A surface has no inside, so every point is far from
/// it.) Both are in its principal axes, with the origin at its centre of mass.
struct Sketch {
  std::vector<PointGroup> few, more;
  DistanceField field;
};

/// Takes some tens of milliseconds.
std::shared_ptr<const Sketch> make_sketch(const Body& body);

/// The sketches of a pair of bodies; useful where both are there.
struct Sketches {
  std::shared_ptr<const Sketch> probe, fixed;
  explicit operator bool() const { return probe && fixed; }
};
/// Makes the sketches of a pair, on two threads. Empty where both bodies are surfaces, or where the
/// size of one is not between 1e-12 m and 1e12 m.
Sketches make_sketches(const Body& probe, const Body& fixed, const Progress& progress = {});

/// `count` points spread over the surface of a body, in its mesh frame, corners first. The first
/// few are spread as well as all of them.
std::vector<Vec3> spread_points(const Body& body, std::size_t count);

}  // namespace sonde
