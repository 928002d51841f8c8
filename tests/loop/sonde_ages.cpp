// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs that the force is computed from contact rows that are some ticks old: a table of
// errors beside the loop in step, over speeds and rates, for each scene given.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "engine/scene/scene.hpp"
#include "tests/loop/row_age.hpp"

namespace sonde {
namespace {

struct Options {
  std::vector<std::string> scenes;
  std::vector<double> rates{1000};
  std::vector<double> speeds{1};
  std::vector<int> ages{0, 1, 2, 5, 10, 20};
  int steps = 0;
  bool csv = false;
};

void print_header(bool csv) {
  std::puts(csv ? "scene,rate_hz,speed,probe_speed,age,ticks,held_back,largest_force,"
                  "force_median,force_p99,force_max,torque_median,torque_p99,torque_max,"
                  "solve_median_us,solve_p99_us,refresh_median_us,refresh_p99_us"
                : "scene            Hz  speed   m/s  age  ticks  held    F max  |dF| median     p99"
                  "      max  solve us  p99  refresh us    p99");
}

void print(const std::string& scene, double rate, double speed, const RowAge& r, bool csv) {
  if (csv)
    std::printf("%s,%g,%g,%.4g,%d,%d,%d,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.1f,%.1f,%.0f,%.0f\n",
                scene.c_str(), rate, speed, r.probe_speed, r.age, r.ticks, r.held_back,
                r.largest_force, r.force_error.median, r.force_error.p99, r.force_error.largest,
                r.torque_error.median, r.torque_error.p99, r.torque_error.largest,
                r.solve_us.median, r.solve_us.p99, r.refresh_us.median, r.refresh_us.p99);
  else
    std::printf(
        "%-14s %5g %6g %5.2f %4d %6d %5d %7.3f N %9.5f N %7.4f %8.4f %8.1f %5.1f %10.0f %6.0f\n",
        scene.c_str(), rate, speed, r.probe_speed, r.age, r.ticks, r.held_back, r.largest_force,
        r.force_error.median, r.force_error.p99, r.force_error.largest, r.solve_us.median,
        r.solve_us.p99, r.refresh_us.median, r.refresh_us.p99);
}

void run(const Options& o) {
  print_header(o.csv);
  for (const std::string& file : o.scenes) {
    const Scene scene = read_scene(file);
    if (!scene.trajectory) throw InputError::in(file, "the scene names no trajectory");
    const std::vector<TimedPose> path = read_trajectory(*scene.trajectory);
    const Pair pair(load(scene.probe, scene.unit), load(scene.fixed, scene.unit));
    for (const double rate : o.rates)
      for (const double speed : o.speeds) {
        RowAgeOptions study{.budget = {.steps = o.steps, .microseconds = 0},
                            .k = scene.coupling.k,
                            .rate_hz = rate,
                            .speed = speed,
                            .ages = o.ages};
        for (const RowAge& r : measure_row_age(pair, path, study))
          print(scene.name, rate, speed, r, o.csv);
        std::fflush(stdout);
      }
  }
}

}  // namespace
}  // namespace sonde

int main(int argc, char** argv) {
  sonde::Options o;
  CLI::App app("What old contact rows cost");
  app.add_option("SCENES", o.scenes, "scene files that name a trajectory")->required();
  app.add_option("--rates", o.rates, "of the servo, Hz")->capture_default_str();
  app.add_option("--speeds", o.speeds, "times as fast as recorded")->capture_default_str();
  app.add_option("--ages", o.ages, "of the rows, ticks")->capture_default_str();
  app.add_option("--steps", o.steps, "budget of the geometry in each tick; 0: until converged");
  app.add_flag("--csv", o.csv, "commas instead of a table");
  CLI11_PARSE(app, argc, argv);
  try {
    sonde::run(o);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-ages: %s\n", error.what());
    return 3;
  }
}
