// SPDX-License-Identifier: GPL-3.0-or-later
// How long the ticks of the coherent solver take along the path of a scene: processor time of the
// thread. The ticks are the same in every run, so the least of some runs is what a tick takes where
// nothing else is in its way.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include "engine/penetration/coherent.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct Options {
  std::vector<std::string> scenes;
  std::string method = "pdg";
  std::string csv;
  Budget budget;
  int runs = 3;
  int knots = 0;
};

double thread_us() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

struct Tick {
  double us = 0;
  Separation separation;
};

struct Bodies {
  std::shared_ptr<const Body> probe, fixed;
};

/// The knot of the scene torus-knots, of about so many triangles.
std::shared_ptr<const Body> knot(int triangles) {
  const int sides = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 24.0))));
  return test::body(test::torus_knot(2, 3, 0.036, 0.016, 0.0065, 12 * sides, sides));
}

std::vector<Tick> follow(const Bodies& bodies, const std::vector<TimedPose>& path,
                         const Options& o) {
  const Method method = o.method == "pdt" ? Method::pdt : Method::pdg;
  std::vector<Tick> ticks(path.size());
  for (int run = 0; run < o.runs; ++run) {
    CoherentSolver solver(bodies.probe, bodies.fixed, method);
    if (solver.reset(path.front().pose).status == Status::failed)
      throw std::runtime_error(solver.last().reason);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double start = thread_us();
      ticks[i].separation = solver.tick(path[i].pose, o.budget);
      const double us = thread_us() - start;
      ticks[i].us = run == 0 ? us : std::min(ticks[i].us, us);
    }
  }
  return ticks;
}

/// Nearest rank; 0 where there are none.
double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(1.0, rank)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void report(const std::string& name, const Bodies& bodies, const std::vector<Tick>& ticks) {
  std::vector<double> all, contact;
  int jumps = 0, unconverged = 0, steps = 0;
  for (const Tick& t : ticks) {
    all.push_back(t.us);
    if (t.separation.status == Status::penetrating) contact.push_back(t.us);
    jumps += t.separation.jumped;
    unconverged += !t.separation.converged;
    steps += t.separation.iterations;
  }
  std::printf("| %s | %zu, %zu | %zu of %zu | %.0f | %.0f | %.0f | %.0f | %.0f | %d | %d | %d |\n",
              name.c_str(), bodies.probe->soup.triangles.size(),
              bodies.fixed->soup.triangles.size(), contact.size(), all.size(), percentile(all, 0.5),
              percentile(contact, 0.5), percentile(all, 0.99), percentile(all, 0.999),
              percentile(all, 1), jumps, unconverged, steps);
  std::fflush(stdout);
}

void write(const std::string& file, const std::vector<Tick>& ticks) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (!out) throw std::runtime_error(file + " cannot be written");
  std::fputs("us,depth,iterations,converged,jumped,contacts\n", out);
  for (const Tick& t : ticks)
    std::fprintf(out, "%.1f,%.17g,%d,%d,%d,%d\n", t.us, t.separation.depth, t.separation.iterations,
                 t.separation.converged, t.separation.jumped, t.separation.contacts.size);
  std::fclose(out);
}

void run(const Options& o) {
  std::puts(
      "| scene | triangles | in contact | median | in contact | p99 | p99.9 | longest | jumps "
      "| not converged | steps |");
  for (const std::string& file : o.scenes) {
    const Scene scene = read_scene(file);
    if (!scene.trajectory) throw InputError::in(file, "the scene names no trajectory");
    const std::vector<TimedPose> path = read_trajectory(*scene.trajectory);
    Bodies bodies;
    if (o.knots > 0)
      bodies.probe = bodies.fixed = knot(o.knots);
    else
      bodies = {load(scene.probe, scene.unit), load(scene.fixed, scene.unit)};
    const std::vector<Tick> ticks = follow(bodies, path, o);
    report(scene.name, bodies, ticks);
    if (!o.csv.empty()) write(o.csv, ticks);
  }
}

}  // namespace
}  // namespace sonde

int main(int argc, char** argv) {
  sonde::Options o;
  CLI::App app("How long the ticks of the coherent solver take, µs of processor time");
  app.add_option("SCENES", o.scenes, "scene files that name a trajectory")->required();
  app.add_option("--method", o.method, "pdg or pdt")->capture_default_str();
  app.add_option("--runs", o.runs, "the least of so many counts")->capture_default_str();
  app.add_option("--budget-us", o.budget.microseconds, "of a tick, by the clock; 0: none");
  app.add_option("--work", o.budget.work, "units of work of a tick; 0: no limit");
  app.add_option("--knots", o.knots,
                 "instead of the scene's bodies, the knots of torus-knots with so many triangles");
  app.add_option("--csv", o.csv, "file for the ticks of the last scene");
  CLI11_PARSE(app, argc, argv);
  try {
    sonde::run(o);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-ticks: %s\n", error.what());
    return 3;
  }
}
