// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/commands.hpp"
#include "app/profiles.hpp"
#include "app/tuning_notes.hpp"
#include "app/tuning_options.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "engine/study/tuning/tuning_study.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::app {
namespace {

struct TuneOptions {
  TuningOptions common;
  double ratio = 1.02;
  double low = 1, high = 1e5;
  bool trusts_friction = false;
  bool always_held = false;
};

void run(const TuneOptions& options) {
  const StudyOptions& output = options.common.study;
  check_output(output);
  refuse_other_things(output.out);
  if (!(options.low < options.high)) throw UsageError("--from must be below --to");
  const Scene scene = scene_of(options.common.bodies);
  const DeviceProfile device = device_named(options.common.device);
  ProgressLine progress(output.quiet);
  const Pair pair = load_bodies(scene, output.quiet, progress);
  TuningRequest request = request_of(scene, options.common, pair, device);
  if (!output.quiet) note_gains(scene.coupling, device, pair.probe().mass);
  request.ratio = options.ratio;
  request.trusts_friction = options.trusts_friction;
  request.always_held = options.always_held;
  request.low = options.low;
  request.high = options.high;
  const auto plan = study_plan(request, threads_of(output), stop_on_interrupt(),
                               progress.percent("tune, contacts and a first look"));
  progress.clear();
  const Study study = plan_tuning(plan);
  if (output.quiet) return run_study(study, output, tuning_files);
  note_skipped(study);
  claim_folder(output.out, study);  // what is refused is told no first look
  TuningNotes notes(plan, output);
  notes.tell_first_look();
  run_study(study, output, tuning_files, [&](ProgressLine& line) { notes.look_again(line); });
  notes.conclude();
}

std::string check_ratio(const std::string& text) {
  const auto ratio = parse_number(text);
  return ratio && *ratio >= 1.0001 && *ratio <= 2 ? ""
                                                  : "\"" + text + "\" must be from 1.0001 to 2";
}

}  // namespace

Command add_tune_command(CLI::App& program) {
  const auto options = std::make_shared<TuneOptions>();
  CLI::App* parser = program.add_subcommand(
      "tune", "Measures how stiff a coupling on a device may be in a scene; recommends gains");
  add_flags(*parser, options->common);
  parser
      ->add_option(
          "--ratio", options->ratio,
          "search limits until the failing stiffness is at most this many times the holding one, "
          "at the damping that allows most; at others to its fifth power")
      ->check(check_ratio)
      ->capture_default_str();
  parser->add_option("--from", options->low, "least stiffness studied, N/m")
      ->check(check_gain("k"))
      ->capture_default_str();
  parser->add_option("--to", options->high, "largest stiffness studied, N/m")
      ->check(check_gain("k"))
      ->capture_default_str();
  parser->add_flag("--trust-friction", options->trusts_friction,
                   "recommend gains that are stable only thanks to the profile's friction");
  parser->add_flag("--always-held", options->always_held,
                   "recommend gains at which the handle may be unstable once the hand lets go");
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
