// SPDX-License-Identifier: GPL-3.0-or-later
// The haptic loop in its real threads, along the path of a scene or of parts that fit, there and
// back, for as long as is asked: how it keeps its deadlines, and whether it ever allocates.
#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "engine/haptics/hand/direct_hand.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/platform/wakeful_processors.hpp"
#include "engine/scene/path_hand.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"
#include "tests/loop/tick_cases.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

struct Options {
  std::vector<std::string> scenes;
  std::optional<std::string> fitted;
  double seconds = 60;
  double rate_hz = 0;
  double picture_ms = 0;
  bool hurried = false;
  bool awake = false;
  bool histogram = false;
};

/// A hand that follows a path in real time, forwards and backwards in turn.
class PathThereAndBack {
 public:
  explicit PathThereAndBack(std::vector<TimedPose> path) : path_(std::move(path)) {}

  /// Where the hand is `dt` (s) later.
  Pose after(double dt) {
    const double length = path_.back().t - path_.front().t;
    time_ = std::fmod(time_ + dt, 2 * length);
    const double t = path_.front().t + (time_ < length ? time_ : 2 * length - time_);
    return pose_at(path_, t);
  }

  Hand hand() {
    return {.sample = [this](double dt) { return sample(dt); },
            .render = [this](const Wrench&) { cpu_.add(processor_time_us() - begin_); }};
  }
  /// Processor time from sample to render; read when the servo has stopped.
  const TimeHistogram& cpu() const { return cpu_; }

 private:
  HandSample sample(double dt) {
    begin_ = processor_time_us();
    return {.X_FM = after(dt)};
  }

  std::vector<TimedPose> path_;
  double time_ = 0;
  double begin_ = 0;
  TimeHistogram cpu_;
};

/// What a reader of every tick has seen.
struct Seen {
  std::uint64_t ticks = 0, contact = 0, held_back = 0, failed = 0;
  std::array<std::uint64_t, static_cast<std::size_t>(Withheld::shut_down) + 1>
      withheld{};  // by reason
  /// Of the ticks whose answer is not settled: how many had lost all of the force, and the least
  /// share of it that others had, which fades while they last.
  std::uint64_t faded = 0;
  double least_share = 1;
  double largest_force = 0;
  /// With a reason that the program's log gives: an answer that is not settled is one after 20 ms.
  std::uint64_t logged = 0;
  double settled_at = 0;  ///< s
  void take(const Snapshot& s) {
    ++ticks;
    const bool fading = s.hand.withheld == Withheld::unsettled;
    if (!fading) settled_at = s.time;
    logged += s.hand.withheld != Withheld::nothing && !(fading && s.time - settled_at < 0.02);
    contact += s.separation.status == Status::penetrating;
    failed += s.separation.status == Status::failed;
    held_back += s.hand.rows.held_back;
    ++withheld[static_cast<std::size_t>(s.hand.withheld)];
    if (fading) {
      faded += s.hand.share <= 0;
      if (s.hand.share > 0) least_share = std::min(least_share, s.hand.share);
    }
    largest_force = std::max(largest_force, s.wrench.force.norm());
  }
};

void print(const char* name, const TimeHistogram& h) {
  std::printf("%-22s median %8.1f  p99 %8.1f  p99.9 %8.1f  max %9.1f us\n", name, h.quantile(0.5),
              h.quantile(0.99), h.quantile(0.999), h.largest);
}

void print_bins(const char* name, const TimeHistogram& h) {
  std::printf("%s, us: ticks up to\n", name);
  for (int i = 0; i < TimeHistogram::bins; ++i)
    if (const auto n = h.counts[static_cast<std::size_t>(i)]; n > 0)
      std::printf("  %10.1f %u\n", TimeHistogram::edge(i), n);
}

/// What the loop runs on.
struct Held {
  std::string name;
  Pair pair;
  std::vector<TimedPose> path;
  Coupling coupling;
  ServoSettings settings;
};

Held held_in_scene(const std::string& file) {
  const Scene scene = read_scene(file);
  if (!scene.trajectory) throw InputError::in(file, "the scene names no trajectory");
  std::vector<TimedPose> path = read_trajectory(*scene.trajectory);
  if (path.size() < 2) throw InputError::in(file, "the path has a single pose");
  return {scene.name, Pair(load(scene.probe, scene.unit), load(scene.fixed, scene.unit)),
          std::move(path), scene.coupling, scene.servo};
}

Held held_in_case(const ticks::TickCase& one) {
  Coupling coupling;
  coupling.k = one.k;
  return {one.name, Pair(one.probe, one.fixed), one.path, coupling, {}};
}

