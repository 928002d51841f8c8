// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/study/assembly/clash.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::size_t corner_of_grid(std::size_t row, std::size_t column, std::size_t columns) {
  return row * columns + column % columns;
}

/// A closed band of quads through profile points (radius, height), about z, in n steps; a radius is
/// that of the corners. The profile is closed, and runs anticlockwise with the radius to the right.
PolygonSoup turned(const std::vector<std::array<double, 2>>& profile, std::size_t n) {
  PolygonSoup out;
  for (const auto& [r, z] : profile)
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = test::two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
      out.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  for (std::size_t k = 0; k < profile.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (k + 1) % profile.size();
      out.polygons.push_back({corner_of_grid(k, i, n), corner_of_grid(k, i + 1, n),
                              corner_of_grid(next, i + 1, n), corner_of_grid(next, i, n)});
    }
  return out;
}

/// A plate or a ring with a hole through it: n corners to both, its walls in `rows` rows.
PolygonSoup holed(double inner, double outer, double height, std::size_t n, std::size_t rows = 1) {
  std::vector<std::array<double, 2>> profile;
  const auto level = [&](std::size_t k) {
    return height * (static_cast<double>(k) / static_cast<double>(rows) - 0.5);
  };
  for (std::size_t k = 0; k <= rows; ++k) profile.push_back({outer, level(k)});
  for (std::size_t k = rows + 1; k-- > 0;) profile.push_back({inner, level(k)});
  return turned(profile, n);
}

/// A prism of n sides about z.
PolygonSoup prism(double radius, double height, std::size_t n) {
  PolygonSoup out;
  std::vector<std::size_t> low, high;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = test::two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    for (const double z : {-0.5 * height, 0.5 * height})
      out.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    low.insert(low.begin(), 2 * i);
    high.push_back(2 * i + 1);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    out.polygons.push_back({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
  }
  out.polygons.push_back(low);
  out.polygons.push_back(high);
  return out;
}

/// A box with a cavity of another box.
PolygonSoup hollow(const Vec3& outer, const Vec3& inner) {
  PolygonSoup out = test::box(outer), cavity = test::box(inner);
  const std::size_t first = out.points.size();
  out.points.insert(out.points.end(), cavity.points.begin(), cavity.points.end());
  for (auto polygon : cavity.polygons) {
    for (auto& corner : polygon) corner += first;
    out.polygons.push_back({polygon.rbegin(), polygon.rend()});
  }
  return out;
}

/// An L of two walls that hold a block between them: a comb of one gap, from z = −depth to 0.
PolygonSoup slotted(double gap, double wall, double length, double depth) {
  const double a = 0.5 * gap, b = a + wall, l = 0.5 * length, base = depth + wall;
  const std::vector<std::array<double, 2>> outline{{-b, -base}, {b, -base},   {b, 0},  {a, 0},
                                                   {a, -depth}, {-a, -depth}, {-a, 0}, {-b, 0}};
  PolygonSoup out;
  std::vector<std::size_t> front, back;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (const double y : {-l, l}) out.points.push_back({outline[i][0], y, outline[i][1]});
    front.push_back(2 * i);
    back.insert(back.begin(), 2 * i + 1);
    const std::size_t j = (i + 1) % outline.size();
    out.polygons.push_back({2 * i, 2 * i + 1, 2 * j + 1, 2 * j});
  }
  out.polygons.push_back(front);
  out.polygons.push_back(back);
  return out;
}

struct FitCase {
  const char* name;
  PolygonSoup moving, holding;
  Vec3 at = Vec3::Zero();  ///< of the first in the frame of the second
};

Clash clash_of_fit(const FitCase& c, double allowance, const Pose& X = Pose()) {
  const std::vector<AssemblyPart> parts{
      {"moving", test::body(c.moving), X * Pose{Quat::Identity(), c.at}},
      {"holding", test::body(c.holding), X}};
  const auto found = clashes(parts, {.allowance = allowance, .threads = 1});
  return found.size() == 1 ? found[0] : Clash();
}

