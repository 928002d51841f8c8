// SPDX-License-Identifier: GPL-3.0-or-later
// Deep concave pairs, whose nearest way out is long beside what overlaps and often narrow. What the
// search does with such poses was chosen with shapes like those of some families in sight; the
// others were added, and searched, after that.
#include <cmath>
#include <numbers>

#include "tests/reference/cases.hpp"
#include "tests/reference/meshes.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

constexpr double mm = 1e-3;
constexpr std::array<int, kinds> poses{0, 4, 12, 0};
constexpr int starts = 16;

MakeBody solid(const PolygonSoup& soup) {
  return [soup] { return test::body(soup); };
}
/// A plug, and the socket that it fits in with so much room, `outer` times as wide outside: open at
/// both ends, or with a floor.
MakeBody plug(const test::Section& section, double half) {
  return solid(test::fitted_plug(section, half, {}));
}
MakeBody socket(const test::Section& section, double room, double outer, double half,
                double floor = 0) {
  return solid(test::fitted_socket(test::grown(section, room), outer, half, {}, floor));
}
/// Open above, with walls of `wall`, and a drain of 5 % in its floor.
MakeBody cup(double radius, double height, double wall, int sides) {
  const double drain = 0.05 * radius;
  return [=] {
    return lathe({{drain, wall},
                  {drain, 0},
                  {radius, 0},
                  {radius, height},
                  {radius - wall, height},
                  {radius - wall, wall}},
                 sides);
  };
}

