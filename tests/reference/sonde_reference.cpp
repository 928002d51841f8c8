// SPDX-License-Identifier: GPL-3.0-or-later
// Searches every case by brute force and appends what it finds to depths.csv, a row at a time:
// stopped and begun again it goes on where it was.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>

#include "engine/penetration/descent/descent.hpp"
#include "engine/text/output_file.hpp"
#include "tests/reference/reference_row.hpp"

namespace sonde::reference {
namespace {

struct Options {
  std::string out = "tests/reference/depths.csv";
  const std::vector<PairSpec>* pairs = &pair_specs();
  std::string only;
  int first = 0;
  int count = std::numeric_limits<int>::max();
  int starts = 0;
};

class Session {
 public:
  explicit Session(const Options& options) : options_(options), rows_(read_rows(options.out)) {
    check_writable(options_.out);
    if (rows_.empty()) write_whole(options_.out, header());
  }

  /// The number of pairs whose meshes are missing.
  int run() {
    int ordinal = 0;
    int missing = 0;
    for (const PairSpec& spec : *options_.pairs) {
      const int begin = ordinal;
      ordinal += case_count(spec);
      if (!options_.only.empty() && options_.only != spec.name) continue;
      try {
        search(spec, begin);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "sonde-reference: %s is missing: %s\n", spec.name.c_str(),
                     error.what());
        ++missing;
      }
    }
    sort_rows();
    return missing;
  }

 private:
  bool is_asked(const PairSpec& spec, int index, int ordinal) const {
    if (ordinal < options_.first || ordinal - options_.first >= options_.count) return false;
    return std::none_of(rows_.begin(), rows_.end(), [&](const Row& row) {
      return row.pair == spec.name && row.index == index;
    });
  }

  void search(const PairSpec& spec, int begin) {
    std::vector<int> asked;
    for (int i = 0; i < case_count(spec); ++i)
      if (is_asked(spec, i, begin + i)) asked.push_back(i);
    if (asked.empty()) return;
    const auto probe = spec.probe(), fixed = spec.fixed();
    const std::vector<Case> all = cases(spec, *probe, *fixed);
    for (const int i : asked) {
      const double started = now_us();
      const int starts = options_.starts > 0 ? options_.starts : spec.starts;
      const Reference found =
          reference_row(spec, *probe, *fixed, all[static_cast<std::size_t>(i)], starts);
      append(found.row);
      report(found, 1e-6 * (now_us() - started));
    }
  }

  static void report(const Reference& found, double seconds) {
    const Row& row = found.row;
    std::printf("%-28s best %.6g m, %s, %d hits of %d; seeds", name(row).c_str(), row.best,
                agreed(row) ? "agreed" : "NOT AGREED", row.hits, 3 * row.starts);
    for (std::size_t s = 0; s < row.seeds.size(); ++s)
      std::printf(" +%.2f %% (%s)", 100 * (row.seeds[s] / row.best - 1), name(found.origins[s]));
    std::printf("; PD_t %.6g m, %.1f s\n", row.pdt, seconds);
    std::fflush(stdout);
  }

  void append(const Row& row) {
    std::ofstream out(options_.out, std::ios::app | std::ios::binary);
    out << to_line(row) << std::flush;
    if (!out) throw InputError(options_.out + ": cannot be written");
    rows_.push_back(row);
  }

  /// Rows of single pairs may have come in any order.
  void sort_rows() {
    std::map<std::string, std::size_t> place;
    for (const PairSpec& spec : *options_.pairs) place.emplace(spec.name, place.size());
    const auto key = [&](const Row& row) { return std::pair(place[row.pair], row.index); };
    const auto before = [&](const Row& a, const Row& b) { return key(a) < key(b); };
    if (std::is_sorted(rows_.begin(), rows_.end(), before)) return;
    std::stable_sort(rows_.begin(), rows_.end(), before);
    write_rows(options_.out, rows_);
  }

  Options options_;
  std::vector<Row> rows_;
};

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Reference depths for the static search, by brute force");
  app.add_option("--out", options.out, "the file of rows, from the folder one is in")
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--pairs",
         [&](const std::string& which) {
           if (which == "deep-tuning") options.pairs = &deep_tuning_specs();
           if (which == "deep-reporting") options.pairs = &deep_reporting_specs();
         },
         "those of depths.csv, of deep_tuning.csv or of deep_reporting.csv")
      ->check(CLI::IsMember({"all", "deep-tuning", "deep-reporting"}));
  app.add_option("--only", options.only, "one pair of meshes");
  app.add_option("--first", options.first, "the first case, counted over all pairs");
  app.add_option("--count", options.count, "how many cases from there on");
  app.add_option("--starts", options.starts, "random starts of a seed (0: as the pair has it)");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return Session(options).run() == 0 ? 0 : 3;
}

}  // namespace
}  // namespace sonde::reference

int main(int argc, char** argv) {
  try {
    return sonde::reference::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-reference: %s\n", error.what());
    return 3;
  }
}
