// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/study_run.hpp"
#include "engine/study/assembly/insertion_report.hpp"

namespace sonde::app {
namespace {

struct InsertOptions {
  BodyOptions bodies;
  StudyOptions study;
  std::vector<double> axis, lateral;
  std::optional<double> travel, wanted;
  double twist = 0;  ///< degrees
  std::string trajectory;
  std::size_t steps = 200;
  std::size_t offsets = 0, tilts = 1;
  double largest_offset = 0, largest_tilt = 0;  ///< m, degrees
};

constexpr double per_degree = std::numbers::pi / 180;

Vec3 vector_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// A map of one and the same point, or one that is not asked for, is a mistake.
void check_map(const InsertOptions& options) {
  const bool wants_map = options.offsets > 0;
  if (wants_map && options.axis.empty()) throw UsageError("--offsets are about an --axis");
  if (!wants_map && (options.tilts > 1 || options.largest_offset > 0 || options.largest_tilt > 0 ||
                     !options.lateral.empty()))
    throw UsageError(
        "--offset-range, --tilts, --tilt-range and --lateral are of a map: give "
        "--offsets");
  if (options.offsets > 1 && !(options.largest_offset > 0))
    throw UsageError("--offsets need an --offset-range above zero");
  if (options.tilts > 1 && !(options.largest_tilt > 0))
    throw UsageError("--tilts need a --tilt-range above zero");
}

void check_axis(const InsertOptions& options) {
  const Vec3 axis = vector_of(options.axis);
  if (!axis.allFinite() || axis.isZero(0))
    throw UsageError("--axis must be three finite numbers, not all 0");
  if (!std::isfinite(options.twist)) throw UsageError("--twist must be a finite number");
}

void check(const InsertOptions& options) {
  const bool along = !options.axis.empty();
  if (along == !options.trajectory.empty())
    throw UsageError("give either --axis with --travel, or --trajectory");
  if (along && !options.travel) throw UsageError("--axis needs --travel");
  if (!along && (options.travel || options.twist != 0))
    throw UsageError("--travel and --twist are of a way along an --axis");
  if (along) check_axis(options);
  check_map(options);
}

/// Square to the axis: as asked for, or along the coordinate that the axis has least of.
Vec3 lateral_of(const InsertOptions& options, const Vec3& axis) {
  if (options.lateral.empty()) return lateral_to(axis);
  const Vec3 wanted = vector_of(options.lateral);
  if (!wanted.allFinite() || wanted.isZero(0))
    throw UsageError("--lateral must be three finite numbers, not all 0");
  const std::optional<Vec3> square = square_to(axis, wanted);
  if (!square) throw UsageError("--lateral must not lie along the --axis");
  return *square;
}

/// What is many times as far as both bodies are large was hardly meant in metres.
void doubt_length(const char* flag, double metres, double large) {
  constexpr double many = 10;
  if (!(metres > many * large)) return;
  std::cerr << "sonde: " << flag << ' ' << number_text(metres, 6) << " is "
            << number_text(metres / large, 2)
            << " times as far as both bodies are large: lengths are in metres; " << flag << ' '
            << number_text(metres / 1000, 6) << " would be millimetres\n";
}

void doubt_lengths(const InsertOptions& options, const Pair& pair, const Pose& start) {
  const MassProperties &probe = pair.probe().mass, &fixed = pair.fixed().mass;
  const double apart = (start * probe.com - fixed.com).norm();
  const double large = apart + probe.radius + fixed.radius;
  doubt_length("--travel", options.travel.value_or(0), large);
  doubt_length("--offset-range", options.largest_offset, large);
}

std::vector<Pose> poses_of(const std::vector<TimedPose>& path) {
  std::vector<Pose> out;
  out.reserve(path.size());
  for (const TimedPose& at : path) out.push_back(at.pose);
  return out;
}

void run(const InsertOptions& options) {
  check(options);
  check_output(options.study);
  refuse_other_things(options.study.out);
  Scene scene = scene_of(options.bodies);
  scene.trajectory.reset();
  take_trajectory(scene, options.trajectory);
  std::vector<Pose> path;
  if (scene.trajectory) path = poses_of(path_to_study(scene));
  const Pair pair = load_bodies(scene, options.study.quiet);

  InsertionRequest request{
      .pair = pair, .way = {}, .coupling = scene.coupling, .map = {}, .about = {}};
  request.steps = options.steps;
  const Pose start = relative_pose(scene);
  request.way = options.axis.empty() ? way_through(pair, path)
                                     : way_along(pair, start, vector_of(options.axis),
                                                 *options.travel, per_degree * options.twist);
  {
    ProgressLine line(options.study.quiet);
    // What cannot be computed is refused before anything is written.
    check_way(pair, request.way, line.percent("looking at the way"));
  }
  doubt_lengths(options, pair, start);
  const double travel = request.way.travel.back();
  request.wanted = options.wanted.value_or(travel);
  if (request.wanted > travel * (1 + 1e-9))
    throw UsageError("--wanted " + number_text(request.wanted, 6) +
                     " m is more than the way's travel of " + number_text(travel, 6) +
                     " m: no place of it would count as in");
  nlohmann::ordered_json about{
      {"inputs", study_inputs(scene, pair)},
      {"start",
       {start.p.x(), start.p.y(), start.p.z(), start.q.w(), start.q.x(), start.q.y(), start.q.z()}},
      {"axis", options.axis},
      {"travel", travel},
      {"twist", per_degree * options.twist},
      {"steps", options.steps},
      {"wanted", request.wanted},
      {"k", scene.coupling.k},
      {"k_t", scene.coupling.k_t},
      {"k_r", scene.coupling.k_r}};
  if (options.offsets > 0) {
    InsertionMap map;
    map.axis = vector_of(options.axis).stableNormalized();
    map.lateral = lateral_of(options, map.axis);
    map.offsets = options.offsets;
    map.tilts = options.tilts;
    map.largest_offset = options.largest_offset;
    map.largest_tilt = per_degree * options.largest_tilt;
    request.map = map;
    about["lateral"] = {map.lateral.x(), map.lateral.y(), map.lateral.z()};
    about["offsets"] = map.offsets;
    about["tilts"] = map.tilts;
    about["largest_offset"] = map.largest_offset;
    about["largest_tilt"] = map.largest_tilt;
  }
  request.about = about.dump();
  run_study(plan_insertion(request), options.study, insertion_files);
  print_summary(options.study, false);
}

}  // namespace

Command add_insert_command(CLI::App& program) {
  const auto options = std::make_shared<InsertOptions>();
  CLI::App* parser = program.add_subcommand(
      "insert", "How a part goes in along an axis, a screw or a path: room, force, where it binds");
  add_scene_or_meshes(*parser, options->bodies);
  parser
      ->add_option("--axis", options->axis,
                   "X,Y,Z: the direction, in the fixed body's frame, from the scene's pose on")
      ->delimiter(',')
      ->expected(3);
  parser->add_option("--travel", options->travel, "how far along the axis, m")
      ->check(check_positive);
  parser
      ->add_option(
          "--twist", options->twist,
          "degrees by which it turns on the way, about the axis through its centre of mass")
      ->capture_default_str();
  parser->add_option("--trajectory", options->trajectory, "a path to go along instead of an axis");
  parser->add_option("--steps", options->steps, "rows along the way, more about the first contact")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
      ->capture_default_str();
  parser
      ->add_option("--wanted", options->wanted, "travel that counts as in, m; without it all of it")
      ->check(check_positive);
  const char* group = "The map of offsets and tilts";
  const auto number = [] { return CLI::Range(std::size_t{1}, std::size_t{10'001}); };
  parser->add_option("--offsets", options->offsets, "how many offsets; without it there is no map")
      ->check(number())
      ->group(group);
  parser
      ->add_option("--offset-range", options->largest_offset,
                   "the largest offset to either side, m")
      ->check(check_not_negative)
      ->group(group);
  parser->add_option("--tilts", options->tilts, "how many tilts")
      ->check(number())
      ->capture_default_str()
      ->group(group);
  parser
      ->add_option("--tilt-range", options->largest_tilt,
                   "the largest tilt to either side, degrees, in the plane of axis and offset")
      ->check(check_not_negative)
      ->group(group);
  parser
      ->add_option("--lateral", options->lateral,
                   "X,Y,Z: the direction of the offsets; without it the coordinate that the axis "
                   "has least of")
      ->delimiter(',')
      ->expected(3)
      ->group(group);
  add_flags(*parser, options->study);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
