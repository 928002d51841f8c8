// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of meshes: generated ones, real ones, and models of the example scenes.
#include <map>
#include <numbers>
#include <stdexcept>

#include "tests/reference/cases.hpp"
#include "tests/reference/meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

constexpr double quarter = std::numbers::pi / 2;

Quat turn_about(const Vec3& axis, double angle) { return Quat(Eigen::AngleAxisd(angle, axis)); }

Quat quaternion(double w, double x, double y, double z) { return Quat(w, x, y, z).normalized(); }

MakeBody ring() {
  return [] { return test::body(test::torus(0.07, 0.02, 32, 16)); };
}
MakeBody trefoil() {
  return [] { return test::body(test::torus_knot(2, 3, 0.036, 0.0135, 0.009, 80, 10)); };
}
MakeBody rod() {
  return [] { return test::body(test::box({0.024, 0.036, 0.096})); };
}
MakeBody eggs(double half_length, int rings) {
  return [=] { return egg(half_length, rings); };
}
MakeBody hooks() {
  return [] { return hook(0.04, 0.012, 0.08, 12, 12); };
}
MakeBody combs() {
  return [] { return comb(6, 0.008, 0.045); };
}
MakeBody small_ring() {
  return [] { return test::body(test::torus(0.025, 0.006, 32, 12)); };
}
MakeBody dumbbells() {
  return [] { return dumbbell(0.08, 0.01, 0.028); };
}
MakeBody triangles(int count, std::uint64_t seed) {
  return [=] { return loose_triangles(count, 0.1, seed); };
}
MakeBody mesh(const char* file, double radius = 0.1) {
  return [=] { return real(file, radius); };
}
MakeBody scene(const char* file) {
  return [=] { return model(file); };
}

void add_generated(std::vector<PairSpec>& out) {
  out.push_back({"egg-egg", eggs(0.1, 18), eggs(0.1, 18), {2, 3, 4, 0}});
  out.push_back({"rod-egg", rod(), eggs(0.07, 18), {2, 3, 4, 0}});
  out.push_back({"ring-ring",
                 ring(),
                 ring(),
                 {2, 3, 3, 4},
                 400,
                 {turn_about(Vec3::UnitX(), quarter), {0.07, 0, 0}}});
  out.push_back({"trefoil-trefoil",
                 trefoil(),
                 trefoil(),
                 {2, 3, 3, 4},
                 400,
                 {quaternion(0.833698198, -0.170512251, 0.129325717, 0.509065561),
                  {0.0696, 0.0049, 0.0191}}});
  out.push_back({"rod-trefoil", rod(), trefoil(), {2, 4, 4, 0}});
  out.push_back({"hook-hook",
                 hooks(),
                 hooks(),
                 {2, 3, 2, 5},
                 400,
                 {turn_about(Vec3::UnitY(), quarter) * turn_about(Vec3::UnitX(), 2 * quarter),
                  {0, -0.06, 0}}});
  out.push_back({"comb-comb",
                 combs(),
                 combs(),
                 {2, 2, 3, 5},
                 400,
                 {turn_about(Vec3::UnitZ(), 2 * quarter), {0.009, 0.05, 0}}});
  out.push_back({"ring-dumbbell", small_ring(), dumbbells(), {2, 2, 2, 5}});
  out.push_back({"soup-soup", triangles(1000, 1), triangles(1000, 2), {2, 5, 4, 0}});
  out.push_back({"soup-ring", triangles(1000, 1), ring(), {2, 4, 4, 0}});
}

void add_real(std::vector<PairSpec>& out) {
  out.push_back({"joint-eight", mesh("joint.off"), mesh("eight.off"), {2, 4, 4, 0}});
  out.push_back({"part-nefertiti", mesh("part.off"), mesh("nefertiti.off"), {2, 4, 4, 0}});
  out.push_back({"eight-eight",
                 mesh("eight.off"),
                 mesh("eight.off"),
                 {2, 3, 3, 4},
                 400,
                 {turn_about(Vec3::UnitZ(), quarter), {0, 0, 0.14}}});
  out.push_back({"nefertiti-mask", mesh("nefertiti.off"), mesh("mask_cone.off"), {2, 3, 4, 0}});
  out.push_back({"anchor-rotor", mesh("anchor.off"), mesh("rotor.off"), {2, 4, 4, 0}});
  out.push_back({"pinion-pinion", mesh("pinion.off"), mesh("pinion.off"), {2, 2, 3, 0}, 150});
  out.push_back({"joint-knot", mesh("joint.off", 0.07), mesh("knot1.off"), {2, 3, 3, 0}, 300});
  out.push_back(
      {"elephant-elephant", mesh("elephant.off"), mesh("elephant.off"), {2, 3, 3, 0}, 300});
  out.push_back({"cow-triceratops", mesh("cow.off"), mesh("triceratops.off"), {2, 3, 3, 0}, 300});
  out.push_back({"joint-camel", mesh("joint.off", 0.015), mesh("camel.off"), {2, 3, 3, 0}, 300});
  out.push_back({"hand-bunny", mesh("hand.off", 0.05), mesh("bunny00.off"), {2, 2, 2, 0}, 150});
  out.push_back({"camel-armadillo", mesh("camel.off"), mesh("armadillo.off"), {2, 2, 2, 0}, 100});
}

