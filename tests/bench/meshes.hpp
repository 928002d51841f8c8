// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde::bench {

/// Every mesh is moved and scaled to this bounding radius about the middle of its box, so that gaps
/// and tolerances mean the same for all, m.
constexpr double mesh_radius = 1.0;

/// A mesh of about the number of triangles asked for. Rings have a tube a quarter as thick as
/// they are wide, so that two of them can be linked.
PolygonSoup sphere_mesh(std::size_t triangles);
PolygonSoup ring_mesh(std::size_t triangles);
PolygonSoup trefoil_mesh(std::size_t triangles);

/// Half the way across the ring's middle circle, m: two rings this far apart, at right angles, are
/// linked with the largest gap.
constexpr double ring_middle_radius = 0.8;

/// "sphere-32k", "ring-32k", "trefoil-1M", or the name of a real mesh. Throws InputError or
/// std::runtime_error where a real one is not installed.
PolygonSoup mesh(const std::string& name);

/// Why the mesh cannot be had: "" where it can.
std::string why_missing(const std::string& name);

}  // namespace sonde::bench
