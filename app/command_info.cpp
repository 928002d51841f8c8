// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/mesh_options.hpp"
#include "app/mesh_report.hpp"
#include "app/recordings.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

struct InfoOptions {
  std::vector<std::string> meshes;
  MeshOptions reading;
  std::string within;  ///< the folder that a recording's paths stay in, or empty
  OutputOptions output;
};

/// All the meshes, or an InputError that gives the reason for every bad one.
std::vector<std::shared_ptr<const Body>> load_all(const InfoOptions& options) {
  ProgressLine progress(options.output.quiet);
  std::vector<std::shared_ptr<const Body>> bodies;
  std::string reason;  // the last; those before are told of
  for (const std::string& mesh : options.meshes) {
    try {
      bodies.push_back(load(mesh, options.reading, progress.percent("reading " + mesh)));
    } catch (const InputError& error) {
      progress.clear();
      if (!reason.empty()) std::cerr << "sonde: " << printable(reason) << '\n';
      reason = error.what();
    }
  }
  if (!reason.empty()) throw InputError(reason);
  return bodies;
}

void describe_recordings(const InfoOptions& options) {
  std::vector<std::unique_ptr<Recording>> recordings;
  ProgressLine progress(options.output.quiet);
  for (const std::string& file : options.meshes)
    recordings.push_back(recording_at(file, options.within, progress.percent("reading " + file)));
  progress.clear();
  write_result(options.output, options.output.json ? to_json(recordings) : to_text(recordings));
}

void run(const InfoOptions& options) {
  check_output(options.output, {options.meshes.begin(), options.meshes.end()});
  const auto recordings = std::ranges::count_if(
      options.meshes, [](const std::string& file) { return is_recording(file); });
  if (recordings == std::ssize(options.meshes)) return describe_recordings(options);
  if (recordings > 0) throw UsageError("give meshes or recordings, not both at once");
  const auto bodies = load_all(options);
  std::vector<MeshReport> reports;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    reports.push_back({options.meshes[i], *bodies[i]});
  std::optional<Between> lie;
  if (bodies.size() == 2) {
    ProgressLine progress(options.output.quiet);
    lie = between(bodies[0], bodies[1], progress.percent("how deep they overlap"));
  }
  write_result(options.output, options.output.json ? to_json(reports, lie) : to_text(reports, lie));
}

}  // namespace

Command add_info_command(CLI::App& program) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* parser = program.add_subcommand(
      "info", "Describes meshes (counts, model, mass properties, bounds, defects) or recordings");
  parser
      ->add_option("MESH", options->meshes,
                   "Mesh files (OFF, OBJ, PLY, STL, GLB, glTF, 3MF, DAE), or recordings")
      ->required();
  add_flags(*parser, options->reading, "each");
  add_within(*parser, options->within);
  add_flags(*parser, options->output);
  parser->get_option("--json")->description("write JSON instead of text");
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
