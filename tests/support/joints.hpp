// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that face each other all round or many times over, and motions that press and jam them.
#pragma once

#include <vector>

#include "tests/support/fitted_parts.hpp"

namespace sonde::test {

/// A ball about the origin, of meridians and parallels.
PolygonSoup ball(double radius, int sides, int rings);
/// A cylinder about the origin, down to `below` (m) under it, with a hollow of that radius up to
/// z = `open` (m): a ball in it touches all round.
PolygonSoup ball_socket(double radius, int sides, int rings, double open, double below);

/// A thread along z: flanks of equal slope from `root` to `tip` (m), `lead` (m) a turn.
struct Thread {
  double root = 0, tip = 0, lead = 0;
  int sides = 0;   ///< a turn
  int levels = 0;  ///< a lead
};
PolygonSoup bolt(const Thread& thread, double half);
/// A nut about it, its thread wider by `room` (m), `outer` (m) its radius.
PolygonSoup nut(const Thread& thread, double half, double room, double outer);

/// A plate with `across` × `across` round studs on it, `pitch` (m) apart, or with as many round
/// wells in it. z = 0 is the plate's face.
struct Studs {
  int across = 0, sides = 0;
  double pitch = 0, radius = 0, height = 0;
};
PolygonSoup studs(const Studs& of, double plate);
PolygonSoup wells(const Studs& of, double room, double plate);

/// Balls in sockets, studs in wells, nuts on bolts that jam, sheets in slots; three of each, of
/// other sizes and tessellations.
std::vector<FittedScene> joint_scenes();

}  // namespace sonde::test
