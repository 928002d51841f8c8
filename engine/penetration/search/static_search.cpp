// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/static_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/base/thread_pair.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/refinement.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/search_worker.hpp"
#include "engine/penetration/search/sketch_search.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {
namespace {

/// Starts that are descended side by side; what they find counts from the next round on, so that it
/// does not matter how many threads there are.
constexpr std::size_t per_round = 8;
/// Of the time: until when sketches are searched, until when anything is, and until when what was
/// found is refined. The rest is for the exact test.
constexpr double share_for_sketches = 0.45, share_for_the_search = 0.7, share_for_refining = 0.97;
/// µs: a second thread takes a tenth of a millisecond to come and go, and rounds wait for the
/// longest of their starts. With less time than this one finds as much, and keeps the time better.
constexpr double shortest_for_two_threads = 5000;
/// Starts on sketches, for the depth asked for and for translations on the way.
constexpr int sketch_starts = 32, sketch_starts_of_translations = 8;
/// Overlaps near the device pose that are pushed apart.
constexpr std::size_t pushes = 6;
/// Of the best depth: overlaps further out are not pushed apart, and where it has been pushed to
/// within so much of the best place it would come down there.
constexpr double far_out = 1.3, close_by = 0.1;
/// Of counted steps, for a first translation: there is to be one, whatever they are.
constexpr int steps_of_first_translation = 8;

bool is_limited(const Budget& budget) { return budget.microseconds > 0 || budget.steps > 0; }
bool is_short(const Budget& budget) {
  return budget.microseconds > 0 && budget.microseconds < shortest_for_two_threads;
}

class Search {
 public:
  Search(const Pair& pair, const Pose& device, const StaticOptions& options,
         const Deadline& deadline)
      : pair_(pair),
        probe_(pair.probe()),
        fixed_(pair.fixed()),
        chart_(probe_.mass, device),
        options_(options),
        deadline_(deadline.part(share_for_refining)),
        searching_(deadline.part(share_for_the_search)),
        sketching_(deadline.part(share_for_sketches)),
        lanes_{SearchWorker(probe_, fixed_), SearchWorker(probe_, fixed_)},
        refinement_(probe_, fixed_, options.method),
        threads_(options.two_threads && !is_short(options.budget)) {
    const Sketches& sketches = pair.sketches();
    if (!sketches) return;
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane)
      sketched_.emplace_back(*sketches.probe, *sketches.fixed, fixed_.mass);
  }

  Separation run() {
    // The finished translation is a start, and the depth is never more than its: it is that which a
    // search for it alone gives.
    if (rotates() && !is_limited(options_.budget)) finished_translation();
    if (rotates() && counts_steps()) first_translation();
    if (rotates()) first_starts(Method::pdg, 2000);
    if (!rotates() || optima_.empty() || options_.budget.steps > 0) translations();
    if (optima_.empty()) return failed(chart_.device(), "no free pose was found");
    for (int start = 0; start < options_.starts && !done(); start += int{per_round})
      random_starts(start);
    if (rotates() && !std::isfinite(translated_.depth) && !out_of_budget()) translations();
    return finish();
  }

 private:
  using Round = std::array<LocalOptimum, per_round>;
  bool rotates() const { return options_.method == Method::pdg; }
  double best_of(Method method) const {
    return method == options_.method ? optima_.best() : translated_.depth;
  }

