// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "engine/proximity/sketch/distance_field.hpp"

namespace sonde {

/// Points that lie together.
struct PointGroup {
  Quad center;
  double radius;  // m
  std::vector<Quad> points;
};

/// What a quick search knows of a body: some points of its surface, few or more of them, and where
/// it is solid how far any point is from it (from a surface, which has no inside, all are far).
/// Both in its principal axes, the origin at its centre of mass.
struct Sketch {
  std::vector<PointGroup> few, more;
  DistanceField field;
};

/// Takes some tens of milliseconds.
std::shared_ptr<const Sketch> make_sketch(const Body& body);

/// Of a pair of bodies; of use where both are there.
struct Sketches {
  std::shared_ptr<const Sketch> probe, fixed;
  explicit operator bool() const { return probe && fixed; }
};
/// Made once for a pair, on two threads. None where both are surfaces, or either is not between
/// 1e-12 m and 1e12 m in size.
Sketches make_sketches(const Body& probe, const Body& fixed);

/// So many points spread over the surface of a body, the corners before what is between, in its
/// mesh frame; the first few are spread as well as all are.
std::vector<Vec3> spread_points(const Body& body, std::size_t count);

}  // namespace sonde
