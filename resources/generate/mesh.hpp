// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde::generate {

constexpr double two_pi = 2 * std::numbers::pi;

/// A closed or open polyline of points, in metres.
using Ring = std::vector<Vec3>;

struct Point2 {
  double x = 0;
  double y = 0;
};
using Outline = std::vector<Point2>;

/// How the rings of a loft end: left open, closed by a fan about a point, or joined last to first.
enum class Ends { open, capped, joined };

/// The skin over a stack of closed rings with the same number of points. Seen from outside, the
/// points run anticlockwise about the direction in which the rings advance. Capped: fans about
/// `first` and `last`; a cap may be a plain point where the rings narrow to a pole.
Soup loft(const std::vector<Ring>& rings, Ends ends, const Vec3& first = Vec3::Zero(),
          const Vec3& last = Vec3::Zero());

/// A closed grid of n by m points that wraps in both directions, u and v in [0, 2π).
Soup wrapped_grid(int n, int m, const std::function<Vec3(double u, double v)>& point);

/// A torus about the z axis.
Soup torus(double major, double minor, int major_steps, int minor_steps);

/// A sphere of unit radius from a subdivided icosahedron: 20·4^levels triangles of like size.
Soup icosphere(int levels);

/// Puts an outline at the height z.
Ring at_height(const Outline& outline, double z);

/// `count` points evenly spaced along an open polyline, both ends among them.
Outline resample(const Outline& line, int count);

/// Adds an arc about `center` from angle `from` to `to` (rad), both ends among its points.
void add_arc(Outline& line, Point2 center, double radius, double from, double to, int steps);

/// Joins b to a.
void append(Soup& a, const Soup& b);

/// Without the vertices that no triangle uses, in the order of their first use.
Soup compacted(const Soup& soup);

/// 0 below a, 1 above b, smooth between (first and second derivatives zero at both).
double smooth_step(double a, double b, double x);

/// A small generator of numbers whose sequence is the same everywhere (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double low, double high);

 private:
  std::uint64_t state_;
};

/// Smooth noise of a point, about -1 to 1, with features of unit size.
double noise(const Vec3& x, std::uint64_t seed);

/// A sum of `octaves` of noise, each at twice the frequency and `gain` times the height.
double fractal_noise(const Vec3& x, int octaves, double gain, std::uint64_t seed);

}  // namespace sonde::generate
