// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/geometry/random.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/sketch/sketch.hpp"
#include "engine/study/trade/trade_results.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

constexpr double search_times[] = {500, 1000, 2000, 4000, 8000, 16'000, 32'000, 64'000, 0};
constexpr double tick_times[] = {50, 100, 200, 400, 800, 1600, 0};
constexpr int reference_searches = 3;
constexpr std::size_t most_kept = 200;

/// Equal steps of some work, told before each.
class CalibrationSteps {
 public:
  CalibrationSteps(const Progress& progress, std::size_t all)
      : progress_(progress), all_(static_cast<double>(std::max<std::size_t>(all, 1))) {}
  void next() { report(progress_, done_++ / all_); }

 private:
  const Progress& progress_;
  double all_, done_ = 0;
};

double depth_or_infinity(const Separation& s) {
  return s.status == Status::failed ? infinity : s.depth;
}

StaticOptions options(Method method, std::uint64_t seed, double time_us) {
  StaticOptions out;
  out.method = method;
  out.seed = seed;
  out.budget.microseconds = time_us;
  out.want_lower_bound = false;
  return out;
}

/// The excess of a depth over the least known one, which is 0 if the two bodies touch.
double excess(double depth, double least) { return depth == least ? 0 : depth / least - 1; }

/// Sorted, with the digits that are significant; of thousands only every n-th is kept.
std::vector<double> kept(std::vector<double> errors) {
  for (double& error : errors)
    if (std::isfinite(error)) error = parse_number(number_text(std::max(error, 0.0), 3)).value();
  ordering::sort(errors);
  const std::size_t every = (errors.size() + most_kept - 1) / most_kept;
  std::vector<double> out;
  for (std::size_t i = every / 2; i < errors.size(); i += every) out.push_back(errors[i]);
  return out;
}

std::vector<double> least_depths(const TradeSetup& setup, Method method, const Progress& progress) {
  std::vector<double> out;
  CalibrationSteps steps(progress, setup.poses.size() * reference_searches);
  Random seeds(setup.seed);
  for (const Pose& pose : setup.poses) {
    double least = infinity;
    for (int i = 0; i < reference_searches; ++i) {
      steps.next();
      least = std::min(least, depth_or_infinity(separate_static(setup.pair, pose,
                                                                options(method, seeds.next(), 0))));
    }
    out.push_back(least);
  }
  return out;
}

/// The depth at each pose of the path with one time limit, m.
std::vector<double> follow(const Pair& pair, Method method, std::span<const TimedPose> path,
                           std::uint64_t seed, double time_us, CalibrationSteps& steps) {
  std::vector<double> out;
  CoherentSolver solver(pair, method);
  bool started = false;  // after a failed search there is no pose to follow: search again
  for (const TimedPose& at : path) {
    steps.next();
    if (!started) solver.reset(at.pose, options(method, seed, 0));
    out.push_back(depth_or_infinity(solver.tick(at.pose, {.microseconds = time_us})));
    started = started || std::isfinite(out.back());
  }
  return out;
}

}  // namespace

double tick_error(double got, double wanted, double deepest) {
  if (!std::isfinite(got) || !std::isfinite(wanted)) return infinity;
  return got <= wanted ? 0 : (got - wanted) / deepest;
}

CalibrationSeries calibrate_searches(const Pair& pair, const std::string& name, Method method,
                                     std::span<const Pose> poses, std::vector<double> references,
                                     std::uint64_t seed, const Progress& progress) {
  CalibrationSeries out{name, Answers::search, method, bool(pair.sketches()), {}};
  struct Found {
    double depth;
    bool far_out;
  };
  std::vector<std::vector<Found>> found;  // by time, then by pose
  CalibrationSteps steps(progress, std::size(search_times) * poses.size());
  for (const double time_us : search_times) {
    found.emplace_back();
    for (std::size_t i = 0; i < poses.size(); ++i) {
      steps.next();
      const Separation one = separate_static(pair, poses[i], options(method, seed + i, time_us));
      found.back().push_back({depth_or_infinity(one), one.far_out});
      references[i] = std::min(references[i], found.back().back().depth);
    }
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    std::vector<double> near, far;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto [depth, far_out] = found[k][i];
      (far_out ? far : near).push_back(std::isfinite(depth) ? excess(depth, references[i]) : depth);
    }
    out.points.push_back({search_times[k], kept(std::move(near)), kept(std::move(far))});
  }
  return out;
}

CalibrationSeries calibrate_ticks(const Pair& pair, const std::string& name, Method method,
                                  std::span<const TimedPose> path, std::uint64_t seed,
                                  const Progress& progress) {
  CalibrationSeries out{name, Answers::tick, method, bool(pair.sketches()), {}};
  CalibrationSteps steps(progress, std::size(tick_times) * path.size());
  const std::vector<double> wanted = follow(pair, method, path, seed, 0, steps);
  double deepest = 0;
  for (const double depth : wanted)
    if (std::isfinite(depth)) deepest = std::max(deepest, depth);
  for (const double time_us : tick_times) {
    const std::vector<double> got =
        time_us > 0 ? follow(pair, method, path, seed, time_us, steps) : wanted;
    std::vector<double> errors;
    for (std::size_t i = 0; i < got.size(); ++i)
      if (got[i] > 0 || wanted[i] > 0) errors.push_back(tick_error(got[i], wanted[i], deepest));
    out.points.push_back({time_us, kept(std::move(errors))});
  }
  return out;
}

Calibration calibrate(const TradeSetup& setup, const Progress& progress) {
  // Shares of the time: a search takes about as long as a hundred ticks.
  constexpr double for_tick = 0.01;
  const double least = static_cast<double>(setup.poses.size() * reference_searches),
               searches = static_cast<double>(setup.poses.size() * std::size(search_times)),
               ticks = for_tick * static_cast<double>(setup.path.size() * std::size(tick_times)),
               all = static_cast<double>(std::size(traded_methods)) * (least + searches + ticks);
  double done = 0;
  const auto share = [&](double of) {
    const double from = std::exchange(done, done + of);
    return part_of(progress, from / all, done / all);
  };
  Calibration out;
  for (const Method method : traded_methods) {
    if (!setup.poses.empty()) {
      std::vector<double> references = least_depths(setup, method, share(least));
      out.series.push_back(calibrate_searches(setup.pair, setup.scene, method, setup.poses,
                                              std::move(references), setup.seed, share(searches)));
    }
    if (!setup.path.empty())
      out.series.push_back(
          calibrate_ticks(setup.pair, setup.scene, method, setup.path, setup.seed, share(ticks)));
  }
  return out;
}

}  // namespace sonde