void add_scenes(std::vector<PairSpec>& out) {
  out.push_back({"spoon-cup",
                 scene("spoon.ply"),
                 scene("cup.ply"),
                 {2, 2, 0, 4},
                 100,
                 {quaternion(0.817674921, -0.060865477, 0.086877151, 0.565822832),
                  {0.017257015, 0.004839506, 0.036143659}}});
  out.push_back({"nut-bolt",
                 scene("nut.ply"),
                 scene("bolt.ply"),
                 {2, 1, 1, 2},
                 300,
                 {quaternion(0.182235377, 8.48e-05, 8.48e-05, 0.983254928), {1e-4, 0, 0.032}},
                 0.1,
                 0.05});
  out.push_back({"peg-block",
                 scene("peg.ply"),
                 scene("block.ply"),
                 {2, 1, 1, 2},
                 300,
                 {quaternion(0.999719027, 0.005407859, 0.02307497, -0.00040936),
                  {0.000459259, 0.000422222, -0.021493827}},
                 0.1,
                 0.05});
  out.push_back({"star-crumpled", scene("star.ply"), scene("crumpled.ply"), {2, 3, 2, 0}, 300});
  out.push_back({"boulder-ground", scene("boulder.ply"), scene("ground.ply"), {4, 3, 0, 0}, 300});
}

}  // namespace

const std::vector<PairSpec>& pair_specs() {
  static const std::vector<PairSpec> all = [] {
    std::vector<PairSpec> out;
    add_generated(out);
    add_real(out);
    add_scenes(out);
    return out;
  }();
  return all;
}

std::string family_of(const std::string& pair) {
  static const std::map<std::string, std::string> families{
      {"egg-egg", "engineered"},      {"rod-egg", "engineered"},
      {"comb-comb", "engineered"},    {"joint-eight", "engineered"},
      {"anchor-rotor", "engineered"}, {"pinion-pinion", "engineered"},
      {"eight-eight", "engineered"},  {"ring-ring", "tangled"},
      {"trefoil-trefoil", "tangled"}, {"rod-trefoil", "tangled"},
      {"hook-hook", "tangled"},       {"ring-dumbbell", "tangled"},
      {"joint-knot", "tangled"},      {"coil-coil", "tangled"},
      {"ring-pulley", "tangled"},     {"hook-knot", "tangled"},
      {"soup-soup", "soups"},         {"soup-ring", "soups"},
      {"star-crumpled", "soups"},     {"boulder-ground", "thin"},
      {"spoon-cup", "thin"},          {"nefertiti-mask", "scanned"},
      {"part-nefertiti", "scanned"},  {"elephant-elephant", "scanned"},
      {"cow-triceratops", "scanned"}, {"joint-camel", "scanned"},
      {"hand-bunny", "scanned"},      {"camel-armadillo", "scanned"},
      {"nut-bolt", "fits"},           {"peg-block", "fits"},
      {"cup-cup", "nested"},          {"dumbbell-vase", "nested"},
      {"comb-cup", "nested"},         {"hook-keyway", "fits"},
      {"comb-combs", "tangled"},      {"spline-sleeve", "fits"},
      {"key-channel", "fits"},        {"hexagon-blind", "fits"},
      {"dovetail-slide", "fits"},     {"star-ring", "fits"},
      {"u-keyway", "fits"},           {"cross-socket", "fits"},
      {"trefoil-pulley", "tangled"}};
  const auto found = families.find(pair);
  if (found == families.end()) throw std::out_of_range(pair + ": a pair of no family");
  return found->second;
}

}  // namespace sonde::reference
