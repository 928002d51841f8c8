// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study_run.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <thread>

#include "app/interrupt.hpp"
#include "engine/base/error.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/printable.hpp"
#include "engine/text/text_file.hpp"

namespace sonde::app {

std::string check_shard(const std::string& text) {
  return shard_of(text) ? "" : "\"" + text + "\" must be I/N, with I from 1 to N";
}

void check_output(const StudyOptions& options) {
  std::error_code error;
  if (std::filesystem::exists(options.out, error) &&
      !std::filesystem::is_directory(options.out, error))
    throw UsageError("--out " + options.out + " is a file; a study needs a folder");
}

std::vector<TimedPose> path_to_study(const std::filesystem::path& file) {
  std::vector<TimedPose> path = read_trajectory(file);
  if (path.empty())
    throw InputError::in(file.string(), "holds no poses: there is nothing to study");
  return path;
}

std::vector<TimedPose> path_to_study(const Scene& scene) {
  require_trajectory(scene);
  return path_to_study(*scene.trajectory);
}

void add_flags(CLI::App& parser, StudyOptions& options) {
  parser.add_option("--out", options.out, "folder to write; finished parts in it are kept")
      ->required();
  parser
      .add_option("--shard", options.shard,
                  "I/N: compute only the I-th of N shares of the study; sonde merge joins them")
      ->check(check_shard);
  parser.add_option("--threads", options.threads, "threads to compute on; 0: all of the machine's")
      ->check(check_whole)
      ->check(CLI::Range(0U, most_threads))
      ->capture_default_str();
  parser.add_flag("--quiet", options.quiet, "no progress and no notes on stderr, only failures");
}

Stop stop_on_interrupt() {
  note_interrupts();
  return [] { return interrupt_noted(); };
}

unsigned threads_of(const StudyOptions& options) {
  return options.threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : options.threads;
}

void run_study(const Study& study, const StudyOptions& options, StudyFiles join,
               const std::function<void(ProgressLine&)>& on_part) {
  const Stop stop = stop_on_interrupt();
  const Shard shard = options.shard.empty() ? Shard{} : shard_of(options.shard).value();
  ProgressLine progress(options.quiet, ProgressLine::Elsewhere::lines);
  progress.say(study.kind + ", the first parts");
  std::size_t finished = 0;
  compute_parts(options.out, study, shard, threads_of(options), stop,
                [&](std::size_t done, std::size_t total, double under_way) {
                  if (on_part && finished != done) on_part(progress);
                  finished = done;
                  progress.show(study.kind + ", parts", done, total, under_way);
                });
  progress.clear();
  if (read_study(options.out).complete()) return join_study(options.out, join);
  if (!options.quiet)
    std::cerr << "sonde: this share is finished; other shares are still missing here\n";
}

void join_study(const std::string& folder, StudyFiles join) {
  for (const StudyFile& file : join(folder, read_study(folder)))
    write_whole(std::filesystem::path(folder) / file.name, file.text);
}

void print_summary(const StudyOptions& options, bool json) {
  if (!options.shard.empty()) return;
  const char* name = json ? "summary.json" : "summary.md";
  const auto file = std::filesystem::path(options.out) / name;
  write_result({}, read_text(file, std::size_t{1} << 20));
}

std::string fingerprint_of(const std::filesystem::path& file) {
  return fingerprint(read_text(file, std::numeric_limits<std::size_t>::max()));
}

nlohmann::ordered_json study_inputs(const Scene& scene, const Pair& pair) {
  std::map<std::filesystem::path, std::string> fingerprints;  // many parts may be of one file
  const auto fingerprint_once = [&](const std::filesystem::path& file) {
    std::string& known = fingerprints[file];
    if (known.empty()) known = fingerprint_of(file);
    return known;
  };
  const auto body = [&](const SceneBody& described, const Body& loaded) {
    nlohmann::ordered_json json{{"mesh", utf8_text(described.mesh.filename().string())},
                                {"fingerprint", fingerprint_once(described.mesh)},
                                {"scale", scene.unit * described.scale},
                                {"solid", loaded.solid}};
    if (described.repair != Repair::automatic) json["repair"] = name_of(described.repair);
    if (described.offset != 0) json["offset"] = described.offset;
    if (described.components) json["components"] = true;
    for (const SceneBody& part : described.parts) {
      const auto& [q, p] = part.pose;
      json["parts"].push_back({{"name", utf8_text(part_name(part))},
                               {"fingerprint", fingerprint_once(part.mesh)},
                               {"scale", part.scale},
                               {"pose", {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()}}});
      if (part.component != 0) json["parts"].back()["component"] = part.component;
      if (part.components) json["parts"].back()["components"] = true;
    }
    return json;
  };
  nlohmann::ordered_json json{{"version", SONDE_VERSION},
                              {"probe", body(scene.probe, pair.probe())},
                              {"fixed", body(scene.fixed, pair.fixed())}};
  if (scene.trajectory) json["trajectory"] = fingerprint_of(*scene.trajectory);
  return json;
}

}  // namespace sonde::app
