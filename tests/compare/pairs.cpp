// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/compare/pairs.hpp"

#include <cmath>
#include <filesystem>

#include "engine/proximity/queries/intersect.hpp"
#include "engine/settings/device_profile.hpp"
#include "engine/text/number_text.hpp"
#include "resources/generate/path.hpp"
#include "tests/reference/meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

using MakeBody = std::function<std::shared_ptr<const Body>()>;

constexpr double rate_hz = 1000;
/// A servo has no time for more: what a tick leaves open, the next goes on with.
constexpr int steps_of_a_tick = 10;

/// Whom the largest stable stiffness is of.
void put_on_a_device(CompareSetup& setup) {
  setup.device = simulated(read_device_profile(std::string(SONDE_DEVICES) + "/sigma.7.json"));
  setup.sample_time = 1 / rate_hz;
}

CompareSetup of_scene(const std::string& name) {
  const std::filesystem::path folder(SONDE_SCENES);
  const Scene scene = read_scene(folder / (name + ".sonde.json"));
  const Pair pair(load(scene.probe, scene.unit), load(scene.fixed, scene.unit));
  CompareSetup out{.render = {.pair = pair}};
  out.scene = name;
  out.render.coupling = scene.coupling;
  out.render.budget.steps = steps_of_a_tick;
  out.path = read_trajectory(*scene.trajectory);
  // Some 200 contacts over a wide area, each felt in many directions: that would take an hour.
  if (name != "nut-on-bolt") put_on_a_device(out);
  return out;
}

/// How far along −out, from a place beyond both bodies, the probe first overlaps, m.
double first_contact(const Body& probe, const Body& fixed, const Vec3& centre, const Vec3& out,
                     double far) {
  const auto overlaps = [&](double s) {
    return triangles_meet(probe, fixed, Transform(Pose{Quat::Identity(), centre + s * out}),
                          Doubt::contact);
  };
  double s = far;
  while (s > 0 && !overlaps(s)) s -= 0.002 * far;
  return std::max(s, 0.0);
}

/// In, along and round, and out again, from a random side.
std::vector<TimedPose> press_and_slide(const Body& probe, const Body& fixed, std::uint64_t seed,
                                       const std::optional<Vec3>& side) {
  std::mt19937_64 random(seed);
  const Vec3 out = side ? *side : Vec3(random_in_ball(random, 1).normalized());
  const double r = probe.mass.radius;
  const Vec3 centre = fixed.mass.com - probe.mass.com;
  const double touch = first_contact(probe, fixed, centre, out, fixed.mass.radius + 1.1 * r);
  const Vec3 along = out.unitOrthogonal(), across = out.cross(along);
  const auto at = [&](double depth, double x, double y) {
    return Vec3(centre + (touch - depth * r) * out + r * (x * along + y * across));
  };
  const auto turn = [&](double degrees) {
    return Vec3(degrees * random_in_ball(random, 1).normalized());
  };
  generate::Path path(at(-0.3, 0, 0), Vec3::Zero());
  path.hold(0.1)
      .via(0.5, at(0.15, 0, 0), turn(5))
      .via(0.6, at(0.33, 0.1, 0), turn(15))
      .via(0.6, at(0.30, 0.3, 0.1), turn(25))
      .via(0.6, at(0.20, 0.1, 0.3), turn(30))
      .via(0.6, at(0.33, -0.2, 0.1), turn(20))
      .via(0.5, at(0.15, -0.1, 0), turn(10))
      .home(0.5)
      .hold(0.1);
  std::vector<TimedPose> samples;
  const auto count = static_cast<int>(std::floor(path.duration() * rate_hz));
  for (int i = 0; i <= count; ++i) samples.push_back({i / rate_hz, path.at(i / rate_hz)});
  return samples;
}

ComparedPair made(const std::string& name, const MakeBody& probe, const MakeBody& fixed,
                  std::uint64_t seed, const std::optional<Vec3>& side = {}) {
  return {name, [=] {
            CompareSetup out{.render = {.pair = {probe(), fixed()}}};
            out.scene = name;
            out.render.budget.steps = steps_of_a_tick;
            out.path =
                press_and_slide(out.render.pair.probe(), out.render.pair.fixed(), seed, side);
            put_on_a_device(out);
            return out;
          }};
}