/// A star of so many points.
test::Section star(int points, double hollow, double tip) {
  test::Section out;
  for (int k = 0; k < 2 * points; ++k) {
    const double angle = std::numbers::pi * k / points, radius = k % 2 == 0 ? tip : hollow;
    out.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return out;
}

/// Two discs on a hub, with a bore.
MakeBody pulley(double hub, double disc, double width) {
  const double bore = 0.3 * hub, side = 0.2 * width;
  return [=] {
    return lathe({{bore, 0},
                  {disc, 0},
                  {disc, side},
                  {hub, side},
                  {hub, width - side},
                  {disc, width - side},
                  {disc, width},
                  {bore, width}},
                 26);
  };
}

std::vector<PairSpec> tuning_specs() {
  const test::Section keyed = test::keyed_section(14, 20 * mm, 27 * mm, 5 * mm),
                      toothed = test::toothed_section(7, 12 * mm, 18 * mm);
  std::vector<PairSpec> out;
  out.push_back({"cup-cup", cup(24 * mm, 30 * mm, 4 * mm, 24), cup(32 * mm, 38 * mm, 4 * mm, 30),
                 poses, starts});
  out.push_back({"comb-cup", [] { return comb(4, 5 * mm, 30 * mm); },
                 cup(32 * mm, 38 * mm, 4 * mm, 30), poses, starts});
  out.push_back({"hook-keyway", [] { return hook(20 * mm, 5 * mm, 40 * mm, 8, 10); },
                 socket(keyed, 0.4 * mm, 1.7, 30 * mm), poses, starts});
  out.push_back({"comb-combs", [] { return comb(5, 6 * mm, 40 * mm); },
                 [] { return comb(4, 6 * mm, 36 * mm); }, poses, starts});
  out.push_back({"spline-sleeve", plug(toothed, 9 * mm), socket(toothed, 1.2 * mm, 1.7, 13 * mm),
                 poses, starts});
  out.push_back({"key-channel",
                 solid(test::prism({{-11 * mm, -2.75 * mm},
                                    {2.2 * mm, -2.75 * mm},
                                    {2.2 * mm, -7.7 * mm},
                                    {6.6 * mm, -7.7 * mm},
                                    {6.6 * mm, 7.7 * mm},
                                    {2.2 * mm, 7.7 * mm},
                                    {2.2 * mm, 2.75 * mm},
                                    {-11 * mm, 2.75 * mm}},
                                   17 * mm)),
                 solid(test::prism({{-13 * mm, -11 * mm},
                                    {13 * mm, -11 * mm},
                                    {13 * mm, -4 * mm},
                                    {10.5 * mm, -4 * mm},
                                    {10.5 * mm, -8.5 * mm},
                                    {-10.5 * mm, -8.5 * mm},
                                    {-10.5 * mm, 8.5 * mm},
                                    {10.5 * mm, 8.5 * mm},
                                    {10.5 * mm, 4 * mm},
                                    {13 * mm, 4 * mm},
                                    {13 * mm, 11 * mm},
                                    {-13 * mm, 11 * mm}},
                                   30 * mm)),
                 poses, starts});
  out.push_back({"dumbbell-vase",
                 [] {
                   return lathe({{0.01 * mm, -10 * mm},
                                 {2.8 * mm, -9.4 * mm},
                                 {4.2 * mm, -6 * mm},
                                 {1.2 * mm, -2.5 * mm},
                                 {1.2 * mm, 2.5 * mm},
                                 {4.2 * mm, 6 * mm},
                                 {2.8 * mm, 9.4 * mm},
                                 {0.01 * mm, 10 * mm}},
                                14);
                 },
                 [] {
                   return lathe({{0.5 * mm, -9 * mm},
                                 {0.5 * mm, -10.5 * mm},
                                 {7 * mm, -10.5 * mm},
                                 {10 * mm, 0},
                                 {5 * mm, 7 * mm},
                                 {10 * mm, 12 * mm},
                                 {9 * mm, 12 * mm},
                                 {3.5 * mm, 7 * mm},
                                 {8.5 * mm, 0},
                                 {6 * mm, -9 * mm}},
                                22);
                 },
                 poses, starts});
  out.push_back({"coil-coil", [] { return coil(10 * mm, 7.5 * mm, 3, 2.2 * mm, 60, 8); },
                 [] { return coil(11.5 * mm, 9 * mm, 2.5, 2.5 * mm, 48, 9); }, poses, starts});
  const test::Section five = star(5, 8 * mm, 16 * mm),
                      dovetail = test::dovetail_section(14 * mm, 8 * mm, 4 * mm);
  out.push_back(
      {"star-ring", plug(five, 7 * mm), socket(five, 0.6 * mm, 1.6, 10 * mm), poses, starts});
  out.push_back({"dovetail-slide", plug(dovetail, 12 * mm),
                 socket(dovetail, 0.7 * mm, 1.7, 16 * mm), poses, starts});
  return out;
}

std::vector<PairSpec> reporting_specs() {
  const test::Section hexagon = test::regular_section(6, 11 * mm);
  std::vector<PairSpec> out;
  out.push_back({"hexagon-blind", plug(hexagon, 8 * mm),
                 socket(hexagon, 0.5 * mm, 1.8, 12 * mm, 6 * mm), poses, starts});
  out.push_back({"ring-pulley", [] { return test::body(test::torus(12 * mm, 2.5 * mm, 28, 12)); },
                 pulley(6 * mm, 15 * mm, 16 * mm), poses, starts});
  out.push_back(
      {"hook-knot", [] { return hook(12 * mm, 3 * mm, 22 * mm, 7, 9); },
       [] { return test::body(test::torus_knot(2, 5, 20 * mm, 8 * mm, 3.5 * mm, 90, 9)); }, poses,
       starts});
  // The first two of these were added after PushApart moved poses back into its ball, the third
  // after Starts::fitted chose the spin by sketches.
  const test::Section keyed = test::keyed_section(22, 15 * mm, 19 * mm, 3 * mm),
                      cross = test::toothed_section(4, 5 * mm, 14 * mm);
  out.push_back({"u-keyway",
                 solid(test::prism({{-9 * mm, -9 * mm},
                                    {9 * mm, -9 * mm},
                                    {9 * mm, 9 * mm},
                                    {5 * mm, 9 * mm},
                                    {5 * mm, -5 * mm},
                                    {-5 * mm, -5 * mm},
                                    {-5 * mm, 9 * mm},
                                    {-9 * mm, 9 * mm}},
                                   24 * mm)),
                 socket(keyed, 0.3 * mm, 1.5, 18 * mm), poses, starts});
  out.push_back({"trefoil-pulley",
                 [] { return test::body(test::torus_knot(2, 3, 14 * mm, 5 * mm, 2 * mm, 70, 8)); },
                 pulley(5 * mm, 13 * mm, 14 * mm), poses, starts});
  out.push_back({"cross-socket", plug(cross, 10 * mm),
                 socket(cross, 0.5 * mm, 1.5, 14 * mm, 5 * mm), poses, starts});
  return out;
}

}  // namespace

const std::vector<PairSpec>& deep_tuning_specs() {
  static const std::vector<PairSpec> all = tuning_specs();
  return all;
}
const std::vector<PairSpec>& deep_reporting_specs() {
  static const std::vector<PairSpec> all = reporting_specs();
  return all;
}

std::vector<const PairSpec*> known_specs() {
  std::vector<const PairSpec*> out;
  for (const auto* specs : {&pair_specs(), &deep_tuning_specs(), &deep_reporting_specs()})
    for (const PairSpec& spec : *specs) out.push_back(&spec);
  return out;
}

}  // namespace sonde::reference
