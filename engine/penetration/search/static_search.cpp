// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/static_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/base/thread_pair.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/sketch_search.hpp"
#include "engine/penetration/search/starts.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/penetration/search/verified.hpp"

namespace sonde {
namespace {

/// Starts that are descended side by side; what they find counts from the next round on.
constexpr std::size_t per_round = Starts::per_round;
/// Of the time: until when sketches are searched, until when anything is, and until when what was
/// found is refined. The rest is for the exact test.
constexpr double share_for_sketches = 0.45, share_for_the_search = 0.7, share_for_refining = 0.97;
/// µs: a second thread takes a tenth of a millisecond to come and go, and rounds wait for the
/// longest of their starts. With less time than this one finds as much, and keeps the time better.
constexpr double shortest_for_two_threads = 5000;
/// Starts on sketches, of some 0.05 ms each: at first, until they agree or so many are made, and
/// then twice as many again and again where the ends leave it open which is the best. On the 224
/// poses of depths.csv that have sketches and three seeds, 16 of them come to within a tenth of the
/// depth of where the reference is on 442 of 672, 64 on 546, 256 on 588 and 512 on 597.
constexpr int first_sketches = 16, most_first_sketches = 64, most_sketches = 256;
constexpr int sketches_of_translations = 8;
/// Starts on sketches that agree on which end is the best.
constexpr int clear = 8;
/// Ends on sketches that the bodies themselves are taken on from: where one end stands out (four of
/// them find no more on depths.csv), at first where none does, and later.
constexpr std::size_t ends_where_clear = 2, first_ends = 8, most_ends = 24;
/// Overlaps near the device pose that are pushed apart: sketches that agree say nothing of a hole
/// that they do not show (a cylinder in a hole, conforming_test.cpp).
constexpr std::size_t pushes = 8;
/// Of the depth on sketches: where the bodies end so much deeper, sketches miss what holds them (on
/// depths.csv they end within 0.9 to 1.15 of it, but 1.7 to 5 times as deep between a solid and a
/// thin surface).
constexpr double blind = 1.3;
/// Random starts after sketches have said what they can: 384 of them find no more on depths.csv;
/// with 64, one seed of three ended 22 % too deep on a pose of comb in comb.
constexpr int most_after_sketches = 160;
/// Of the best depth: where descents ended further out nothing is refined. They end a thousandth
/// or so above what there is.
constexpr double worth_refining = 1.01;
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
        starts_(pair, chart_, searching_),
        verified_(pair, chart_),
        threads_(options.two_threads && !is_short(options.budget)),
        sketches_(chart_, sketch_goal(options.method), starts_.sketched(), threads_) {}

  Separation run() {
    if (rotates() && !is_limited(options_.budget)) finish_translation();
    if (rotates() && counts_steps()) first_translation();
    first_starts();
    more_sketches();
    if (sketched() && !out_of_budget()) pushed_starts();
    if (!rotates()) starts_outside(per_round);
    if (rotates() && (optima_.empty() || counts_steps())) translation_on_the_way();
    if (optima_.empty()) return failed(chart_.device(), "no free pose was found");
    random_rounds();
    if (rotates() && !std::isfinite(translated_.depth) && !out_of_budget())
      translation_on_the_way();
    return finish();
  }

 private:
  using Round = std::array<LocalOptimum, per_round>;
  bool rotates() const { return options_.method == Method::pdg; }
  bool sketched() const { return !starts_.sketched().empty(); }
  bool out_of_budget() const { return searching_.passed() || steps_left() == 0; }
  bool counts_steps() const { return options_.budget.steps > 0; }
  int steps_left() const {
    return counts_steps() ? std::max(0, options_.budget.steps - iterations_)
                          : std::numeric_limits<int>::max();
  }
  /// Nothing is left for refining either.
  bool late() const { return deadline_.passed() || steps_left() == 0; }

  /// Independent starts that ended at the best depth: of the bodies, and of sketches where the
  /// bodies came to it from their ends.
  int agreeing() {
    int out = optima_.agreeing();
    for (const SketchEnd& end : sketches_.ends())
      if (end.came_to >= 0 && LocalOptima::is_same(end.came_to, optima_.best())) out += end.starts;
    return out;
  }
  /// What has been found is thought to be the best there is.
  bool settled() {
    if (optima_.empty()) return false;
    if (agreeing() >= options_.agreement) return true;
    return options_.by_evidence && sketches_see() && sketches_are_clear();
  }
  bool sketches_are_clear() {
    const SketchEnd* const first = sketches_.ends().data();
    return sketches_.is_clear(clear) && first->came_to >= 0 &&
           LocalOptima::is_same(first->came_to, optima_.best());
  }
  /// What the bodies have come to is about what sketches say.
  bool sketches_see() {
    if (!sketched() || sketches_.ends().empty()) return false;
    return optima_.best() <
           blind * sketches_.ends().front().depth + 0.3 * starts_.sketched()[0].spacing();
  }

