// SPDX-License-Identifier: GPL-3.0-or-later
// What the derivative of the wrench costs on the poses of the reference depths, beside the search
// and beside a tick of the coherent solver that the probe is held in: processor time of the thread,
// the least of some runs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "engine/base/quantile.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/penetration/sensitivity/wrench_derivative.hpp"
#include "engine/platform/processor_time.hpp"
#include "tests/reference/cases.hpp"
#include "tests/reference/depths_file.hpp"
#include "tests/support/differenced_wrench.hpp"

namespace sonde::reference {
namespace {

struct Options {
  std::string in = "tests/reference/depths.csv";
  int every = 1;
  int runs = 20;
};

/// µs, of all poses.
struct Times {
  std::vector<double> search, tick, at_contacts, all;
};

template <class Work>
double least_us(int runs, const Work& work) {
  double least = processor_time_us(work);
  for (int i = 1; i < runs; ++i) least = std::min(least, processor_time_us(work));
  return least;
}

void measure(const Pair& pair, const Row& row, int runs, Times& times) {
  StaticOptions options;
  options.want_lower_bound = false;
  Separation found;
  const double search =
      processor_time_us([&] { found = separate_static(pair, row.pose, options); });
  if (found.status != Status::penetrating || !found.converged) return;
  times.search.push_back(search);
  const auto derivative = [&](Neighbours neighbours) {
    return least_us(runs, [&] { wrench_derivative(pair, found, neighbours); });
  };
  times.at_contacts.push_back(derivative(Neighbours::of_contacts));
  times.all.push_back(derivative(Neighbours::all));
  CoherentSolver solver(pair);
  solver.reset(row.pose, options);
  double tick = 0;
  for (int i = 0; i < runs; ++i) {
    Vec6 motion = Vec6::Zero();
    motion[i % 3] = (i % 2 ? 0.01 : -0.01) * found.depth;
    const Pose beside = test::moved_by(pair.probe().mass, row.pose, motion);
    const double us = processor_time_us([&] { solver.tick(beside); });
    tick = i == 0 ? us : std::min(tick, us);
  }
  times.tick.push_back(tick);
}

void say(const char* what, std::vector<double>& us) {
  std::ranges::sort(us);
  std::printf("%-32s %10.1f %10.1f %10.1f\n", what, quantile(us, 0.5), quantile(us, 0.95),
              quantile(us, 1));
}

void run(const Options& o) {
  const std::vector<Row> rows = read_rows(o.in);
  if (rows.empty()) throw std::invalid_argument("no rows in " + o.in);
  Times times;
  std::size_t count = 0;
  for (const PairSpec* spec : known_specs()) {
    std::vector<Row> chosen;
    for (const Row& row : rows)
      if (row.pair == spec->name && count++ % static_cast<std::size_t>(o.every) == 0)
        chosen.push_back(row);
    if (chosen.empty()) continue;
    const Pair pair(spec->probe(), spec->fixed());
    for (const Row& row : chosen) measure(pair, row, o.runs, times);
  }
  std::printf("%zu poses; us of processor time     median        p95        max\n",
              times.search.size());
  say("search, no bound", times.search);
  say("tick, 1 % of the depth", times.tick);
  say("derivative, at the contacts", times.at_contacts);
  say("derivative, all neighbours", times.all);
}

}  // namespace
}  // namespace sonde::reference

int main(int argc, char** argv) {
  sonde::reference::Options o;
  CLI::App app("What the derivative of the wrench costs, beside a search and a tick");
  app.add_option("--in", o.in, "the file of references, from the folder one is in")
      ->capture_default_str();
  app.add_option("--every", o.every, "only every N-th row")->check(CLI::PositiveNumber);
  app.add_option("--runs", o.runs, "the least of so many counts")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    run(o);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
