// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/bodies.hpp"
#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "engine/scene/poses.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde::app {

/// How to run a study: the folder, and the share of it to compute here.
struct StudyOptions {
  std::string out;    ///< folder
  std::string shard;  ///< "2/8"; empty: all of it
  unsigned threads = 0;
  bool quiet = false;
};
void add_flags(CLI::App& parser, StudyOptions& options);

/// A validator for CLI11 of --shard.
std::string check_shard(const std::string& text);

/// Refuses, before any work, an --out that is a file.
void check_output(const StudyOptions& options);

/// Reads the trajectory of a study. Throws InputError where it holds no pose, and as
/// read_trajectory.
std::vector<TimedPose> path_to_study(const std::filesystem::path& file);
/// The same of the scene's trajectory, which it has.
std::vector<TimedPose> path_to_study(const Scene& scene);

/// The result that a finished folder is joined into.
using StudyFiles = std::vector<StudyFile> (*)(const std::string& folder, const StudyFolder& study);

/// Computes the missing parts in the folder and, once all are there, writes the joined result.
/// Prints on stderr what remains to do, unless quiet. `on_part` is called after finished parts,
/// from any thread, one at a time.
void run_study(const Study& study, const StudyOptions& options, StudyFiles join,
               const std::function<void(ProgressLine&)>& on_part = {});

/// The threads to compute on: as asked for, or all of the machine's.
unsigned threads_of(const StudyOptions& options);

/// Reads a complete study and writes the joined result beside its parts. Throws InputError naming
/// the missing parts.
void join_study(const std::string& folder, StudyFiles join);

/// Prints the summary of a finished study. A run of a share prints none, even if it is the last to
/// end.
void print_summary(const StudyOptions& options, bool json);

/// The inputs that the results of a study depend on besides its settings: the program, the meshes
/// and the trajectory. Names, not paths: a shard may run elsewhere.
nlohmann::ordered_json study_inputs(const Scene& scene, const Pair& pair);
/// Identifies a file's content. Throws InputError where the file cannot be read.
std::string fingerprint_of(const std::filesystem::path& file);

/// True once an interrupt has requested long work to stop.
Stop stop_on_interrupt();

}  // namespace sonde::app