  bool out_of_budget() const { return searching_.passed() || steps_left() == 0; }
  bool done() const { return out_of_budget() || optima_.agreeing() >= options_.agreement; }
  bool solid() const { return probe_.solid && fixed_.solid; }
  bool counts_steps() const { return options_.budget.steps > 0; }
  int steps_left() const {
    return counts_steps() ? std::max(0, options_.budget.steps - iterations_)
                          : std::numeric_limits<int>::max();
  }
  /// Nothing is left for refining either.
  bool late() const { return deadline_.passed() || steps_left() == 0; }
  /// Runs start(k, lane) for each of a round, and takes down what they found. Where steps are
  /// counted, two at a time: what is done with the first so many steps does not depend on how many
  /// there are, so that more of them only add to what is found. A start that there are not enough
  /// for is not made; but the first of all goes as far as they do.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    const std::size_t run_both = counts_steps() ? 2 : most;
    for (std::size_t first = 0; first < most; first += run_both) {
      if (out_of_budget() && !optima_.empty()) return;
      Round found;
      const std::size_t count = std::min(run_both, most - first);
      share_ = std::clamp(steps_left(), 1, most_steps_);
      threads_.each(count, [&](std::size_t k, std::size_t lane) {
        found[k] = start(first + k, lanes_[lane]);
      });
      for (std::size_t k = 0; k < count; ++k) take(found[k]);
    }
  }

  void take(const LocalOptimum& place) {
    if (place.iterations > steps_left() && !optima_.empty()) {
      iterations_ = options_.budget.steps;
      return;
    }
    note(place);
    if (counts_steps() && optima_.best() < settled_) settle();
  }
  void note(const LocalOptimum& place) {
    iterations_ += place.iterations;
    optima_.note(place);
    if (place.y.head<3>().isZero(0) && place.depth < translated_.depth) translated_ = place;
  }
  SearchWorker::Limits limits(double beat) const { return {share_, beat, searching_}; }

  /// The best place let come into contact: fit to be returned, should the steps end.
  void settle() {
    settled_ = optima_.best();
    add(refined(refinement_, options_.method, optima_.nearest(1)[0], 0));
  }

  /// From the nearest free poses of ever larger balls: where there is a way out close by, they are
  /// in it, also in a tangle that nothing from outside finds its way into.
  void near_starts(Method method, std::uint64_t streams) {
    const int tries = deadline_.microseconds > 0 ? 5 : 12;  // in each ball: pockets are small
    for (SearchWorker& lane : lanes_) lane.near = SearchWorker::smallest_ball(probe_);
    round([&](std::size_t k, SearchWorker& lane) {
      Random random = stream(streams + k);
      for (double radius = lane.near; radius < 4 * probe_.mass.radius; radius *= 1.6)
        if (const auto y = free_sample(lane, random, Vec6::Zero(), radius, tries, method)) {
          lane.near = std::max(SearchWorker::smallest_ball(probe_), 0.3 * y->norm());
          return lane.descend(chart_, *y, method, limits(y->norm()));
        }
      return LocalOptimum{};
    });
  }

  /// Where the sketches of the bodies are apart nearest by, and where there is a way out that they
  /// do not show; else from the nearest free poses.
  void first_starts(Method method, std::uint64_t streams) {
    round([&](std::size_t, SearchWorker& lane) { return pushed(Vec6::Zero(), method, lane); }, 1);
    if (sketched_.empty()) {
      near_starts(method, streams);
      return method == options_.method ? pushed_starts(streams + 500) : void();
    }
    const std::vector<SketchEnd> ends = search_sketches(
        chart_,
        {.method = method,
         .fewest = method == options_.method ? sketch_starts : sketch_starts_of_translations,
         .seed = options_.seed,
         .deadline = sketching_,
         .axes = fixed_.mass.R_MP},
        sketched_, threads_);
    from_sketches(method, ends);
    if (method == options_.method && optima_.empty()) return near_starts(method, streams);
    if (!out_of_budget() && method == options_.method) pushed_starts(streams + 500);
  }

  /// On from the ends found there, as long as they may be better than what has been found.
  void from_sketches(Method method, const std::vector<SketchEnd>& ends) {
    const double off = 0.3 * sketched_[0].spacing();
    for (std::size_t first = 0; first < std::min<std::size_t>(ends.size(), 8) && !out_of_budget();
         first += 2) {
      const double beat = best_of(method);
      if (ends[first].depth - off > 1.02 * beat) break;
      round(
          [&](std::size_t k, SearchWorker& lane) {
            const SketchEnd& end = ends[first + k];
            const auto y = freed(end.y, method, lane);
            LocalOptimum out =
                y ? lane.descend_exactly(chart_, *y, method, limits(beat)) : LocalOptimum{};
            out.starts = method == options_.method ? end.starts : 0;
            return out;
          },
          std::min<std::size_t>(2, ends.size() - first));
    }
  }

  /// A free pose near an end on the sketches: where they are further apart, or where the bodies
  /// push each other.
  std::optional<Vec6> freed(const Vec6& end, Method method, SearchWorker& lane) {
    SketchDescent& sketches = sketched_[static_cast<std::size_t>(&lane - lanes_.data())];
    Vec6 y = end;
    for (const double apart : {0.0, 0.1, 0.3, 0.6, 1.2}) {
      if (apart > 0)
        y = sketches
                .run(chart_, y,
                     {.method = method, .margin = apart * sketches.spacing(), .steps = 4})
                .y;
      if (lane.leaps(method).is_free(chart_, y)) return y;
    }
    return lane.push(method).from(chart_, end, std::numeric_limits<double>::infinity(), searching_);
  }

  /// Out of the overlap at y by the triangles that meet there, and down.
  LocalOptimum pushed(const Vec6& y, Method method, SearchWorker& lane) {
    const double beat = best_of(method);
    const auto free = lane.push(method).from(chart_, y, far_out * beat, searching_);
    LocalOptimum out;
    if (free && !(method == options_.method && optima_.is_known(*free, close_by)))
      out = lane.descend_exactly(chart_, *free, method, limits(beat));
    out.starts = 0;  // they all begin near the device pose
    return out;
  }

  /// From near the device pose: ways out that are too narrow for sketches and random poses.
  void pushed_starts(std::uint64_t streams) {
    round(
        [&](std::size_t k, SearchWorker& lane) {
          Random random = stream(streams + k);
          const double radius =
              random.uniform(0.1, 0.8) * std::min(optima_.best(), probe_.mass.radius);
          return pushed(lane.sample(random, radius, options_.method), options_.method, lane);
        },
        rotates() ? pushes : pushes / 2);
  }

  /// From outside to contact along the line of the middles, and along the fixed body's axes: there
  /// is always a free pose. Only along the first where time is over.
  void starts_outside(std::size_t most) {
    const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
    const Vec3 offset = chart_.com() - center;
    const double half = (fixed_.tree.high - center).norm();
    const double away = 1.01 * (offset.norm() + half + probe_.mass.radius);
    const auto start = [&](std::size_t k, SearchWorker& lane) {
      const auto axis = static_cast<int>(k / 2) - 1;
      Vec3 way = axis < 0 ? offset : Vec3(fixed_.mass.R_MP.col(axis));
      if (k % 2 == 1) way = -way;
      if (!(way.norm() > 0)) way = Vec3::Ones();
      Vec6 y = Vec6::Zero();
      y.tail<3>() = away * way.normalized();
      y = lane.leaps(Method::pdt).pull_in(chart_, y);
      return lane.descend(chart_, y, Method::pdt, limits(optima_.best()));
    };
    round(start, most);
  }

  /// By translation alone; and on from there by all six.
  void translations() {
    if (!searching_.passed()) first_starts(Method::pdt, 1000);
    if (!rotates() || !std::isfinite(translated_.depth))
      starts_outside(searching_.passed() ? 2 : per_round);
    if (!rotates() || out_of_budget() || !std::isfinite(translated_.depth)) return;
    share_ = steps_left();
    take(lanes_[0].descend(chart_, translated_.y, Method::pdg, limits(optima_.best())));
  }

  /// Some way out by translation alone, at small cost.
  void first_translation() {
    most_steps_ = steps_of_first_translation;
    const auto from_device = [&](std::size_t, SearchWorker& lane) {
      return pushed(Vec6::Zero(), Method::pdt, lane);
    };
    round(from_device, 1);
    if (!std::isfinite(translated_.depth)) starts_outside(1);
    most_steps_ = std::numeric_limits<int>::max();
  }

  /// By translation alone to the end.
  void finished_translation() {
    StaticOptions options = options_;
    options.method = Method::pdt;
    const Separation found = Search(pair_, chart_.device(), options, {}).run();
    iterations_ += found.iterations;
    limited_ += found.limited;
    if (found.status != Status::penetrating) return;
    translated_.y = chart_.coordinates(found.separated);
    translated_.y.head<3>().setZero();
    translated_.depth = found.depth;
    share_ = steps_left();
    finished_ = found;
    note(lanes_[0].descend_exactly(chart_, translated_.y, Method::pdg, limits(0)));
  }

  std::optional<Vec6> free_sample(SearchWorker& lane, Random& random, const Vec6& center,
                                  double radius, int tries, Method method) const {
    return lane.free_sample(chart_, random, center, radius, tries, method, searching_);
  }
  Random stream(std::uint64_t number) const {
    Random mixed(options_.seed + 0x51ed270b0f5a1d27ULL * number);
    return Random(mixed.next());
  }

  /// From random free poses of balls somewhat larger than the best depth so far; and near the best
  /// that were found, since where there are many places to end in the better ones lie together.
  void random_starts(int first) {
    const double best = optima_.best();
    const std::vector<Vec6> ends = optima_.nearest(6);
    round([&](std::size_t k, SearchWorker& lane) {
      Random random = stream(static_cast<std::uint64_t>(first) + k);
      if (k >= 3) {
        const std::size_t turn = static_cast<std::size_t>(first) / per_round * (per_round - 3) + k;
        return start_near(ends[turn % ends.size()], best, random, lane);
      }
      // Every other time out of an overlap, where there is an inside to come out of.
      if (solid() && static_cast<std::size_t>(first) / per_round % 2 == 0) {
        const Vec6 y = lane.sample(random, random.uniform(0.1, 1.2) * best, options_.method);
        LocalOptimum out = pushed(y, options_.method, lane);
        out.starts = 1;
        return out;
      }
      constexpr double widths[] = {0.75, 1.15, 1.5};
      const double widest = widths[k];
      std::optional<Vec6> y;
      for (double grown = 1; !y && grown < 4 && !searching_.passed(); grown *= 1.2)
        y = free_sample(lane, random, Vec6::Zero(), grown * widest * best, 50, options_.method);
      return y ? lane.descend(chart_, *y, options_.method, limits(best)) : LocalOptimum{};
    });
  }

  LocalOptimum start_near(const Vec6& end, double best, Random& random, SearchWorker& lane) {
    const double part = random.uniform(0, 1), radius = best * (0.03 + 0.47 * part * part);
    const auto y = free_sample(lane, random, end, radius, 50, options_.method);
    LocalOptimum out = y ? lane.descend(chart_, *y, options_.method, limits(best)) : LocalOptimum{};
    out.starts = 0;
    return out;
  }

  /// The best few to the last digit; the best of all that stand the exact test.
  Separation finish() {
    for (const Vec6& y : optima_.nearest(3)) {
      if (y.norm() > 1.03 * optima_.best() || (late() && best_)) break;
      add(refined(refinement_, options_.method, y, steps_left()));
    }
    std::optional<double> pdt;
    if (rotates() && (finished_ || !deadline_.passed() || !best_)) pdt = add_translation();
    if (!best_) return failed(chart_.device(), "no separated pose stood the exact test");
    best_->iterations = iterations_;
    best_->limited = limited_;
    for (const SearchWorker& lane : lanes_) best_->limited += lane.limited();
    best_->pdt = rotates() ? pdt : best_->depth;
    return *best_;
  }

  /// The nearest pose that is verified free is the answer, whatever ends the search.
  void add(const Separation& answer) {
    if (best_ && best_->depth <= answer.depth) return;
    if (!overlap(probe_, fixed_, Transform(answer.separated), Doubt::exact)) best_ = answer;
  }

  Separation refined(Refinement& refinement, Method method, const Vec6& from, int steps) {
    const Descent::Outcome out =
        refinement.run(chart_, from, lanes_[0].leaps(method), steps, deadline_);
    iterations_ += out.iterations;
    return make_separation(chart_, out);
  }

  /// The translational depth to the last digit. Where it competes with all six degrees, they go on
  /// from there: what holds the probe against a turn as well makes it an answer of theirs.
  std::optional<double> add_translation() {
    if (!std::isfinite(translated_.depth)) return std::nullopt;
    Refinement refinement(probe_, fixed_, Method::pdt);
    const Separation out =
        finished_ ? *finished_ : refined(refinement, Method::pdt, translated_.y, steps_left());
    if (overlap(probe_, fixed_, Transform(out.separated), Doubt::exact)) return std::nullopt;
    const bool competes = !best_ || out.depth < 1.001 * best_->depth;
    if (competes && !late())
      add(refined(refinement_, Method::pdg, chart_.coordinates(out.separated), steps_left()));
    else
      add(out);
    return std::max(out.depth, best_->depth);  // the same, but for rounding, where no turn helps
  }

  const Pair& pair_;
  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  Deadline deadline_, searching_, sketching_;
  std::array<SearchWorker, 2> lanes_;
  Refinement refinement_;
  std::vector<SketchDescent> sketched_;  // one for each lane, or none
  ThreadPair threads_;
  LocalOptima optima_;
  LocalOptimum translated_;
  std::optional<Separation> best_;      // of those refined and verified
  std::optional<Separation> finished_;  // the translation, from a search of its own
  double settled_ = std::numeric_limits<double>::infinity();  // m: what has come into contact
  int most_steps_ = std::numeric_limits<int>::max();          // of a start
  int share_ = 0;                                             // steps that a start may take
  int iterations_ = 0;
  int limited_ = 0;
};

}  // namespace

Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options) {
  const Deadline deadline{options.budget.microseconds, now_us()};
  const Pose device = is_finite(X_FM) ? Pose{X_FM.q.normalized(), X_FM.p} : X_FM;
  if (const auto settled = trivial_separation(pair.probe(), pair.fixed(), device)) return *settled;
  Separation out = Search(pair, device, options, deadline).run();
  if (options.want_lower_bound && out.status == Status::penetrating)
    out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), device, deadline);
  return out;
}

}  // namespace sonde
