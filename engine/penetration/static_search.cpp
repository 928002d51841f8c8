// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/static_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/geometry/body.hpp"
#include "engine/penetration/crew.hpp"
#include "engine/penetration/leap_descent.hpp"
#include "engine/penetration/lower_bound.hpp"
#include "engine/penetration/places.hpp"
#include "engine/penetration/polish.hpp"
#include "engine/penetration/random.hpp"
#include "engine/penetration/result.hpp"
#include "engine/penetration/sketch_search.hpp"
#include "engine/penetration/without_search.hpp"
#include "engine/proximity/intersect.hpp"
#include "engine/proximity/sketch.hpp"

namespace sonde {
namespace {

/// Starts that are descended side by side; what they find counts from the next round on, so that it
/// does not matter how many threads there are.
constexpr std::size_t per_round = 8;
/// Of the time: until when sketches are searched, until when anything is, and until when what was
/// found is polished. The rest is for the exact test.
constexpr double share_for_sketches = 0.45, share_for_the_search = 0.7, share_for_polish = 0.97;
/// µs: a second thread takes a tenth of a millisecond to come and go, and rounds wait for the
/// longest of their starts. With less time than this one finds as much, and keeps the time better.
constexpr double shortest_for_two_threads = 5000;
/// Starts on sketches, for the depth asked for and for translations on the way.
constexpr int sketch_starts = 48, sketch_starts_of_translations = 8;

bool is_short(const Budget& budget) {
  return budget.microseconds > 0 && budget.microseconds < shortest_for_two_threads;
}

class Search {
 public:
  Search(const Pair& pair, const Pose& device, const StaticOptions& options,
         const Deadline& deadline)
      : probe_(pair.probe()),
        fixed_(pair.fixed()),
        chart_(probe_.mass, device),
        options_(options),
        deadline_(deadline.part(share_for_polish)),
        searching_(deadline.part(share_for_the_search)),
        sketching_(deadline.part(share_for_sketches)),
        lanes_{lane(probe_, fixed_), lane(probe_, fixed_)},
        polish_(probe_, fixed_, options.method),
        crew_(options.two_threads && !is_short(options.budget)) {
    const Sketches& sketches = pair.sketches();
    if (!sketches) return;
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane)
      sketched_.emplace_back(*sketches.probe, *sketches.fixed, fixed_.mass);
  }

  Separation run() {
    // Of counted steps, translations get their part: the depth is never more than theirs.
    reserved_ = rotates() ? options_.budget.steps / 3 : 0;
    if (rotates()) first_starts(Method::pdg, 2000);
    reserved_ = 0;
    if (!rotates() || places_.empty() || options_.budget.steps > 0) translations();
    if (places_.empty()) return failed(chart_.device(), "no free pose was found");
    for (int start = 0; start < options_.starts && !done(); start += int{per_round})
      random_starts(start);
    if (rotates() && !std::isfinite(translated_.depth) && !out_of_budget()) translations();
    return finish();
  }

 private:
  using Round = std::array<Place, per_round>;
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
  bool done() const { return out_of_budget() || places_.agreeing() >= options_.agreement; }
  int steps_left() const {
    return options_.budget.steps > 0 ? std::max(0, options_.budget.steps - reserved_ - iterations_)
                                     : std::numeric_limits<int>::max();
  }
  /// Nothing is left for polishing either.
  bool late() const { return deadline_.passed() || steps_left() == 0; }
  /// Runs start(k, lane) for each of a round, and takes down what they found.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    if (out_of_budget() && !places_.empty()) return;
    Round found;
    // Each has an equal share of the steps left, and some are not made where it is small.
    const std::size_t count =
        std::min(most, static_cast<std::size_t>(std::max(1, steps_left() / 4)));
    share_ = std::max(1, steps_left() / static_cast<int>(count));
    crew_.each(count, [&](std::size_t k, std::size_t lane) { found[k] = start(k, lanes_[lane]); });
    for (std::size_t k = 0; k < count; ++k) note(found[k]);
  }

  void note(const Place& place) {
    iterations_ += place.iterations;
    places_.note(place);
    if (place.y.head<3>().isZero(0) && place.depth < translated_.depth) translated_ = place;
  }