/// Fits whose moving part is larger by `proud` on every side that is held.
std::vector<FitCase> fits(double proud) {
  const auto corner = [&](std::size_t n) {  // how far a corner stands out where the sides do by 1
    return proud / std::cos(std::numbers::pi / static_cast<double>(n));
  };
  return {
      {"a square peg through a plate", prism(0.01 + corner(4), 0.06, 4),
       holed(0.01, 0.04, 0.02, 4)},
      {"a shaft in a ring", prism(0.05 + corner(24), 0.4, 24), holed(0.05, 0.06, 0.03, 24, 3)},
      {"a fine shaft in a ring", prism(2 + corner(60), 7, 60), holed(2, 2.5, 1, 60)},
      {"a block that fills a cavity", test::box(Vec3(0.5, 0.4, 0.3) + Vec3::Constant(2 * proud)),
       hollow({1, 0.9, 0.8}, {0.5, 0.4, 0.3})},
      {"a slab in a fork", test::box(Vec3(0.008 + 2 * proud, 0.03, 0.01)),
       slotted(0.008, 0.004, 0.02, 0.012), Vec3(0, 0, -0.006)}};
}

// Reference: the inside of the one is what is left free by the other, so nothing overlaps.
TEST(Fit, exact_fits_touch_wherever_they_stand) {
  std::mt19937_64 random(7);
  for (const FitCase& c : fits(0)) {
    for (int i = 0; i < 4; ++i) {
      const Pose X =
          i == 0 ? Pose() : Pose{test::random_rotation(random), test::random_in_ball(random, 3)};
      const Clash found = clash_of_fit(c, 0, X);
      EXPECT_EQ(found.kind, Clash::Kind::touching) << c.name << ", " << i;
      EXPECT_TRUE(found.fit) << c.name;
      EXPECT_TRUE(found.place) << c.name;
      EXPECT_GT(found.depth.value_or(0), 1e-3) << c.name << ": the way out";
      EXPECT_EQ(std::string(found.reason), "") << c.name;
    }
    EXPECT_EQ(clash_of_fit(c, 1e-4).kind, Clash::Kind::touching) << c.name;
  }
}

// Reference: the sides that are held overlap by just so much.
TEST(Fit, what_overlaps_by_the_allowance_touches_and_what_overlaps_by_more_does_not) {
  for (const double proud : {5e-7, 2e-5})
    for (const FitCase& c : fits(proud)) {
      EXPECT_EQ(clash_of_fit(c, 0).kind, Clash::Kind::overlapping) << c.name << ", " << proud;
      EXPECT_EQ(clash_of_fit(c, 0.999 * proud).kind, Clash::Kind::overlapping)
          << c.name << ", " << proud;
      EXPECT_FALSE(clash_of_fit(c, 0.999 * proud).fit) << c.name;
      EXPECT_EQ(clash_of_fit(c, 1.001 * proud).kind, Clash::Kind::touching)
          << c.name << ", " << proud;
      EXPECT_EQ(clash_of_fit(c, 20 * proud).kind, Clash::Kind::touching) << c.name << ", " << proud;
    }
}

// Reference: of polygons of n and of 2n corners on one circle, the corners between stand out of the
// sides by r (1 − cos(π / n)); the other way round, nothing does.
TEST(Fit, round_parts_cut_otherwise_overlap_by_the_height_of_the_chord) {
  for (const std::size_t n : {8, 12, 30}) {
    const double r = 0.03, rise = r * (1 - std::cos(std::numbers::pi / static_cast<double>(n)));
    // Corners of the coarse one stand at half steps: the fine one is turned to have them too.
    FitCase c{"a fine peg in a coarse ring", prism(r, 0.1, 2 * n), holed(r, 0.05, 0.02, n)};
    const double half = 0.5 * std::numbers::pi / static_cast<double>(n);
    const Quat turn(Eigen::AngleAxisd(half, Vec3::UnitZ()));
    for (Vec3& x : c.moving.points) x = turn * x;
    EXPECT_EQ(clash_of_fit(c, 0.99 * rise).kind, Clash::Kind::overlapping) << n;
    EXPECT_EQ(clash_of_fit(c, 1.01 * rise).kind, Clash::Kind::touching) << n;
    FitCase other{"a coarse peg in a fine ring", prism(r, 0.1, n), holed(r, 0.05, 0.02, 2 * n)};
    for (Vec3& x : other.moving.points) x = turn * x;
    EXPECT_EQ(clash_of_fit(other, 1e-9).kind, Clash::Kind::touching) << n;
  }
}

