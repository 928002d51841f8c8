// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/bodies.hpp"
#include "app/options.hpp"
#include "engine/scene/poses.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde::app {

/// How a study is run: where to, and how much of it here.
struct StudyOptions {
  std::string out;    ///< folder
  std::string shard;  ///< "2/8"; empty: all of it
  unsigned threads = 0;
  bool quiet = false;
};
void add_flags(CLI::App& parser, StudyOptions& options);

/// Refuses, before any work, an --out that is a file.
void check_output(const StudyOptions& options);

/// A trajectory that is there to be studied: throws InputError where it holds no pose, and as
/// read_trajectory.
std::vector<TimedPose> path_to_study(const std::filesystem::path& file);

/// What a finished folder is joined into.
using StudyFiles = std::vector<StudyFile> (*)(const std::string& folder, const StudyFolder& study);

/// Computes the parts that are missing in the folder and, where all are there, writes what they
/// join into. Says on stderr what is left to do, unless quiet.
void run_study(const Study& study, const StudyOptions& options, StudyFiles join);

/// Reads a complete study and writes what it is joined into beside its parts. Throws InputError
/// naming the parts that are missing.
void join_study(const std::string& folder, StudyFiles join);

/// Prints the summary of a finished study. Where only a share of it was asked for there is none to
/// print, whichever ends last.
void print_summary(const StudyOptions& options, bool json);

/// What the results of a study depend on beside its settings: the program, the meshes and the
/// trajectory. Names, not paths: a shard may run elsewhere.
nlohmann::ordered_json study_inputs(const Scene& scene, const Pair& pair);
/// Tells files of one name apart. Throws InputError where the file cannot be read.
std::string fingerprint_of(const std::filesystem::path& file);

/// True once an interrupt has asked long work to stop.
Stop stop_on_interrupt();

}  // namespace sonde::app