/// True where nothing was allocated and no separation failed.
bool run(const Held& held, const Options& o) {
  ServoSettings settings = held.settings;
  if (o.rate_hz > 0) settings.rate_hz = o.rate_hz;
  const WakefulProcessors awake(o.awake);
  PathThereAndBack hand(held.path);
  DirectHand mouse(held.path.front().pose);
  Hand holding = o.picture_ms > 0 ? mouse.hand() : hand.hand();
  if (o.hurried) holding.follow = {};
  Servo servo(held.pair, Method::pdg, held.coupling, settings);
  servo.start(held.path.front().pose, holding);

  Seen seen;
  Snapshot snapshot;
  const auto read = [&] {
    while (servo.next_tick(snapshot)) seen.take(snapshot);
  };
  using std::chrono::steady_clock;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // the threads have begun
  test::ProcessAllocationCounter counter;
  const auto end = steady_clock::now() + std::chrono::duration<double>(o.seconds);
  const std::chrono::duration<double> picture(o.picture_ms > 0 ? 1e-3 * o.picture_ms : 0.016);
  for (auto last = steady_clock::now(); last < end;) {
    std::this_thread::sleep_for(picture);
    read();
    const auto now = steady_clock::now();
    if (o.picture_ms > 0)
      mouse.set_target(hand.after(std::chrono::duration<double>(now - last).count()));
    last = now;
  }
  counter.stop();
  servo.stop();
  read();

  const ServoTiming& timing = servo.timing();
  std::printf("%s: %.0f s at %g Hz; %s; %s; %s\n", held.name.c_str(), o.seconds, settings.rate_hz,
              timing.real_time.scheduling, timing.real_time.memory,
              o.awake ? awake.words() : "processors may sleep deeply: not asked for");
  print("period", timing.period);
  print("tick, wall clock", timing.tick);
  print("tick, processor time", hand.cpu());
  print("geometry", timing.geometry);
  print("age of the rows", timing.age);
  const auto share = [&](std::uint64_t n) { return 100.0 * double(n) / double(timing.ticks); };
  std::printf("ticks %llu, late %llu (%.2f %%), in step %.1f %%, in contact %.1f %%\n",
              static_cast<unsigned long long>(timing.ticks),
              static_cast<unsigned long long>(timing.late), share(timing.late),
              share(timing.in_step), share(seen.contact));
  for (std::size_t i = 1; i < seen.withheld.size(); ++i)
    if (seen.withheld[i] > 0)
      std::printf("%s for %llu ticks: %s\n",
                  static_cast<Withheld>(i) == Withheld::unsettled ? "fading force" : "no force",
                  static_cast<unsigned long long>(seen.withheld[i]),
                  words(static_cast<Withheld>(i)));
  std::printf("faded to nothing for %llu ticks, else to %.0f %%\n",
              static_cast<unsigned long long>(seen.faded), 100 * seen.least_share);
  std::printf("without force by the log for %llu ticks\n",
              static_cast<unsigned long long>(seen.logged));
  std::printf("held back %llu, failed %llu, dropped by the reader %llu; largest force %.2f N\n",
              static_cast<unsigned long long>(seen.held_back),
              static_cast<unsigned long long>(seen.failed),
              static_cast<unsigned long long>(servo.ticks_dropped()), seen.largest_force);
  std::printf("allocations %llu, frees %llu, in all threads\n",
              static_cast<unsigned long long>(counter.allocations()),
              static_cast<unsigned long long>(counter.frees()));
  if (o.histogram) {
    print_bins("period", timing.period);
    print_bins("tick", timing.tick);
  }
  return counter.allocations() == 0 && counter.frees() == 0 && seen.failed == 0;
}

bool run(const Options& o) {
  if (o.scenes.empty() && !o.fitted)
    throw InputError("nothing to measure: name scenes or --fitted");
  bool sound = true;
  for (const std::string& file : o.scenes) sound &= run(held_in_scene(file), o);
  if (o.fitted)
    for (const ticks::TickCase& one : ticks::fitted_cases(*o.fitted))
      sound &= run(held_in_case(one), o);
  return sound;
}

}  // namespace
}  // namespace sonde

int main(int argc, char** argv) {
  sonde::Options o;
  CLI::App app("The haptic loop in its real threads, along the path of a scene");
  app.add_option("SCENES", o.scenes, "scene files that name a trajectory");
  app.add_option("--fitted", o.fitted, "parts that fit into each other whose names hold this");
  app.add_option("--seconds", o.seconds, "how long")->capture_default_str();
  app.add_option("--rate-hz", o.rate_hz, "of the servo; 0: the scene's own");
  app.add_option("--mouse", o.picture_ms,
                 "a mouse drags the probe along the path, with a pose each so many ms; 0: a hand "
                 "that has one in each tick")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_flag("--hurried", o.hurried, "what the mouse drags does not wait for the loop");
  app.add_flag("--awake", o.awake,
               "keep the processors awake, as the thread of a force device does");
  app.add_flag("--histogram", o.histogram, "print the bins too");
  CLI11_PARSE(app, argc, argv);
  try {
    return sonde::run(o) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-soak: %s\n", error.what());
    return 3;
  }
}