// Reference: a tip that is three allowances in the other is that deep in it, though the tip itself
// goes back by more than that where its faces are moved by one.
TEST(Fit, a_sharp_tip_that_is_deeper_than_the_allowance_overlaps) {
  for (const double size : {0.02, 0.3}) {
    const double allowance = 1e-3 * size;
    PolygonSoup needle = prism(0.1 * size, size, 6);
    for (Vec3& x : needle.points)
      if (x.z() < 0) x.head<2>() *= 1e-3;
    const FitCase c{"a needle", needle, test::box({size, size, size}),
                    Vec3(0.1 * size, 0, size - 3 * allowance)};
    EXPECT_EQ(clash_of_fit(c, allowance).kind, Clash::Kind::overlapping) << size;
    EXPECT_EQ(clash_of_fit(c, 3.1 * allowance).kind, Clash::Kind::touching) << size;
  }
}

// Reference: by the solid that is thick enough; where there is none, nothing is claimed.
TEST(Fit, a_part_that_is_too_thin_leaves_it_to_the_other) {
  for (const double thickness : {3e-5, 1e-4}) {
    const FitCase foil{"a foil in a slot", test::box({thickness, 0.03, 0.01}),
                       slotted(thickness - 1e-5, 0.004, 0.02, 0.012), Vec3(0, 0, -0.006)};
    EXPECT_EQ(clash_of_fit(foil, 1e-4).kind, Clash::Kind::touching);
    EXPECT_EQ(clash_of_fit(foil, 4e-6).kind, Clash::Kind::overlapping);
    const FitCase thin{"a foil in a slot of foils", test::box({thickness, 0.03, 0.01}),
                       slotted(thickness, thickness, 0.02, 0.012), Vec3(0, 0, -0.006)};
    // Sideways through a wall is no shorter than both are thick.
    const Clash found = clash_of_fit(thin, 0.8 * thickness);
    EXPECT_EQ(found.kind, Clash::Kind::overlapping);
    EXPECT_NE(std::string(found.reason).find("too thin"), std::string::npos);
  }
}

// Tubes without ends, one in the other, whose walls are the same: no wall has an inside.
TEST(Fit, of_surfaces_nothing_is_claimed) {
  for (const std::size_t n : {6, 24}) {
    FitCase c{"tubes", prism(0.1, 0.5, n), prism(0.1, 0.3, n)};
    for (PolygonSoup* tube : {&c.moving, &c.holding})
      tube->polygons.resize(tube->polygons.size() - 2);
    const Clash found = clash_of_fit(c, 1e-3);
    EXPECT_EQ(found.kind, Clash::Kind::overlapping);
    EXPECT_NE(std::string(found.reason).find("a surface"), std::string::npos);
    EXPECT_EQ(std::string(clash_of_fit(c, 0).reason), "");
  }
}

// Reference: by hand. What stands in the material overlaps, at whatever allowance is less.
TEST(Fit, what_is_inside_the_other_is_no_fit) {
  const FitCase inside{"a ball in a block", test::sphere(0.1, 8, 12), test::box({1, 1, 1})};
  EXPECT_EQ(clash_of_fit(inside, 0.05).kind, Clash::Kind::overlapping);
  const FitCase twice{"the same twice", test::box({0.1, 0.2, 0.3}), test::box({0.1, 0.2, 0.3})};
  EXPECT_EQ(clash_of_fit(twice, 0.01).kind, Clash::Kind::overlapping);
}

}  // namespace
}  // namespace sonde
