// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "app/commands.hpp"
#include "app/profiles.hpp"
#include "app/tuning_options.hpp"
#include "engine/study/tuning/traces.hpp"
#include "engine/study/tuning/traces_report.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::app {
namespace {

struct TracesOptions {
  TuningOptions common;
  std::vector<std::string> stiffness, damping;
  std::string kind;
  std::string hand = hand_grips[0].name;
};

std::vector<double> numbers(const std::vector<std::string>& texts) {
  std::vector<double> out;
  out.reserve(texts.size());
  for (const std::string& text : texts) out.push_back(parse_number(text).value());
  return out;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> out;
  for (const ContactKind kind : all_contact_kinds) out.emplace_back(name_of(kind));
  return out;
}

std::vector<std::string> hand_names() {
  std::vector<std::string> out;
  for (const HandGrip& grip : hand_grips) out.emplace_back(grip.name);
  return out;
}

void run(const TracesOptions& options) {
  const StudyOptions& output = options.common.study;
  check_output(output);
  refuse_other_things(output.out);
  const Scene scene = scene_of(options.common.bodies);
  const DeviceProfile device = device_named(options.common.device);
  ProgressLine progress(output.quiet);
  const Pair pair = load_bodies(scene, output.quiet, progress);
  TracesRequest request{.tuning = request_of(scene, options.common, pair, device)};
  if (!output.quiet) note_gains(scene.coupling, device, pair.probe().mass);
  request.stiffness = numbers(options.stiffness);
  request.damping = numbers(options.damping);
  if (!request.damping.empty() && main_axis(request.tuning) == GainAxis::object)
    throw UsageError("--b: the object norm has no damping; add --coupling classic or damped");
  for (const ContactKind kind : all_contact_kinds)
    if (options.kind == name_of(kind)) request.kind = kind;
  for (const HandGrip& grip : hand_grips)
    if (options.hand == grip.name) request.hand = grip;
  const Study study =
      plan_traces(request, stop_on_interrupt(), progress.percent("traces, looking for contacts"));
  progress.clear();
  run_study(study, output, traces_files);
  print_summary(output, false);
}

}  // namespace

Command add_traces_command(CLI::App& program) {
  const auto options = std::make_shared<TracesOptions>();
  CLI::App* parser = program.add_subcommand(
      "traces", "Force, torque and depth over time in one contact on a device, at several gains");
  add_flags(*parser, options->common);
  parser
      ->add_option("--k", options->stiffness,
                   "stiffnesses, N/m: 200,400; without it shares of what theory allows")
      ->delimiter(',')
      ->check(check_gain("k"));
  parser
      ->add_option("--b", options->damping,
                   "dampings of the classic or the damped coupling, N·s/m: 0,2; without it "
                   "shares of the device's largest")
      ->delimiter(',')
      ->check(check_gain("b_t"));
  parser
      ->add_option("--kind", options->kind,
                   "kind of the contact; without it the one that theory finds hardest")
      ->check(CLI::IsMember(kind_names()));
  parser->add_option("--hand", options->hand, "the hand that holds the device")
      ->check(CLI::IsMember(hand_names()))
      ->capture_default_str();
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