MakeBody real(const std::string& file, double radius) {
  return [=] { return reference::real(file, radius); };
}

}  // namespace

std::vector<ComparedPair> compared_pairs() {
  std::vector<ComparedPair> out;
  for (const char* scene : {"spoon-in-cup", "peg-in-hole", "nut-on-bolt", "linked-tori",
                            "torus-knots", "crumpled-soup", "terrain"})
    out.push_back({scene, [=] { return of_scene(scene); }});
  out.push_back(made("joint on eight", real("joint.off", 0.05), real("eight.off", 0.1), 1));
  out.push_back(made("part on nefertiti", real("part.off", 0.05), real("nefertiti.off", 0.1), 2));
  out.push_back(made("anchor on rotor", real("anchor.off", 0.05), real("rotor.off", 0.1), 3));
  out.push_back(made("cow on triceratops", real("cow.off", 0.05), real("triceratops.off", 0.1), 4));
  out.push_back(
      made("elephant on elephant", real("elephant.off", 0.05), real("elephant.off", 0.1), 5));
  out.push_back(made("pinion on pinion", real("pinion.off", 0.05), real("pinion.off", 0.1), 6));
  const MakeBody block = [] { return body(box({0.8, 0.8, 0.4})); };
  const MakeBody ball = [] { return body(sphere(0.05, 16, 32)); };
  const MakeBody brick = [] { return body(box({0.03, 0.05, 0.07})); };
  const Vec3 up = Vec3::UnitZ();
  out.push_back(made("joint on a large box", real("joint.off", 0.05), block, 7, up));
  out.push_back(made("brick on a large box", brick, block, 8, up));
  out.push_back(made("ball on a large box", ball, block, 9, up));
  out.push_back(made("ball on eight", ball, real("eight.off", 0.1), 10));
  return out;
}

Comparison compare_pair(const ComparedPair& pair) {
  const Study study = compare_study(pair.setup());
  StudyFolder folder{study.kind, study.about, {}, {}};
  for (const StudyPart& part : study.parts) {
    folder.names.push_back(part.name);
    folder.results.push_back(part.compute([] { return false; }));
  }
  return comparison_of(pair.name, folder);
}

namespace {

std::string short_number(double x) { return number_text(x, 3); }

/// "PD_t / PD_g" of one measure.
template <class Of>
std::string pair_of(const Comparison& c, const Of& of) {
  return of(c.of_pdt) + " / " + of(c.of_pdg);
}

std::string parts_in_10000(const std::optional<double>& share) {
  return share ? short_number(1e4 * *share) : "–";
}

}  // namespace

std::string table_head() {
  return "| pair | contact, s | ∑\\|ΔF\\|, N | >50 Hz of F, ‱ | ∑\\|Δτ\\|, mN·m | >50 Hz of τ, ‱ | "
         "steps of F | steps of τ | jumps | pop-throughs | error of τ, % | stable k, N/m |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string table_row(const std::string& name, const Comparison& c) {
  using M = const MethodMeasures&;
  const auto whole = [](int n) { return std::to_string(n); };
  std::string out = "| " + name;
  const auto cell = [&](const std::string& text) { out.append(" | ").append(text); };
  cell(short_number(c.of_pdg.contact_ticks / rate_hz));
  cell(pair_of(c, [](M m) { return short_number(m.force_variation); }));
  cell(pair_of(c, [](M m) { return parts_in_10000(m.force_above_50); }));
  cell(pair_of(c, [](M m) { return short_number(1e3 * m.torque_variation); }));
  cell(pair_of(c, [](M m) { return parts_in_10000(m.torque_above_50); }));
  cell(pair_of(c, [&](M m) { return whole(m.discontinuities.force_steps); }));
  cell(pair_of(c, [&](M m) { return whole(m.discontinuities.torque_steps); }));
  cell(pair_of(c, [&](M m) { return whole(m.discontinuities.jumps); }));
  cell(pair_of(c, [&](M m) { return whole(m.discontinuities.pop_throughs); }));
  cell(c.of_pdg.realism.ticks == 0 ? "none" : pair_of(c, [](M m) {
    return short_number(100 * m.realism.torque_error);
  }));
  cell(pair_of(c, [](M m) {
    return m.stiffness.stable ? short_number(*m.stiffness.stable) : std::string("none");
  }));
  return out + " |\n";
}

}  // namespace sonde::test
