// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "app/commands.hpp"
#include "app/merge_results.hpp"
#include "app/study_run.hpp"
#include "app/trade_folder.hpp"
#include "engine/base/error.hpp"
#include "engine/study/assembly/insertion_report.hpp"
#include "engine/study/comparison/compare_report.hpp"
#include "engine/study/parts/merge_study.hpp"
#include "engine/study/trade/trade_report.hpp"
#include "engine/study/tuning/traces_report.hpp"
#include "engine/study/tuning/tuning_report.hpp"

namespace sonde::app {
namespace {

struct MergeOptions {
  StudyOptions study;
  std::vector<std::string> folders;
};

StudyFiles files_of(const StudyFolder& study, const std::string& folder) {
  if (study.kind == "compare") return compare_files;
  if (study.kind == "tune") return tuning_files;
  if (study.kind == "trade") return trade_files;
  if (study.kind == "traces") return traces_files;
  if (study.kind == "insert") return insertion_files;
  throw InputError::in(folder, "holds a study of an unknown kind: " + study.kind);
}

void merge(const std::vector<std::string>& given, const std::string& out) {
  std::vector<std::filesystem::path> folders(given.begin(), given.end());
  // Parts that are there already would be kept: they must be the same.
  const std::filesystem::path there(out);
  refuse_other_things(there);
  const auto is_out = [&](const std::filesystem::path& folder) { return folder == there; };
  if (std::filesystem::exists(there / "study.json") && std::ranges::none_of(folders, is_out))
    folders.push_back(there);
  const StudyFolder whole = merge_studies(folders);
  const StudyFiles join = files_of(whole, given.front());
  join(given.front(), whole);  // what cannot be read is found before anything is written
  write_study(out, whole);
  join_study(out, join);
}

/// Results of sonde query, which are files where studies are folders.
void merge_queries(const MergeOptions& options) {
  const OutputOptions output{.out = options.study.out};
  check_output(output, {options.folders.begin(), options.folders.end()});
  write_result(output, merge_results(options.folders));
}

void run(const MergeOptions& options) {
  if (std::filesystem::is_regular_file(options.folders.front())) return merge_queries(options);
  check_output(options.study);
  if (holds_studies(options.folders.front()))
    merge_fronts(options.folders, options.study.out, merge);
  else
    merge(options.folders, options.study.out);
}

}  // namespace

Command add_merge_command(CLI::App& program) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* parser = program.add_subcommand(
      "merge",
      "Joins the shards of a study or a query into what one run of all of it would have written");
  parser
      ->add_option("folders", options->folders,
                   "folders of the shards; or, of sonde query --shard, its results")
      ->required();
  parser
      ->add_option("--out", options->study.out,
                   "folder to write, which may be one of the others; or, of results, the file")
      ->required();
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
