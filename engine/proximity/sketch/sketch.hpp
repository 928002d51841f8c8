// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "engine/proximity/sketch/distance_field.hpp"

namespace sonde {

/// A group of points near each other.
struct PointGroup {
  Quad center;
  double radius;             // m
  std::vector<Quad> points;  // fourth component: distance from the center, m
};

/// A simplified body for quick searches: two sets of points of its surface, a small one (`few`) and
/// a larger one (`more`), and for a solid a field with the distance of any point. (A surface has no
/// inside; its field says that every point is far away.) Points and field are in the body's
/// principal axes, with the origin at its centre of mass.
struct Sketch {
  std::vector<PointGroup> few, more;
  DistanceField field;
};

/// Takes some tens of milliseconds.
std::shared_ptr<const Sketch> make_sketch(const Body& body);

/// The sketches of a pair of bodies. True if both exist; only then can they be used.
struct Sketches {
  std::shared_ptr<const Sketch> probe, fixed;
  explicit operator bool() const { return probe && fixed; }
};
/// Makes the sketches of a pair, on two threads. Empty if both bodies are surfaces, or if the size
/// of one is not between 1e-12 m and 1e12 m.
Sketches make_sketches(const Body& probe, const Body& fixed, const Progress& progress = {});

/// `count` points spread over the surface of a body, in its mesh frame, corners first. The first n
/// of them, for any n, are spread evenly too.
std::vector<Vec3> spread_points(const Body& body, std::size_t count);

}  // namespace sonde
