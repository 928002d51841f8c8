// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-bench: Sonde's proximity queries beside those of FCL and Bullet, on the same meshes and
// poses in one run.
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "engine/simd/instruction_set.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/text_file.hpp"
#include "tests/bench/baseline.hpp"
#include "tests/bench/figures.hpp"
#include "tests/bench/meshes.hpp"
#include "tests/bench/report.hpp"
#include "tests/bench/session.hpp"

namespace sonde::bench {
namespace {

struct Options {
  bool quick = false;
  std::uint64_t seed = 1;
  std::string csv, json, plots;
  std::string baseline, write_baseline;
  std::vector<std::string> rest;  ///< for Google Benchmark
};

/// One line for each benchmark, while they run; the tables come at the end.
class ProgressReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred)
        std::fprintf(stderr, "%-60s %s\n", run.run_name.function_name.c_str(),
                     run.error_message.c_str());
      else
        std::fprintf(stderr, "%-60s %12.3f us\n", run.run_name.function_name.c_str(),
                     run.GetAdjustedRealTime());
    }
  }
};

Options parse(int argc, char** argv) {
  Options out;
  CLI::App app(
      "Times Sonde's proximity queries beside those of FCL and Bullet, on the same meshes "
      "and poses, after comparing their answers.\nGoogle Benchmark's flags work too: "
      "--benchmark_filter=REGEX (names are QUERY/POSES/PAIR/LIBRARY), "
      "--benchmark_list_tests, --benchmark_out=FILE.",
      "sonde-bench");
  app.add_flag("--quick", out.quick, "Fewer pairs and poses: under a minute");
  app.add_option("--seed", out.seed, "Seed of the poses")->capture_default_str();
  app.add_option("--csv", out.csv, "Write one row for each library of each row of the tables");
  app.add_option("--json", out.json, "Write the same, and the figures, as JSON");
  app.add_option("--plots", out.plots, "Write the curves over the number of triangles, as SVG");
  app.add_option("--baseline", out.baseline,
                 "Fail where Sonde is less fast beside the other libraries than this file has it");
  app.add_option("--write-baseline", out.write_baseline,
                 "Write the ratios of this run to that file, for this instruction set");
  app.allow_extras();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error) == 0 ? 0 : 2);
  }
  out.rest = app.remaining();
  return out;
}

/// False where there are flags that it does not know.
bool start_google_benchmark(char* program, std::vector<std::string>& rest) {
  std::vector<char*> arguments = {program};
  for (std::string& argument : rest) arguments.push_back(argument.data());
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  return !benchmark::ReportUnrecognizedArguments(count, arguments.data());
}

/// One call runs all poses; its time is the median over the poses.
void run_job(benchmark::State& state, Session& session, const Job& job) {
  for ([[maybe_unused]] auto iteration : state) {
    const LibraryResult* result = session.run(job);
    if (!result) {
      state.SkipWithError("failed: see the end");
      return;
    }
    const Statistics s = summarize(result->calls);
    state.SetIterationTime(1e-6 * s.median_us);
    state.counters["p99_us"] = s.p99_us;
    state.counters["poses"] = static_cast<double>(s.poses);
    state.counters["calls"] = static_cast<double>(s.calls);
    if (result->amount) state.counters["amount"] = *result->amount;
  }
}

/// Says which pairs are left out for want of a mesh.
void register_jobs(Session& session, bool quick) {
  for (const PairSpec& pair : pair_specs(quick)) {
    std::string missing = why_missing(pair.mesh_a);
    if (missing.empty()) missing = why_missing(pair.mesh_b);
    if (!missing.empty()) {
      std::printf("pair %s is left out: %s\n", pair.name.c_str(), missing.c_str());
      continue;
    }
    for (const Job& job : session.jobs(pair))
      benchmark::RegisterBenchmark(
          session.name_of(job).c_str(),
          [&session, job](benchmark::State& state) { run_job(state, session, job); })
          ->Iterations(1)
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond);
  }
}

