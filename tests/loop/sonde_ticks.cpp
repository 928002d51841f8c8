// SPDX-License-Identifier: GPL-3.0-or-later
// How long the ticks of the coherent solver take along the path of a scene, and how far they can be
// trusted: processor time of the thread. The ticks are the same in every run, so the least of some
// runs is what a tick takes where nothing else is in its way.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "engine/penetration/search/coherent.hpp"
#include "engine/platform/processor_time.hpp"
#include "tests/loop/real_cases.hpp"
#include "tests/loop/tick_cases.hpp"
#include "tests/loop/tick_table.hpp"

namespace sonde::ticks {
namespace {

struct Options {
  std::vector<std::string> scenes;
  std::vector<int> slabs;
  bool real = false;
  bool fitted = false;
  std::string only;
  std::string method = "pdg";
  std::string csv;
  Budget budget;
  int runs = 3;
  int knots = 0;
  int held = 1;
};

std::vector<Tick> follow(const TickCase& c, const Options& o) {
  const Method method = method_named(o.method).value();
  std::vector<Tick> ticks(c.path.size());
  const Pair pair(c.probe, c.fixed);
  for (int run = 0; run < o.runs; ++run) {
    CoherentSolver solver(pair, method);
    if (solver.reset(c.path.front().pose).status == Status::failed)
      throw std::runtime_error(solver.last().reason);
    for (std::size_t i = 0; i < c.path.size(); ++i) {
      const double us =
          processor_time_us([&] { ticks[i].separation = solver.tick(c.path[i].pose, o.budget); });
      ticks[i].us = run == 0 ? us : std::min(ticks[i].us, us);
    }
  }
  return ticks;
}

/// The device moves once in so many ticks and rests in the others, as one does that a mouse moves.
TickCase with_rests(TickCase c, int held) {
  for (std::size_t i = 0; i < c.path.size(); ++i)
    c.path[i].pose = c.path[i - i % static_cast<std::size_t>(held)].pose;
  return c;
}

void measure(const TickCase& smooth, const Options& o) {
  const TickCase c = with_rests(smooth, o.held);
  const std::vector<Tick> ticks = follow(c, o);
  std::fputs(table_row(c, ticks).c_str(), stdout);
  std::fflush(stdout);
  if (!o.csv.empty()) write_csv(o.csv, c, ticks);
}

void run(const Options& o) {
  if (o.scenes.empty() && o.slabs.empty() && !o.real && !o.fitted)
    throw std::invalid_argument("nothing to measure: name scenes, --slab, --real or --fitted");
  std::fputs(table_head().c_str(), stdout);
  for (const int cuts : o.slabs) measure(slab_case(cuts), o);
  if (o.real)
    for (const std::string& name : real_pairs())
      if (name.find(o.only) != std::string::npos) measure(real_case(name), o);
  if (o.fitted)
    for (const TickCase& c : fitted_cases(o.only)) measure(c, o);
  for (const std::string& file : o.scenes) measure(scene_case(file, o.knots), o);
}

}  // namespace
}  // namespace sonde::ticks

int main(int argc, char** argv) {
  sonde::ticks::Options o;
  CLI::App app("How long the ticks of the coherent solver take, µs of processor time");
  app.add_option("SCENES", o.scenes, "scene files that name a trajectory");
  app.add_option("--slab", o.slabs,
                 "a block slid on a slab, its faces cut into N x N squares; N,N,... for some")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::PositiveNumber);
  app.add_flag("--real", o.real, "four pairs of real meshes, pressed and slid on each other");
  app.add_flag("--fitted", o.fitted, "parts that fit into each other, pressed, wedged and jammed");
  app.add_option("--only", o.only,
                 "of the real pairs and the parts that fit those whose names hold this");
  app.add_option("--method", o.method, "pdg or pdt")
      ->check(CLI::IsMember(sonde::method_names))
      ->capture_default_str();
  app.add_option("--runs", o.runs, "the least of so many counts")->capture_default_str();
  app.add_option("--budget-us", o.budget.microseconds, "of a tick, by the clock; 0: none");
  app.add_option("--work", o.budget.work, "units of work of a tick; 0: no limit");
  app.add_option("--held", o.held, "ticks from one motion of the device to the next")
      ->check(CLI::PositiveNumber);
  app.add_option("--knots", o.knots,
                 "instead of the scene's bodies, the knots of torus-knots with so many triangles");
  app.add_option("--csv", o.csv, "file for the ticks of the last scene");
  CLI11_PARSE(app, argc, argv);
  try {
    sonde::ticks::run(o);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-ticks: %s\n", error.what());
    return 3;
  }
}
