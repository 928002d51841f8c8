// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the static search on every pose of depths.csv and says how often it finds the reference.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "engine/calibration/calibration_file.hpp"
#include "engine/penetration/search/search_variation.hpp"
#include "engine/text/output_file.hpp"
#include "tests/reference/calibrate_rows.hpp"
#include "tests/reference/cases.hpp"
#include "tests/reference/more_time.hpp"
#include "tests/reference/one_projection.hpp"
#include "tests/reference/summary.hpp"
#include "tests/reference/written_pair.hpp"

namespace sonde::reference {
namespace {

struct Options {
  std::string in = "tests/reference/depths.csv";
  std::string only, csv, json, calibration, add, write;
  StaticOptions search;
  SearchTuning tuning;
  int every = 1;
  std::size_t worst = 20;
  bool mend = false;
  bool one_projection = false;
  std::vector<double> budgets_us;
};

void add_options(CLI::App& app, Options& o) {
  o.search.whole_bound = true;
  app.add_option("--in", o.in, "the file of references, from the folder one is in")
      ->capture_default_str();
  app.add_option("--budget-us", o.search.budget.microseconds, "wall-clock budget of a search");
  app.add_option("--budget-steps", o.search.budget.steps, "budget in counted steps");
  app.add_option("--seed", o.search.seed, "of the search")->capture_default_str();
  app.add_option("--method", o.search.method, "pdg or pdt")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Method>{
          {name_of(Method::pdg), Method::pdg}, {name_of(Method::pdt), Method::pdt}}));
  app.add_option("--sure", o.search.sure, "share of answers that should keep to their claim")
      ->check(CLI::Range(0.01, 0.9999))
      ->capture_default_str();
  app.add_option("--only", o.only, "one pair of meshes");
  app.add_option("--every", o.every, "only every N-th row")->check(CLI::PositiveNumber);
  app.add_option("--worst", o.worst, "how many of the worst to name")->capture_default_str();
  app.add_option("--csv", o.csv, "write a line for each row to this file");
  app.add_option("--json", o.json, "write the table to this file");
  app.add_option("--calibrate", o.calibration,
                 "measure what limits of time cost instead, and write that to this file");
  app.add_option("--add", o.add,
                 "with --calibrate: another calibration; what it holds of other pairs is kept")
      ->needs("--calibrate");
  app.add_option_function<std::vector<std::string>>(
      "--vary",
      [&o](const std::vector<std::string>& all) {
        for (const std::string& each : all) vary(o.tuning, each);
      },
      "NAME=VALUE: another value for a number of SearchTuning; may be given again; the names are " +
          list_of_search_tuning());
  app.add_flag("--phases", o.search.time_phases, "say where the time went");
  app.add_flag("--two-threads", o.search.two_threads, "search on two threads");
  app.add_flag_callback(
      "--default-bound", [&o] { o.search.whole_bound = false; },
      "the lower bound that a query makes by default, instead of the whole one");
  CLI::Option* const one_projection =
      app.add_flag("--one-projection", o.one_projection,
                   "PD_t by one local projection from outside instead of a search");
  for (const char* of_searches :
       {"--method", "--seed", "--budget-us", "--budget-steps", "--vary", "--default-bound"})
    one_projection->excludes(of_searches);
  CLI::Option* const more_time =
      app.add_option("--more-time", o.budgets_us,
                     "budgets of time, us, one after the other: how often more of it is worse")
          ->delimiter(',')
          ->check(CLI::PositiveNumber);
  for (const char* of_one : {"--csv", "--json", "--budget-us", "--one-projection"})
    more_time->excludes(of_one);
  app.add_option("--write", o.write,
                 "search nothing; write the pairs and their poses to this folder, for sonde query");
  app.add_flag("--mend", o.mend, "take over into the file what is better than the reference");
}

/// The bodies of a pair, made when they are first asked for, and kept while the pair lasts.
class Bodies {
 public:
  /// False, with a word on stderr, where the pair's meshes are missing.
  bool load(const std::string& pair) {
    if (pair == name_) return bodies.has_value();
    name_ = pair;
    bodies.reset();
    for (const PairSpec* spec : known_specs()) try {
        if (spec->name != pair) continue;
        auto fixed = spec->fixed();
        bodies.emplace(spec->probe(), std::move(fixed));
        return true;
      } catch (const std::exception& error) {
        std::fprintf(stderr, "sonde-depths: %s is missing: %s\n", pair.c_str(), error.what());
        return false;
      }
    std::fprintf(stderr, "sonde-depths: no pair is called %s\n", pair.c_str());
    return false;
  }
  std::optional<Pair> bodies;

 private:
  std::string name_;
};

