// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/static_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/penetration/crew.hpp"
#include "engine/penetration/leap_descent.hpp"
#include "engine/penetration/lower_bound.hpp"
#include "engine/penetration/random.hpp"
#include "engine/penetration/result.hpp"
#include "engine/penetration/sketch_search.hpp"
#include "engine/proximity/intersect.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

/// Starts that are descended side by side; what they find counts from the next round on, so that it
/// does not matter how many threads there are.
constexpr std::size_t per_round = 8;
/// A list of pairs pays for many short steps, of which there are few here.
constexpr ContactRows::Finding unlisted{.most_listed = 0};
/// The rest of the time is for making what was found fit to be returned.
constexpr double share_for_the_search = 0.55;
/// Of which so much may go into the sketches.
constexpr double share_for_sketches = 0.3;

class Search {
 public:
  Search(const Body& probe, const Body& fixed, const Pose& device, const StaticOptions& options)
      : probe_(probe),
        fixed_(fixed),
        chart_(probe.mass, device),
        options_(options),
        deadline_{options.budget.microseconds, now_us()},
        searching_{share_for_the_search * options.budget.microseconds, deadline_.started},
        lanes_{lane(probe, fixed), lane(probe, fixed)},
        descent_(probe, fixed, options.method, unlisted),
        crew_(options.two_threads) {
    if (!options.sketches) return;
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane)
      sketched_.emplace_back(*options.sketches.probe, *options.sketches.fixed, fixed.mass);
  }

  Separation run() {
    // Of counted steps, translations get their part: the depth is never more than theirs.
    reserved_ = rotates() ? options_.budget.steps / 3 : 0;
    if (rotates()) first_starts(Method::pdg, 2000);
    reserved_ = 0;
    if (!rotates() || found_.empty() || options_.budget.steps > 0) translations();
    if (found_.empty()) return failed(chart_.device(), "no free pose was found");
    for (int start = 0; start < options_.starts && !done(); start += int{per_round})
      random_starts(start);
    if (rotates() && !std::isfinite(translated_.depth) && !out_of_budget()) translations();
    return finish();
  }

 private:
  struct Found {
    Vec6 y = Vec6::Zero();
    double depth = std::numeric_limits<double>::infinity();
    int iterations = 0;
    int starts = 1;  ///< that led there independently of what was found before: they confirm it
  };
  using Round = std::array<Found, per_round>;
  /// Every other start of a round, one after the other, and what they work with.
  struct Lane {
    LeapDescent pdg, pdt;
    double near;  ///< m: no free pose was found in smaller balls
  };
  static Lane lane(const Body& probe, const Body& fixed) {
    return {{probe, fixed, Method::pdg}, {probe, fixed, Method::pdt}, smallest_ball(probe)};
  }
  static double smallest_ball(const Body& probe) { return 2e-3 * probe.mass.radius; }
  LeapDescent& descent_of(Lane& lane, Method method) const {
    return method == Method::pdg ? lane.pdg : lane.pdt;
  }
  bool rotates() const { return options_.method == Method::pdg; }

  bool out_of_budget() const { return searching_.passed() || steps_left() == 0; }
  bool done() const { return out_of_budget() || agreeing_ >= options_.agreement; }
  int steps_left() const {
    return options_.budget.steps > 0 ? std::max(0, options_.budget.steps - reserved_ - iterations_)
                                     : std::numeric_limits<int>::max();
  }
  /// Nothing is left for polishing either.
  bool late() const { return deadline_.passed() || steps_left() == 0; }
  /// Runs start(k, lane) for each of a round, and takes down what they found.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    if (out_of_budget() && best_ < std::numeric_limits<double>::infinity()) return;
    Round found;
    // Each has an equal share of the steps left, and some are not made where it is small.
    const std::size_t count =
        std::min(most, static_cast<std::size_t>(std::max(1, steps_left() / 4)));
    share_ = std::max(1, steps_left() / static_cast<int>(count));
    crew_.each(count, [&](std::size_t k, std::size_t lane) { found[k] = start(k, lanes_[lane]); });
    for (std::size_t k = 0; k < count; ++k) note(found[k]);
  }

  void note(const Found& f) {
    iterations_ += f.iterations;
    if (!std::isfinite(f.depth)) return;
    if (f.depth < 0.98 * best_) agreeing_ = 0;
    if (f.depth < 1.02 * std::min(best_, f.depth)) agreeing_ += f.starts;
    best_ = std::min(best_, f.depth);
    if (f.y.head<3>().isZero(0) && f.depth < translated_.depth) translated_ = f;
    found_.push_back(f);
  }

  /// Down by leaps, roughly and where that is promising by the true contacts.
  Found descend(LeapDescent& leaps, const Vec6& y, double beat) const {
    const auto rough = leaps.run(
        chart_, y, {.steps = std::min(15, share_), .reach = 0.3, .beat = 1.1 * beat}, searching_);
    Found out{rough.y, rough.y.norm(), rough.iterations};
    const int left = share_ - out.iterations;
    if (left <= 0 || (beat > 0 && out.depth > 1.2 * beat)) return out;
    const auto exact = leaps.run(chart_, rough.y,
                                 {.guide = Guide::few,
                                  .tolerance = 0.01,
                                  .steps = std::min(12, left),
                                  .reach = 0.1,
                                  .beat = 1.02 * beat},
                                 searching_);
    return {exact.y, exact.y.norm(), out.iterations + exact.iterations};
  }

  Found descend_exactly(LeapDescent& leaps, const Vec6& y, double beat) const {
    const auto exact = leaps.run(chart_, y,
                                 {.guide = Guide::few,
                                  .tolerance = 0.01,
                                  .steps = std::min(15, share_),
                                  .reach = 0.2,
                                  .beat = std::isfinite(beat) ? 1.02 * beat : 0},
                                 searching_);
    return {exact.y, exact.y.norm(), exact.iterations};
  }

  /// From the nearest free poses of ever larger balls: where there is a way out close by, they are
  /// in it, also in a tangle that nothing from outside finds its way into.
  void near_starts(Method method, std::uint64_t streams) {
    const int tries = deadline_.microseconds > 0 ? 5 : 12;  // in each ball: pockets are small
    for (Lane& lane : lanes_) lane.near = smallest_ball(probe_);
    round([&](std::size_t k, Lane& lane) {
      Random random = stream(streams + k);
      LeapDescent& leaps = descent_of(lane, method);
      for (double radius = lane.near; radius < 4 * probe_.mass.radius; radius *= 1.6)
        if (const auto y = free_sample(leaps, random, Vec6::Zero(), radius, tries, method)) {
          lane.near = std::max(smallest_ball(probe_), 0.3 * y->norm());
          return descend(leaps, *y, y->norm());
        }
      return Found{};
    });
  }

  /// Where the sketches of the bodies are apart nearest by, and where there is a way out that they
  /// do not show; else from the nearest free poses.
  void first_starts(Method method, std::uint64_t streams) {
    if (sketched_.empty()) return near_starts(method, streams);
    const std::vector<SketchEnd> ends = search_sketches(
        chart_,
        {.method = method,
         .fewest = method == options_.method ? 48 : 16,
         .seed = options_.seed,
         .deadline = {share_for_sketches * deadline_.microseconds, deadline_.started}},
        sketched_, crew_);
    from_sketches(method, ends);
    if (method == options_.method && found_.empty()) return near_starts(method, streams);
    if (!out_of_budget()) pockets(method, streams);
  }

  /// On from the ends found there, as long as they may be better than what has been found.
  void from_sketches(Method method, const std::vector<SketchEnd>& ends) {
    const double off = 0.3 * sketched_[0].spacing();
    for (std::size_t first = 0; first < std::min<std::size_t>(ends.size(), 8) && !out_of_budget();
         first += 2) {
      const double beat = method == options_.method ? best_ : translated_.depth;
      if (ends[first].depth - off > 1.02 * beat) break;
      round(
          [&](std::size_t k, Lane& lane) {
            const SketchEnd& end = ends[first + k];
            const auto y = freed(end.y, method, lane);
            Found out = y ? descend_exactly(descent_of(lane, method), *y, beat) : Found{};
            out.starts = method == options_.method ? end.starts : 0;
            return out;
          },
          std::min<std::size_t>(2, ends.size() - first));
    }
  }

  /// A free pose near an end on the sketches: where they are further apart.
  std::optional<Vec6> freed(const Vec6& end, Method method, Lane& lane) {
    SketchDescent& sketches = sketched_[static_cast<std::size_t>(&lane - lanes_.data())];
    Vec6 y = end;
    for (const double apart : {0.0, 0.1, 0.3, 0.6, 1.2}) {
      if (apart > 0)
        y = sketches
                .run(chart_, y,
                     {.method = method, .margin = apart * sketches.spacing(), .steps = 4})
                .y;
      if (descent_of(lane, method).is_free(chart_, y)) return y;
    }
    return std::nullopt;
  }

  /// From free poses nearer than the best so far: there must be none, but where there is a way out
  /// too narrow for the sketches to show it.
  void pockets(Method method, std::uint64_t streams) {
    round([&](std::size_t k, Lane& lane) {
      Random random = stream(streams + k);
      const double best = method == options_.method ? best_ : translated_.depth;
      for (double radius = 0.1 * best; radius < best; radius *= 1.5)
        if (const auto y =
                free_sample(descent_of(lane, method), random, Vec6::Zero(), radius, 2, method))
          return descend(descent_of(lane, method), *y, best);
      return Found{};
    });
  }

  /// From outside to contact along the axes, and along the line of the middles.
  void starts_outside() {
    const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
    const Vec3 offset = chart_.com() - center;
    const double half = (fixed_.tree.high - center).norm();
    const double away = 1.01 * (offset.norm() + half + probe_.mass.radius);
    round([&](std::size_t k, Lane& lane) {
      const auto axis = static_cast<int>(k / 2) % 3;
      Vec3 way = k < 6 ? Vec3(Vec3::Unit(axis)) : offset;
      if (k % 2 == 1) way = -way;
      if (!(way.norm() > 0)) way = Vec3::Ones();
      Vec6 y = Vec6::Zero();
      y.tail<3>() = away * way.normalized();
      y = lane.pdt.pull_in(chart_, y);
      return descend(lane.pdt, y, best_);
    });
  }

  /// By translation alone; and on from there by all six.
  void translations() {
    const std::size_t before = found_.size();
    first_starts(Method::pdt, 1000);
    if (!rotates() || found_.size() == before) starts_outside();
    if (!rotates() || out_of_budget() || !std::isfinite(translated_.depth)) return;
    share_ = steps_left();
    note(descend(lanes_[0].pdg, translated_.y, best_));
  }

  /// Random poses of a ball about y: a free one, if there is one among so many.
  std::optional<Vec6> free_sample(const LeapDescent& leaps, Random& random, const Vec6& center,
                                  double radius, int tries, Method method) const {
    for (int i = 0; i < tries && !searching_.passed(); ++i) {
      Vec6 y = center + random.in_ball(radius);
      if (method == Method::pdt) y.head<3>().setZero();
      for (int k = 0; k < 3; ++k)
        if (!(probe_.mass.inertia[k] > 0)) y[k] = 0;
      if (chart_.v(y).norm() < 0.9 && leaps.is_free(chart_, y)) return y;
    }
    return std::nullopt;
  }
  Random stream(std::uint64_t number) const {
    Random mixed(options_.seed + 0x51ed270b0f5a1d27ULL * number);
    return Random(mixed.next());
  }

  /// From random free poses of balls somewhat larger than the best depth so far; and near the best
  /// that were found, since where there are many places to end in the better ones lie together.
  void random_starts(int first) {
    const double best = best_;
    const std::vector<Vec6> ends = best_ends(3);
    round([&](std::size_t k, Lane& lane) {
      Random random = stream(static_cast<std::uint64_t>(first) + k);
      if (k >= 3) return start_near(ends[(k - 3) % ends.size()], best, random, lane);
      constexpr double widths[] = {0.75, 1.15, 1.5};
      const double widest = widths[k];
      std::optional<Vec6> y;
      for (double grown = 1; !y && grown < 4 && !searching_.passed(); grown *= 1.2)
        y = free_sample(descent_of(lane, options_.method), random, Vec6::Zero(),
                        grown * widest * best, 50, options_.method);
      return y ? descend(descent_of(lane, options_.method), *y, best) : Found{};
    });
  }

  Found start_near(const Vec6& end, double best, Random& random, Lane& lane) {
    const double radius = best * random.uniform(0.03, 0.5);
    const auto y =
        free_sample(descent_of(lane, options_.method), random, end, radius, 50, options_.method);
    Found out = y ? descend(descent_of(lane, options_.method), *y, best) : Found{};
    out.starts = 0;
    return out;
  }

  /// The nearest of all ends, no two of them close together.
  std::vector<Vec6> best_ends(std::size_t count) {
    std::stable_sort(found_.begin(), found_.end(), nearer);
    std::vector<Vec6> ends;
    for (const Found& f : found_) {
      if (ends.size() == count) break;
      const bool known = std::ranges::any_of(
          ends, [&](const Vec6& y) { return (y - f.y).norm() < 0.02 * f.depth; });
      if (!known) ends.push_back(f.y);
    }
    return ends;
  }

  /// The best few to the last digit; the best of them that stands the exact test.
  Separation finish() {
    std::vector<Separation> answers;
    for (const Vec6& y : best_ends(3)) {
      if (y.norm() > 1.03 * best_ || (late() && !answers.empty())) break;
      answers.push_back(polish(descent_of(lanes_[0], options_.method), descent_, y));
    }
    std::optional<double> pdt;
    if (rotates() && (!deadline_.passed() || answers.empty())) pdt = add_translation(answers);

    std::stable_sort(answers.begin(), answers.end(),
                     [](const Separation& a, const Separation& b) { return a.depth < b.depth; });
    for (Separation& answer : answers) {
      if (overlap(probe_, fixed_, Transform(answer.separated), Doubt::exact)) continue;
      answer.iterations = iterations_;
      answer.pdt = rotates() ? pdt : answer.depth;
      return answer;
    }
    return failed(chart_.device(), "no separated pose stood the exact test");
  }

  /// To the last digit. What leaps do not bring to an end is swept there.
  Separation polish(LeapDescent& leaps, Descent& descent, const Vec6& from) {
    if (late()) {
      // Free it is: all that is left to do is to let it touch.
      iterations_ += 1;
      return make_separation(
          chart_, descent.run(chart_, from, {.steps = 0}, 1e-3 * from.norm(), deadline_));
    }
    const LeapGoal near{
        .guide = Guide::few, .tolerance = 1e-3, .steps = std::min(20, steps_left()), .reach = 0.05};
    auto o = leaps.run(chart_, from, near, deadline_);
    int taken = o.iterations;
    const LeapGoal fine{.guide = Guide::many,
                        .tolerance = 1e-4,
                        .steps = std::min(30, steps_left() - taken),
                        .reach = 0.005};
    o = leaps.run(chart_, o.y, fine, deadline_);
    taken += o.iterations;
    if (!o.converged) {
      const DescentGoal swept{.steps = std::clamp(steps_left() - taken, 0, 60)};
      o = descent.run(chart_, o.y, swept, 1e-3 * o.y.norm(), deadline_);
      taken += o.iterations;
    }
    iterations_ += taken;
    return make_separation(chart_, o);
  }

  /// The translational depth to the last digit. Where it competes with all six degrees, they go on
  /// from there: what holds the probe against a turn as well makes it an answer of theirs.
  std::optional<double> add_translation(std::vector<Separation>& answers) {
    if (!std::isfinite(translated_.depth)) return std::nullopt;
    Descent descent(probe_, fixed_, Method::pdt, unlisted);
    const Separation out = polish(lanes_[0].pdt, descent, translated_.y);
    if (overlap(probe_, fixed_, Transform(out.separated), Doubt::exact)) return std::nullopt;
    const bool competes = std::ranges::all_of(
        answers, [&](const Separation& a) { return out.depth < 1.001 * a.depth; });
    answers.push_back(out);
    if (!competes || late()) return out.depth;
    const Separation on = polish(lanes_[0].pdg, descent_, chart_.coordinates(out.separated));
    if (!overlap(probe_, fixed_, Transform(on.separated), Doubt::exact)) answers.back() = on;
    return std::max(out.depth, on.depth);  // the same, but for rounding, where no turn helps
  }

  static bool nearer(const Found& a, const Found& b) { return a.depth < b.depth; }

  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  Deadline deadline_, searching_;
  std::array<Lane, 2> lanes_;
  Descent descent_;
  std::vector<SketchDescent> sketched_;  // one for each lane, or none
  Crew crew_;
  std::vector<Found> found_;
  Found translated_;
  double best_ = std::numeric_limits<double>::infinity();  // m
  int agreeing_ = 0;
  int share_ = 0;     // of the steps, for each start of a round
  int reserved_ = 0;  // of the steps, for later
  int iterations_ = 0;
};

