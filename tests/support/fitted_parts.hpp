// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that fit into each other with little room, and motions that press and wedge them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/pose.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde::test {

/// Corners against the clock, star-shaped about the origin, m.
using Section = std::vector<Eigen::Vector2d>;

Section regular_section(int sides, double radius);
/// A disc of so many sides with a key that stands out to `key_radius`, 2 `half_width` wide.
Section keyed_section(int sides, double radius, double key_radius, double half_width);
/// Teeth from one radius to the other.
Section toothed_section(int teeth, double root, double tip);
/// Wider above than below.
Section dovetail_section(double width, double height, double lean);
/// Each side moved outwards by `by`.
Section grown(const Section& section, double by);

/// The section from z = −half to half, its walls cut into strips across z at these heights (shares
/// of the whole, ascending; none: one strip).
PolygonSoup fitted_plug(const Section& section, double half, const std::vector<double>& cuts);
/// A body `outer` times as wide with such a hole through it, or one that ends `floor` (m) above its
/// lower end.
PolygonSoup fitted_socket(const Section& hole, double outer, double half,
                          const std::vector<double>& cuts, double floor = 0);
std::vector<double> even_strips(int count);
std::vector<double> random_strips(int count, std::uint64_t seed);

/// A way of the plug: from z = `from` (free) into the socket to z = `to`, about there to and fro by
/// up to `aside` (m) and `tilt` (rad) in all directions, and back. All of it in so many ticks.
struct FittedPath {
  double from = 0, to = 0, aside = 0, tilt = 0;
  std::uint64_t seed = 1;
  double lead = 0;  ///< m a turn about z, as a nut goes; 0: none
  double over = 0;  ///< rad that it is turned beyond that, while it is in
};
std::vector<Pose> fitted_path(const FittedPath& path, int ticks);

struct FittedScene {
  std::string name;
  PolygonSoup probe, fixed;
  FittedPath path;
};
/// Scenes of each kind, in several sizes and cuts.
std::vector<FittedScene> fitted_scenes();
/// One of the kinds, its walls cut by `cuts`.
std::vector<FittedScene> fitted_scenes_cut(const std::vector<double>& cuts);

}  // namespace sonde::test