  /// Down by leaps, roughly and where that is promising by the true contacts.
  Place descend(LeapDescent& leaps, const Vec6& y, double beat) const {
    const auto rough = leaps.run(
        chart_, y, {.steps = std::min(15, share_), .reach = 0.3, .beat = 1.1 * beat}, searching_);
    Place out{rough.y, rough.y.norm(), rough.iterations};
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

  Place descend_exactly(LeapDescent& leaps, const Vec6& y, double beat) const {
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
  /// in it, also in a tangle that nothing from outside finds its way into. So many of
  /// them, no further than `widest`.
  void near_starts(Method method, std::uint64_t streams, double widest,
                   std::size_t most = per_round) {
    const int tries = deadline_.microseconds > 0 ? 5 : 12;  // in each ball: pockets are small
    for (Lane& lane : lanes_) lane.near = smallest_ball(probe_);
    const auto start = [&](std::size_t k, Lane& lane) {
      Random random = stream(streams + k);
      LeapDescent& leaps = descent_of(lane, method);
      for (double radius = lane.near; radius < widest; radius *= 1.6)
        if (const auto y = free_sample(leaps, random, Vec6::Zero(), radius, tries, method)) {
          lane.near = std::max(smallest_ball(probe_), 0.3 * y->norm());
          return descend(leaps, *y, y->norm());
        }
      return Place{};
    };
    round(start, most);
  }

  /// Where the sketches of the bodies are apart nearest by, and where there is a way out that they
  /// do not show; else from the nearest free poses.
  void first_starts(Method method, std::uint64_t streams) {
    const double widest = 4 * probe_.mass.radius;
    if (sketched_.empty()) return near_starts(method, streams, widest);
    const std::vector<SketchEnd> ends = search_sketches(
        chart_,
        {.method = method,
         .fewest = method == options_.method ? sketch_starts : sketch_starts_of_translations,
         .seed = options_.seed,
         .deadline = sketching_,
         .axes = fixed_.mass.R_MP},
        sketched_, crew_);
    from_sketches(method, ends);
    if (method == options_.method && places_.empty()) return near_starts(method, streams, widest);
    if (out_of_budget()) return;
    // Translations are three unknowns: free ones are found by few tests, however narrow the way.
    if (method == Method::pdt) near_starts(method, streams, std::min(widest, translated_.depth), 2);
    if (method == options_.method) pockets(streams);
  }

  /// On from the ends found there, as long as they may be better than what has been found.
  void from_sketches(Method method, const std::vector<SketchEnd>& ends) {
    const double off = 0.3 * sketched_[0].spacing();
    for (std::size_t first = 0; first < std::min<std::size_t>(ends.size(), 8) && !out_of_budget();
         first += 2) {
      const double beat = method == options_.method ? places_.best() : translated_.depth;
      if (ends[first].depth - off > 1.02 * beat) break;
      round(
          [&](std::size_t k, Lane& lane) {
            const SketchEnd& end = ends[first + k];
            const auto y = freed(end.y, method, lane);
            Place out = y ? descend_exactly(descent_of(lane, method), *y, beat) : Place{};
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
  void pockets(std::uint64_t streams) {
    round([&](std::size_t k, Lane& lane) {
      Random random = stream(streams + k);
      LeapDescent& leaps = descent_of(lane, options_.method);
      const double best = places_.best();
      for (double radius = 0.1 * best; radius < best; radius *= 1.5)
        if (const auto y = free_sample(leaps, random, Vec6::Zero(), radius, 2, options_.method))
          return descend(leaps, *y, best);
      return Place{};
    });
  }

  /// From outside to contact along the line of the middles, and along the fixed body's axes: there
  /// is always a free pose. Only along the first where time is over.
  void starts_outside() {
    const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
    const Vec3 offset = chart_.com() - center;
    const double half = (fixed_.tree.high - center).norm();
    const double away = 1.01 * (offset.norm() + half + probe_.mass.radius);
    const auto start = [&](std::size_t k, Lane& lane) {
      const auto axis = static_cast<int>(k / 2) - 1;
      Vec3 way = axis < 0 ? offset : Vec3(fixed_.mass.R_MP.col(axis));
      if (k % 2 == 1) way = -way;
      if (!(way.norm() > 0)) way = Vec3::Ones();
      Vec6 y = Vec6::Zero();
      y.tail<3>() = away * way.normalized();
      y = lane.pdt.pull_in(chart_, y);
      return descend(lane.pdt, y, places_.best());
    };
    round(start, searching_.passed() ? 2 : per_round);
  }

  /// By translation alone; and on from there by all six.
  void translations() {
    if (!searching_.passed()) first_starts(Method::pdt, 1000);
    if (!rotates() || !std::isfinite(translated_.depth)) starts_outside();
    if (!rotates() || out_of_budget() || !std::isfinite(translated_.depth)) return;
    share_ = steps_left();
    note(descend(lanes_[0].pdg, translated_.y, places_.best()));
  }

  /// Random poses of a ball about y: a free one, if there is one among so many.
  std::optional<Vec6> free_sample(const LeapDescent& leaps, Random& random, const Vec6& center,
                                  double radius, int tries, Method method) const {
    for (int i = 0; i < tries && !searching_.passed(); ++i) {
      Vec6 y = random.in_ball(radius);
      y.tail<3>() = fixed_.mass.R_MP * y.tail<3>();  // not to depend on how the world is turned
      y += center;
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
    const double best = places_.best();
    const std::vector<Vec6> ends = places_.nearest(6);
    round([&](std::size_t k, Lane& lane) {
      Random random = stream(static_cast<std::uint64_t>(first) + k);
      if (k >= 3) {
        const std::size_t turn = static_cast<std::size_t>(first) / per_round * (per_round - 3) + k;
        return start_near(ends[turn % ends.size()], best, random, lane);
      }
      constexpr double widths[] = {0.75, 1.15, 1.5};
      const double widest = widths[k];
      std::optional<Vec6> y;
      for (double grown = 1; !y && grown < 4 && !searching_.passed(); grown *= 1.2)
        y = free_sample(descent_of(lane, options_.method), random, Vec6::Zero(),
                        grown * widest * best, 50, options_.method);
      return y ? descend(descent_of(lane, options_.method), *y, best) : Place{};
    });
  }

  Place start_near(const Vec6& end, double best, Random& random, Lane& lane) {
    const double part = random.uniform(0, 1), radius = best * (0.03 + 0.47 * part * part);
    const auto y =
        free_sample(descent_of(lane, options_.method), random, end, radius, 50, options_.method);
    Place out = y ? descend(descent_of(lane, options_.method), *y, best) : Place{};
    out.starts = 0;
    return out;
  }

  /// The best few to the last digit; the best of them that stands the exact test.
  Separation finish() {
    std::vector<Separation> answers;
    for (const Vec6& y : places_.nearest(3)) {
      if (y.norm() > 1.03 * places_.best() || (late() && !answers.empty())) break;
      answers.push_back(polished(polish_, descent_of(lanes_[0], options_.method), y));
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

  Separation polished(Polish& polish, LeapDescent& leaps, const Vec6& from) {
    const Descent::Outcome out = polish.run(chart_, from, leaps, steps_left(), deadline_);
    iterations_ += out.iterations;
    return make_separation(chart_, out);
  }

  /// The translational depth to the last digit. Where it competes with all six degrees, they go on
  /// from there: what holds the probe against a turn as well makes it an answer of theirs.
  std::optional<double> add_translation(std::vector<Separation>& answers) {
    if (!std::isfinite(translated_.depth)) return std::nullopt;
    Polish polish(probe_, fixed_, Method::pdt);
    const Separation out = polished(polish, lanes_[0].pdt, translated_.y);
    if (overlap(probe_, fixed_, Transform(out.separated), Doubt::exact)) return std::nullopt;
    const bool competes = std::ranges::all_of(
        answers, [&](const Separation& a) { return out.depth < 1.001 * a.depth; });
    answers.push_back(out);
    if (!competes || late()) return out.depth;
    const Separation on = polished(polish_, lanes_[0].pdg, chart_.coordinates(out.separated));
    if (!overlap(probe_, fixed_, Transform(on.separated), Doubt::exact)) answers.back() = on;
    return std::max(out.depth, on.depth);  // the same, but for rounding, where no turn helps
  }

  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  Deadline deadline_, searching_, sketching_;
  std::array<Lane, 2> lanes_;
  Polish polish_;
  std::vector<SketchDescent> sketched_;  // one for each lane, or none
  Crew crew_;
  Places places_;
  Place translated_;
  int share_ = 0;     // of the steps, for each start of a round
  int reserved_ = 0;  // of the steps, for later
  int iterations_ = 0;
};

}  // namespace

Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options) {
  const Deadline deadline{options.budget.microseconds, now_us()};
  const Pose device = is_finite(X_FM) ? Pose{X_FM.q.normalized(), X_FM.p} : X_FM;
  if (const auto settled = without_search(pair.probe(), pair.fixed(), device)) return *settled;
  Separation out = Search(pair, device, options, deadline).run();
  if (options.want_lower_bound && out.status == Status::penetrating)
    out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), device, deadline);
  return out;
}

}  // namespace sonde
