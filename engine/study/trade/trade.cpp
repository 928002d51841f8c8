// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/random.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/study/trade/trade_extremes.hpp"
#include "engine/study/trade/trade_results.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

/// The reference: this many searches with at least this many starts.
constexpr int long_searches = 4;
constexpr int long_starts = 512;

constexpr int search_steps[] = {8, 16, 32, 64, 128, 256, 512, 1024, 0};
constexpr int bound_work[] = {1250, 5000, 20'000, 80'000};
/// 10 ns each, so from about 20 µs on.
constexpr int tick_work[] = {2000, 5000, 10'000, 20'000, 50'000, 100'000, 0};

bool has_bound(const TradeSetup& setup) {
  return setup.pair.probe().solid || setup.pair.fixed().solid;
}

std::vector<TradeSetting> pose_settings(const TradeSetup& setup) {
  std::vector<TradeSetting> out;
  for (const Method method : traded_methods)
    for (const int steps : search_steps) out.push_back({TradeKind::search, method, steps});
  if (has_bound(setup))
    for (const int work : bound_work) out.push_back({TradeKind::bound, Method::pdg, work});
  return out;
}

std::vector<TradeSetting> path_settings(const TradeSetup& setup) {
  std::vector<TradeSetting> out;
  if (setup.path.empty()) return out;
  for (const Method method : traded_methods)
    for (const int work : tick_work) out.push_back({TradeKind::tick, method, work});
  return out;
}

double depth_or_no_number(const Separation& s) {
  return s.status == Status::failed ? no_number : s.depth;
}

/// The static search of both methods and the lower bound, on one pose.
class PoseMeasurement {
 public:
  PoseMeasurement(const TradeSetup& setup, std::size_t pose)
      : setup_(setup),
        pose_(setup.poses[pose]),
        seeds_(setup.seed + 0x9e3779b97f4a7c15ULL * (pose + 1)) {}

  TradePose run(const Stop& stop) {
    const Vec3& p = pose_.p;
    const Quat& q = pose_.q;
    TradePose out;
    out.pose = {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
    out.long_pdg = long_searches_of(Method::pdg, stop);
    out.long_pdt = long_searches_of(Method::pdt, stop);
    const std::uint64_t seed = seeds_.next();
    for (const TradeSetting& setting : pose_settings(setup_)) {
      if (stop()) throw Cancelled();
      out.runs.push_back(setting.kind == TradeKind::bound ? bound(setting) : search(setting, seed));
    }
    return out;
  }

 private:
  StaticOptions options(Method method, std::uint64_t seed) const {
    StaticOptions out;
    out.method = method;
    out.seed = seed;
    out.want_lower_bound = false;
    return out;
  }

  Separation separate(const StaticOptions& options, const SearchTuning& tuning) const {
    return separate_static(setup_.pair, pose_, options, tuning);
  }

  std::vector<double> long_searches_of(Method method, const Stop& stop) {
    std::vector<double> out;
    for (int i = 0; i < long_searches; ++i) {
      if (stop()) throw Cancelled();
      StaticOptions own = options(method, seeds_.next());
      own.starts = long_starts;
      own.agreement = std::numeric_limits<int>::max();
      own.by_evidence = false;
      const Separation found = separate(own, {});
      if (found.status != Status::failed) out.push_back(found.depth);
    }
    return out;
  }

  TradeRun search(const TradeSetting& setting, std::uint64_t seed) const {
    StaticOptions own = options(setting.method, seed);
    own.budget.steps = static_cast<int>(setting.budget);
    Separation found;
    const double time = processor_time_us([&] { found = separate(own, setup_.tuning); });
    return {setting, depth_or_no_number(found), found.iterations, time};
  }

  TradeRun bound(const TradeSetting& setting) const {
    std::optional<double> found;
    const double time = processor_time_us([&] {
      found = depth_lower_bound(setup_.pair.probe(), setup_.pair.fixed(), pose_, {},
                                {.work = static_cast<int>(setting.budget)});
    });
    return {setting, found.value_or(no_number), 0, time};
  }

  const TradeSetup& setup_;
  Pose pose_;
  Random seeds_;
};

/// The coherent solver along the path with one budget.
TradePath follow(const TradeSetup& setup, const TradeSetting& setting, const Stop& stop) {
  TradePath out{setting, {}, {}, {}};
  CoherentSolver solver(setup.pair, setting.method);
  StaticOptions search;
  search.seed = setup.seed;
  bool started = false;  // after a failed search there is no pose to follow: search again
  for (const TimedPose& at : setup.path) {
    if (stop()) throw Cancelled();
    if (!started) solver.reset(at.pose, search);
    out.time_us.push_back(
        processor_time_us([&] { solver.tick(at.pose, {.work = setting.budget}); }));
    const Separation& s = solver.last();
    out.depth.push_back(depth_or_no_number(s));
    out.converged.push_back(s.status == Status::separated || s.converged);
    started = started || s.status != Status::failed;
  }
  return out;
}

Json about(const TradeSetup& setup) {
  std::vector<TradeSetting> settings = pose_settings(setup);
  for (const TradeSetting& setting : path_settings(setup)) settings.push_back(setting);
  return {{"scene", setup.scene},
          {"inputs", Json::parse(setup.inputs)},
          {"seed", setup.seed},
          {"radius", setup.pair.probe().mass.radius},
          {"poses", setup.poses.size()},
          {"ticks", setup.path.size()},
          {"long_searches", long_searches},
          {"long_starts", long_starts},
          {"settings", Json::parse(to_json(settings))}};
}

std::string part_name(const TradeSetting& setting) {
  return std::string(name_of(setting.kind)) + "-" + name_of(setting.method) + "-" +
         (setting.budget > 0 ? std::to_string(setting.budget) : "converged");
}

}  // namespace

Study trade_study(const TradeSetup& setup) {
  // Data that the parts share and may read from any thread.
  const auto shared = std::make_shared<const TradeSetup>(setup);
  Study study{"trade", about(setup).dump(), {}};
  for (const TradeSetting& setting : path_settings(setup))
    study.parts.push_back({part_name(setting), [shared, setting](const Stop& stop) {
                             return to_json(follow(*shared, setting, stop));
                           }});
  for (std::size_t i = 0; i < setup.poses.size(); ++i)
    study.parts.push_back({"pose-" + std::to_string(i), [shared, i](const Stop& stop) {
                             return to_json(PoseMeasurement(*shared, i).run(stop));
                           }});
  study.parts.push_back({"extremes", [shared](const Stop& stop) {
                           return to_json(
                               measure_extremes(shared->pair, shared->poses, shared->seed, stop));
                         }});
  return study;
}

}  // namespace sonde