std::vector<Measured> measure_all(std::vector<Row>& rows, const Options& options) {
  std::vector<Measured> out;
  Bodies bodies;
  for (std::size_t i = 0; i < rows.size(); i += static_cast<std::size_t>(options.every)) {
    Row& row = rows[i];
    if (!options.only.empty() && options.only != row.pair) continue;
    if (!bodies.load(row.pair)) continue;
    out.push_back(options.one_projection
                      ? measure_one_projection(row, *bodies.bodies)
                      : measure(row, *bodies.bodies, options.search, options.tuning));
    if (options.mend) mend(row, out.back(), options.search.method);
  }
  return out;
}

std::vector<MoreTime> measure_budgets(std::vector<Row>& rows, const Options& options) {
  std::vector<MoreTime> out;
  for (const double budget_us : options.budgets_us) {
    Options now = options;
    now.search.budget.microseconds = budget_us;
    out.push_back({budget_us, measure_all(rows, now)});
  }
  return out;
}

int write_all(const Options& options) {
  std::map<std::string, std::vector<Row>> pairs;
  for (const Row& row : read_rows(options.in))
    if (options.only.empty() || options.only == row.pair) pairs[row.pair].push_back(row);
  Bodies bodies;
  bool all = true;
  for (const auto& [pair, rows] : pairs) {
    const bool loaded = bodies.load(pair);
    all = all && loaded;
    if (loaded) write_pair(options.write, bodies.bodies->probe(), bodies.bodies->fixed(), rows);
  }
  return all ? 0 : 1;
}

void print(const char* title, const bench::Table& table) {
  if (!table.rows.empty()) std::printf("%s\n\n%s\n", title, bench::to_text(table).c_str());
}

/// The mean time of each phase, over all searches and over the slower half of them.
void print_phases(const std::vector<Measured>& all) {
  std::vector<const Measured*> by_time;
  for (const Measured& m : all) by_time.push_back(&m);
  std::ranges::sort(by_time, {}, &Measured::time_us);
  const auto line = [&](const char* name, std::span<const Measured* const> of) {
    PhaseTimes sum;
    double time_us = 0;
    for (const Measured* m : of) sum += m->got.phases, time_us += m->time_us;
    const double each = 1e-3 / static_cast<double>(of.size());
    std::printf("%-12s", name);
    for (std::size_t i = 0; i < phase_count; ++i)
      if (sum.us[i] > 0) std::printf("  %s %.3f", phase_names[i], each * sum.us[i]);
    std::printf("  all %.3f\n", each * time_us);
  };
  std::printf("mean ms of each phase\n\n");
  line("all", by_time);
  const std::span<const Measured* const> sorted(by_time);
  line("faster half", sorted.first(sorted.size() / 2));
  line("slower half", sorted.subspan(sorted.size() / 2));
  std::printf("\n");
}

int calibrate_all(const Options& options) {
  check_writable(options.calibration);
  const std::vector<Row> rows = read_rows(options.in);
  const Calibration other = options.add.empty() ? Calibration{} : read_calibration(options.add);
  std::set<std::string> pairs;
  for (const Row& row : rows)
    if (options.only.empty() || options.only == row.pair) pairs.insert(row.pair);
  Calibration all;
  Bodies bodies;
  for (const std::string& pair : pairs) {
    if (!bodies.load(pair)) continue;
    for (CalibrationSeries& series : calibrate_rows(*bodies.bodies, pair, rows).series)
      all.series.push_back(std::move(series));
  }
  write_whole(options.calibration, to_json(joined(std::move(all), other)));
  return 0;
}

int run(const Options& options) {
  if (!options.calibration.empty()) return calibrate_all(options);
  if (!options.write.empty()) return write_all(options);
  for (const std::string& file : {options.csv, options.json})
    if (!file.empty()) check_writable(file);
  std::vector<Row> rows = read_rows(options.in);
  if (!options.budgets_us.empty()) {
    print("more and more time", more_time(measure_budgets(rows, options)));
    return 0;
  }
  const std::vector<Measured> all = measure_all(rows, options);
  if (all.empty()) throw InputError(options.in + ": no rows to measure");
  const bench::Table table = summary(all, options.search.budget.microseconds);
  print("static search beside the reference", table);
  if (options.search.time_phases) print_phases(all);
  print("better than the reference", better(all));
  print("furthest above the reference", worst(all, options.worst));
  if (!options.csv.empty()) write_whole(options.csv, bench::to_csv(details(all)));
  if (!options.json.empty()) write_whole(options.json, bench::to_json(table));
  if (options.mend) write_rows(options.in, rows);
  for (const Measured& m : all)
    if (m.got.status != Status::failed && !m.free) return 1;
  return 0;
}

}  // namespace
}  // namespace sonde::reference

int main(int argc, char** argv) {
  using sonde::reference::Options;
  Options options;
  CLI::App app("How often the static search finds the reference depth, and in what time");
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "sonde-depths: --vary %s\n", error.what());
    return 2;
  }
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-depths: %s\n", error.what());
    return 3;
  }
}