/// Of the probe's radius: where coordinates are rounded by more, contacts mean nothing.
constexpr double largest_rounding = 0.01;

/// Is the probe's ball about its centre of mass clear of the box around the fixed body?
bool ball_is_clear(const Body& probe, const Body& fixed, const Transform& X, double rounding) {
  const Vec3 com = X * probe.mass.com;
  const Vec3 nearest = com.cwiseMax(fixed.tree.low).cwiseMin(fixed.tree.high);
  return (com - nearest).stableNorm() > probe.mass.radius + rounding;
}

}  // namespace

Separation separate_static(const Body& probe, const Body& fixed, const Pose& X_FM,
                           const StaticOptions& options) {
  if (!is_finite(X_FM)) return failed(X_FM, "the pose is not finite");
  const Pose device{X_FM.q.normalized(), X_FM.p};
  // Without a look at the trees: rounding that is as large as a body makes all boxes overlap.
  const double rounding = rounding_guard(extent(probe), extent(fixed), device.p);
  if (ball_is_clear(probe, fixed, Transform(device), rounding)) return separated_at(device);
  if (rounding > largest_rounding * probe.mass.radius)
    return failed(device, "too far from the origin for the size of the probe");
  const Deadline deadline{options.budget.microseconds, now_us()};
  Separation out;
  if (!overlap(probe, fixed, Transform(device), Doubt::exact))
    out = separated_at(device);
  else
    out = Search(probe, fixed, device, options).run();
  if (options.want_lower_bound && out.status == Status::penetrating)
    out.lower_bound = depth_lower_bound(probe, fixed, device, deadline);
  return out;
}

}  // namespace sonde
