// SPDX-License-Identifier: GPL-3.0-or-later
// What each feature costs a tick, and a search: the path of a scene with the feature off and on, in
// turn, processor time of the thread. What is off should cost nothing, so "off" is the same in all
// rows, to the noise, which two identical runs show.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/quantile.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/coupling/coupler.hpp"
#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/contact_feed.hpp"
#include "engine/haptics/loop/hand_loop.hpp"
#include "engine/haptics/safety/passivity.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/recording/tick_log.hpp"
#include "tests/loop/tick_cases.hpp"

namespace sonde::ticks {
namespace {

struct Options {
  std::vector<std::string> scenes;
  int runs = 5;
  int searches = 12;
};

/// The window asks for what is shown beside once a picture: ticks of 1 ms, at 30 pictures a second.
constexpr int picture_ticks = 33;

/// The times of one run, µs of each tick or search.
using Run = std::function<std::vector<double>()>;

/// The least of some runs for each tick, with the two in turn.
struct Compared {
  std::vector<double> off, on;
};
Compared compare(int runs, const Run& off, const Run& on) {
  Compared out;
  const auto keep = [](std::vector<double>& least, const std::vector<double>& now) {
    if (least.empty()) least = now;
    for (std::size_t i = 0; i < now.size(); ++i) least[i] = std::min(least[i], now[i]);
  };
  for (int i = 0; i < runs; ++i) keep(out.off, off()), keep(out.on, on());
  return out;
}

void print(const char* feature, Compared c) {
  const auto mean = [](const std::vector<double>& all) {
    double sum = 0;
    for (const double x : all) sum += x;
    return sum / static_cast<double>(all.size());
  };
  for (auto* all : {&c.off, &c.on}) std::ranges::sort(*all);
  std::printf("| %-52s | %9.3f | %9.3f | %9.3f | %9.3f | %+8.3f |\n", feature, quantile(c.off, 0.5),
              quantile(c.on, 0.5), quantile(c.off, 0.99), quantile(c.on, 0.99),
              mean(c.on) - mean(c.off));
  std::fflush(stdout);
}

/// Times what is done with each tick, given its answer; with the solver's tick, or beside it.
using PerTick = std::function<void(const Separation&, double dt)>;
std::vector<double> ticks(const TickCase& c, const Pair& pair, bool phases, const PerTick& then,
                          bool with_solver = true) {
  CoherentSolver solver(pair);
  if (solver.reset(c.path.front().pose).status == Status::failed)
    throw std::runtime_error(solver.last().reason);
  solver.time_phases(phases);
  std::vector<double> out;
  double last = c.path.front().t;
  for (const TimedPose& at : c.path) {
    double begin = processor_time_us();
    const Separation& s = solver.tick(at.pose);
    if (!with_solver) begin = processor_time_us();
    if (then) then(s, at.t - last);
    out.push_back(processor_time_us() - begin);
    last = at.t;
  }
  return out;
}

/// The servo's own tick, on rows that are fresh each time.
std::vector<double> servo_ticks(const TickCase& c, const Pair& pair, bool control) {
  ContactFeed feed(pair, Method::pdg);
  feed.reset(c.path.front().pose, {});
  HandLoopSettings settings;
  settings.passivity.control = control;
  HandLoop loop(pair.probe().mass, Method::pdg, {.k = 500}, settings);
  loop.restart(c.path.front().pose);
  std::vector<double> out;
  HandLoop::Clock clock{.tick = 0, .now = 0, .dt = 1e-3};
  for (const TimedPose& at : c.path) {
    ++clock.tick;
    clock.now += clock.dt;
    const LocalContacts& rows = feed.refresh(at.pose, clock.tick, clock.now, {});
    const HandSample sample{.X_FM = at.pose, .device = DeviceTraits{}};  // else it does nothing
    out.push_back(processor_time_us([&] { loop.tick(sample, rows, clock, Withheld::nothing); }));
  }
  return out;
}

/// What the observer of the energy does in a tick of the servo, by itself: in the loop it is never
/// off.
std::vector<double> observations(const TickCase& c, const Pair& pair, bool on) {
  Passivity passivity(pair.probe().mass, {}, 1e-3);
  passivity.restart(c.path.front().pose);
  const Wrench wrench{Vec3(1, 2, 3), Vec3(0.01, 0.02, 0.03)};
  std::vector<double> out;
  for (const TimedPose& at : c.path)
    out.push_back(processor_time_us([&] {
      if (!on) return;
      passivity.observe(at.pose, 1e-3);
      passivity.rendered(wrench);
    }));
  return out;
}

std::vector<double> searches(const TickCase& c, const Pair& pair, int count,
                             const StaticOptions& options) {
  CoherentSolver solver(pair);
  solver.reset(c.path.front().pose);
  std::vector<Pose> poses;
  for (const TimedPose& at : c.path)
    if (solver.tick(at.pose).status == Status::penetrating) poses.push_back(at.pose);
  std::vector<double> out;
  for (int i = 0; i < count && !poses.empty(); ++i) {
    const std::size_t which = static_cast<std::size_t>(i) * poses.size() / std::size_t(count);
    out.push_back(processor_time_us([&] { separate_static(pair, poses[which], options); }));
  }
  return out;
}

void measure(const TickCase& c, const Options& o) {
  const Pair pair(c.probe, c.fixed);
  const MassProperties& mass = pair.probe().mass;
  std::printf("\n%s, µs of processor time\n\n", c.name.c_str());
  std::printf("| %-52s | %9s | %9s | %9s | %9s | %8s |\n", "feature", "off", "on", "off p99",
              "on p99", "mean");
  std::printf("|%s|----------:|----------:|----------:|----------:|---------:|\n",
              std::string(54, '-').c_str());
  const Run plain = [&] { return ticks(c, pair, false, {}); };
  print("nothing: the same tick twice", compare(o.runs, plain, plain));
  print("phases timed", compare(o.runs, plain, [&] { return ticks(c, pair, true, {}); }));
  const auto coupled = [&](const Coupling& gains) {
    return [&, gains] {
      Coupler coupler(mass, gains);
      return ticks(c, pair, false, [&](const Separation& s, double dt) { coupler.wrench(s, dt); });
    };
  };
  const Coupling object{.k = 500};
  Coupling force_alone{.mode = Coupling::Mode::classic}, torque = force_alone;
  force_alone.k_r = force_alone.b_r = 0;
  print("force and torque, one stiffness", compare(o.runs, plain, coupled(object)));
  print("torque (classic mode, without and with it)",
        compare(o.runs, coupled(force_alone), coupled(torque)));
  print("clusters of contacts, beside the tick",
        compare(
            o.runs, [&] { return ticks(c, pair, false, {}, false); },
            [&] {
              return ticks(
                  c, pair, false,
                  [&](const Separation& s, double) { contact_clusters(s.contacts, mass.radius); },
                  false);
            }));
  print("recorder, on its reader's thread", compare(o.runs, plain, [&] {
          TickLog log(mass.radius, 1000);
          Snapshot tick;
          return ticks(c, pair, false, [&](const Separation& s, double dt) {
            tick.separation = s;
            tick.time += dt;
            ++tick.tick;
            log.add(tick);
          });
        }));
  print("PD_t and the bound beside, in their own thread", compare(o.runs, plain, [&] {
          BackgroundSearch beside(pair);
          int tick = 0;
          return ticks(c, pair, false, [&](const Separation& s, double) {
            if (tick++ % picture_ticks == 0) beside.request(s.device);
            beside.latest();
          });
        }));
  print("passivity control, in the servo's own tick",
        compare(
            o.runs, [&] { return servo_ticks(c, pair, false); },
            [&] { return servo_ticks(c, pair, true); }));
  print("observer of the energy, by itself",
        compare(
            o.runs, [&] { return observations(c, pair, false); },
            [&] { return observations(c, pair, true); }));
  StaticOptions search;
  search.want_lower_bound = false;
  const auto searched = [&](const StaticOptions& options) {
    return [&, options] { return searches(c, pair, o.searches, options); };
  };
  const int few = std::min(o.runs, 3);
  print("nothing: the same search twice", compare(few, searched(search), searched(search)));
  StaticOptions bounded = search, pdt = search;
  bounded.want_lower_bound = true;
  pdt.method = Method::pdt;
  print("lower bound of a search, by default", compare(few, searched(search), searched(bounded)));
  bounded.whole_bound = true;
  print("lower bound of a search, whole", compare(few, searched(search), searched(bounded)));
  print("six degrees (off: translation alone, PD_t)",
        compare(few, searched(pdt), searched(search)));
}

}  // namespace
}  // namespace sonde::ticks

int main(int argc, char** argv) {
  sonde::ticks::Options o;
  CLI::App app("What each feature costs a tick and a search, off and on, µs of processor time");
  app.add_option("SCENES", o.scenes, "scene files that name a trajectory")->required();
  app.add_option("--runs", o.runs, "the least of so many counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--searches", o.searches, "poses of the path that are searched")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    for (const std::string& file : o.scenes)
      sonde::ticks::measure(sonde::ticks::scene_case(file, 0), o);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-features: %s\n", error.what());
    return 3;
  }
}