  SketchGoal sketch_goal(Method method) const {
    return {
        .method = method, .seed = options_.seed, .deadline = sketching_, .axes = fixed_.mass.R_MP};
  }
  Aim aim(Method method) const {
    const bool own = method == options_.method;
    return {.method = method,
            .beat = own ? optima_.best() : translated_.depth,
            .steps = share_,
            .known = own ? &optima_ : nullptr};
  }

  /// Runs start(k, lane) for each of a round, and takes down what they found. Where steps are
  /// counted, two at a time: what is done with the first so many steps does not depend on how many
  /// there are, so that more of them only add to what is found. A start that there are not enough
  /// for is not made; but the first of all goes as far as they do.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    const std::size_t count_at_once = counts_steps() ? 2 : most;
    for (std::size_t first = 0; first < most; first += count_at_once) {
      if (out_of_budget() && !optima_.empty()) return;
      Round found;
      const std::size_t count = std::min(count_at_once, most - first);
      share_ = std::clamp(steps_left(), 1, most_steps_);
      threads_.each(count,
                    [&](std::size_t k, std::size_t lane) { found[k] = start(first + k, lane); });
      for (std::size_t k = 0; k < count; ++k) take(found[k]);
    }
  }

  void take(const LocalOptimum& place) {
    if (place.iterations >= steps_left() && !optima_.empty()) {
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

  /// The best place let come into contact: fit to be returned, should the steps end.
  void settle() {
    settled_ = optima_.best();
    verified_.add(refined(options_.method, optima_.nearest(1)[0], 0));
  }

  /// From the sketches' ends and the device pose itself.
  void first_starts() {
    if (sketched()) {
      sketches_.go_on(first_sketches, most_first_sketches, clear);
      from_ends(sketches_, options_.method,
                rotates() && sketches_.is_clear(clear) ? ends_where_clear : first_ends);
    }
    push_device_pose(options_.method);
    if (!sketches_see()) near_starts(options_.method);
  }

  void push_device_pose(Method method) {
    round([&](std::size_t,
              std::size_t lane) { return starts_.pushed(Vec6::Zero(), aim(method), lane); },
          1);
  }

  void near_starts(Method method) {
    const int tries = deadline_.microseconds > 0 ? 5 : 12;  // in each ball: pockets are small
    for (std::size_t lane = 0; lane < 2; ++lane)
      starts_.lane(lane).near = SearchWorker::smallest_ball(probe_);
    round([&](std::size_t k, std::size_t lane) {
      return starts_.near(stream(2000 + k), tries, aim(method), lane);
    });
  }

  /// From near the device pose: ways out that are too narrow for sketches and random poses.
  void pushed_starts() {
    round(
        [&](std::size_t k, std::size_t lane) {
          Random random = stream(2500 + k);
          const double radius =
              random.uniform(0.1, 0.8) * std::min(optima_.best(), probe_.mass.radius);
          return starts_.pushed_within(radius, random, aim(options_.method), lane);
        },
        rotates() ? pushes : pushes / 2);
  }

  /// On from so many ends on the sketches that have not been tried yet, two at a time, as long as
  /// they may be better than what has been found.
  void from_ends(SketchSearch& sketches, Method method, std::size_t most) {
    const double off = 0.3 * starts_.sketched()[0].spacing();
    std::vector<SketchEnd*> next;
    for (SketchEnd& end : sketches.ends())
      if (end.came_to < 0) next.push_back(&end);
    next.resize(std::min(most, next.size()));
    const std::size_t count_at_once =
        is_short(options_.budget) ? 1 : 2;  // the nearest has all there is
    for (std::size_t first = 0; first < next.size() && !out_of_budget(); first += count_at_once) {
      const Aim at = aim(method);
      if (next[first]->depth - off > 1.02 * at.beat) break;
      round(
          [&](std::size_t k, std::size_t lane) {
            SketchEnd& end = *next[first + k];
            LocalOptimum out = starts_.sketched(end, aim(method), lane);
            out.starts = 0;  // the sketches' count
            end.came_to = out.depth;
            return out;
          },
          std::min(count_at_once, next.size() - first));
    }
  }

  /// From outside to contact. Only along the first lines where time is over.
  void starts_outside(std::size_t most) {
    round(
        [&](std::size_t k, std::size_t lane) {
          Aim at = aim(options_.method);
          at.method = Method::pdt;
          return starts_.outside(k, at, lane);
        },
        most);
  }

  /// Some way out by translation alone, at small cost.
  void first_translation() {
    most_steps_ = steps_of_first_translation;
    push_device_pose(Method::pdt);
    if (!std::isfinite(translated_.depth)) starts_outside(1);
    most_steps_ = std::numeric_limits<int>::max();
  }

  /// By translation alone, a little; and on from there by all six.
  void translation_on_the_way() {
    if (!searching_.passed()) first_translations();
    if (!std::isfinite(translated_.depth)) starts_outside(searching_.passed() ? 2 : per_round);
    if (out_of_budget() || !std::isfinite(translated_.depth)) return;
    share_ = steps_left();
    take(starts_.lane(0).descend(chart_, translated_.y, Method::pdg,
                                 {share_, optima_.best(), searching_}));
  }

  void first_translations() {
    push_device_pose(Method::pdt);
    if (!sketched()) return near_starts(Method::pdt);
    SketchSearch sketches(chart_, sketch_goal(Method::pdt), starts_.sketched(), threads_);
    sketches.go_on(sketches_of_translations, sketches_of_translations, 0);
    from_ends(sketches, Method::pdt, settled() ? 1 : 2);
  }

  /// By translation alone to the end: what a search for it gives, and on from there by all six. So
  /// the depth is never more than that by translation; and on large meshes it finds what no other
  /// start does (1.5 % of the depth on one of the six poses of camel in armadillo).
  void finish_translation() {
    StaticOptions options = options_;
    options.method = Method::pdt;
    const Separation found = Search(pair_, chart_.device(), options, {}).run();
    iterations_ += found.iterations;
    limited_ += found.limited;
    if (found.status != Status::penetrating) return;
    translated_.y = chart_.coordinates(found.separated);
    translated_.y.head<3>().setZero();
    translated_.depth = found.depth;
    finished_ = found;
    share_ = steps_left();
    note(starts_.lane(0).descend_exactly(chart_, translated_.y, Method::pdg, {share_, 0, {}}));
  }

  Random stream(std::uint64_t number) const {
    Random mixed(options_.seed + 0x51ed270b0f5a1d27ULL * number);
    return Random(mixed.next());
  }

  /// As long as it is open which end on the sketches is the best: more of them, and the bodies
  /// themselves from there.
  void more_sketches() {
    if (!sketched() || optima_.empty()) return;
    for (int made = 2 * sketches_.made(); made <= most_sketches && goes_on(); made *= 2) {
      sketches_.go_on(made, made, 0);
      from_ends(sketches_, options_.method, most_ends);
    }
  }
  /// What is left open then, from random poses; without sketches that is all there is.
  void random_rounds() {
    const bool few = sketched() && options_.by_evidence;
    const int most = few ? std::min(most_after_sketches, options_.starts) : options_.starts;
    for (int start = 0; start < most && goes_on(); start += int{per_round}) random_starts(start);
  }
  bool goes_on() { return !out_of_budget() && !settled(); }

  void random_starts(int first) {
    const std::vector<Vec6> ends = optima_.nearest(6);
    const std::size_t turn = static_cast<std::size_t>(first) / per_round;
    round([&](std::size_t k, std::size_t lane) {
      Random random = stream(static_cast<std::uint64_t>(first) + k);
      return starts_.random(turn, k, ends, random, aim(options_.method), lane);
    });
  }

  /// The best few to the last digit; the best of all that stand the exact test.
  Separation finish() {
    for (const Vec6& y : optima_.nearest(3)) {
      if (y.norm() > worth_refining * optima_.best() || (late() && verified_.best())) break;
      add_unless_cut(refined(options_.method, y, steps_left()));
    }
    std::optional<double> pdt;
    if (rotates() && (finished_ || !deadline_.passed() || !verified_.best()))
      pdt = add_translation();
    if (!verified_.best()) return failed(chart_.device(), "no separated pose stood the exact test");
    Separation out = *verified_.best();
    out.iterations = iterations_;
    out.limited = limited_ + starts_.limited();
    out.pdt = rotates() ? pdt : out.depth;
    return out;
  }

  /// What counted steps cut short may end a little above what fewer of them do.
  void add_unless_cut(const Separation& answer) {
    if (steps_left() > 0 || !verified_.best()) verified_.add(answer);
  }

  Separation refined(Method method, const Vec6& from, int steps) {
    Separation out =
        verified_.refined(method, from, starts_.lane(0).leaps(method), steps, deadline_);
    iterations_ += out.iterations;
    return out;
  }

  /// The translational depth to the last digit. Where it competes with all six degrees, they go on
  /// from there: what holds the probe against a turn as well makes it an answer of theirs.
  std::optional<double> add_translation() {
    if (!std::isfinite(translated_.depth)) return std::nullopt;
    const Separation out =
        finished_ ? *finished_ : refined(Method::pdt, translated_.y, steps_left());
    if (!verified_.is_free(out)) return std::nullopt;
    const auto& best = verified_.best();
    const bool competes = !best || out.depth < 1.001 * best->depth;
    if (competes && !late())
      add_unless_cut(refined(Method::pdg, chart_.coordinates(out.separated), steps_left()));
    if (!best || out.depth < (1 - 1e-12) * best->depth) verified_.add(out);
    return std::max(out.depth, best->depth);  // the same, but for rounding, where no turn helps
  }

  const Pair& pair_;
  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  Deadline deadline_, searching_, sketching_;
  Starts starts_;
  Verified verified_;
  ThreadPair threads_;
  SketchSearch sketches_;
  LocalOptima optima_;
  LocalOptimum translated_;
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
  const double kept = options.want_lower_bound ? std::clamp(options.share_for_bound, 0.0, 1.0) : 0;
  Separation out = Search(pair, device, options, deadline.part(1 - kept)).run();
  if (options.want_lower_bound && out.status == Status::penetrating)
    out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), device, deadline);
  return out;
}

}  // namespace sonde