/// The version of each library that is compared with, or that it is not installed.
std::vector<std::pair<std::string, std::string>> versions() {
  std::vector<std::pair<std::string, std::string>> out = {{"FCL", "not installed"},
                                                          {"Bullet", "not installed"}};
  for (const PeerLibrary& library : installed_peers())
    for (auto& [name, version] : out)
      if (name == library.name) version = library.version;
  return out;
}

std::string as_json(const Options& options, const Table& rows, const Table& asked) {
  std::string text = "{\"seed\": " + std::to_string(options.seed) + ",\n\"libraries\": {";
  const char* separator = "";
  for (const auto& [name, version] : versions()) {
    text.append(separator).append("\"").append(name).append("\": \"").append(version).append("\"");
    separator = ", ";
  }
  text.append("},\n\"results\": ").append(to_json(rows));
  return text.append(",\n\"figures\": ").append(to_json(asked)).append("}\n");
}

void write_files(const Options& options, const std::vector<Result>& results) {
  const Table rows = long_table(results), asked = figures_table(results, figures());
  if (!options.csv.empty()) write_whole(options.csv, to_csv(rows));
  if (!options.json.empty()) write_whole(options.json, as_json(options, rows, asked));
  if (options.plots.empty()) return;
  std::filesystem::create_directories(options.plots);
  for (const auto& [name, plot] : plots(results))
    write_whole(std::filesystem::path(options.plots) / name, to_svg(plot));
}

constexpr std::size_t most_of_baseline = 1 << 20;  // bytes

/// What the file holds; nothing where there is none.
std::string held_by(const std::string& file) {
  return std::filesystem::exists(file) ? read_text(file, most_of_baseline) : std::string();
}

/// Whether all is as fast as the baseline has it; says what is not.
bool keeps_baseline(const Options& options, const std::vector<Result>& results) {
  const std::string_view set = name_of(instruction_set());
  const Ratios now = ratios_of(results, figures());
  if (!options.write_baseline.empty())
    write_whole(options.write_baseline, with_baseline(set, now, held_by(options.write_baseline)));
  if (options.baseline.empty()) return true;
  const std::vector<std::string> slower =
      slower_than(baseline_for(set, read_text(options.baseline, most_of_baseline)), now);
  for (const std::string& one : slower)
    std::fprintf(stderr, "sonde-bench: slower than the baseline: %s\n", one.c_str());
  return slower.empty();
}

int run(int argc, char** argv) {
  Options options = parse(argc, argv);
  for (const std::string& file : {options.csv, options.json, options.write_baseline})
    if (!file.empty()) check_writable(file);
  if (!start_google_benchmark(argv[0], options.rest)) return 2;
  SessionOptions session_options;
  session_options.seed = options.seed;
  if (options.quick) session_options.budget_s = 0.1, session_options.patience_s = 1;
  Session session(session_options);
  register_jobs(session, options.quick);
  for (const auto& [name, version] : versions())
    std::printf("%s: %s\n", name.c_str(), version.c_str());
  ProgressReporter progress;
  benchmark::RunSpecifiedBenchmarks(&progress);
  if (!session.results().empty()) {
    std::printf("\n%s", wide_tables(session.results()).c_str());
    std::printf("figures, over the pairs of some ten thousand triangles\n\n%s",
                to_text(figures_table(session.results(), figures())).c_str());
  }
  write_files(options, session.results());
  for (const std::string& failure : session.failures())
    std::fprintf(stderr, "sonde-bench: failed: %s\n", failure.c_str());
  const bool kept = keeps_baseline(options, session.results());
  return kept && session.failures().empty() ? 0 : 1;
}

}  // namespace
}  // namespace sonde::bench

int main(int argc, char** argv) {
  try {
    return sonde::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-bench: %s\n", error.what());
    return 3;
  }
}
