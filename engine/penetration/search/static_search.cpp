// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/static_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/base/phase_timer.hpp"
#include "engine/base/thread_pair.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/evidence.hpp"
#include "engine/penetration/search/search_budget.hpp"
#include "engine/penetration/search/search_tuning.hpp"
#include "engine/penetration/search/sketch_search.hpp"
#include "engine/penetration/search/starts.hpp"
#include "engine/penetration/search/touching.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/penetration/search/verified.hpp"

namespace sonde {
namespace {

/// Starts that are descended side by side; what they find counts from the next round on.
constexpr std::size_t per_round = Starts::per_round;

class Search {
 public:
  Search(const Pair& pair, const Pose& device, const StaticOptions& options,
         const SearchTuning& tuning, const Deadline& deadline)
      : pair_(pair),
        probe_(pair.probe()),
        fixed_(pair.fixed()),
        chart_(probe_.mass, device),
        options_(options),
        tuned_(tuning),
        budget_(options.budget, deadline, tuning),
        starts_(pair, chart_, budget_.searching(), tuning),
        verified_(pair, chart_, options.time_phases ? &times_ : nullptr),
        threads_(options.two_threads && !budget_.is_short()),
        sketches_(chart_, sketch_goal(options.method), starts_.sketched(), threads_, tuning),
        optima_(tuning.same),
        evidence_(chart_, {options.agreement, options.by_evidence, tuning}, optima_, sketches_,
                  starts_.sketched()) {
    if (options.time_phases) starts_.time_phases();
  }

  Separation run() {
    begin();
    first_starts();
    if (optima_.empty()) beyond_ends();
    more_sketches();
    if (sketched() && !budget_.search_is_over() && evidence_.may_be_narrow()) pushed_starts();
    if (!rotates() && !evidence_.settles()) starts_outside(per_round);
    if (rotates() && (optima_.empty() || budget_.counts_steps())) translation_on_the_way();
    if (optima_.empty()) return failed(chart_.device(), "no free pose was found");
    if (rotates() && evidence_.may_be_deep())
      pushed_rounds();
    else
      random_rounds();
    if (rotates() && !std::isfinite(translated_.depth) && !budget_.search_is_over())
      translation_on_the_way();
    return finish();
  }

  /// About what the search took, in the units of work of the bound: rather less than more.
  std::int64_t work_of_bound() const {
    return std::int64_t{tuned_.bound_for_a_sketch} * sketches_made() +
           std::int64_t{tuned_.bound_for_a_step} * budget_.steps_spent();
  }

 private:
  using Round = std::array<LocalOptimum, per_round>;
  bool rotates() const { return options_.method == Method::pdg; }
  int sketches_made() const { return other_sketches_ + sketches_.made(); }
  bool sketched() const { return !starts_.sketched().empty(); }

  SketchGoal sketch_goal(Method method) const {
    return {.method = method,
            .seed = options_.seed,
            .deadline = budget_.sketching(),
            .axes = fixed_.mass.R_MP};
  }
  Aim aim(Method method) const {
    const bool own = method == options_.method;
    return {.method = method,
            .beat = own ? optima_.best() : translated_.depth,
            .steps = share_,
            .known = own ? &optima_ : nullptr};
  }

  /// Runs start(k, lane) for each of a round, and adds what they found. Where steps are
  /// counted, two at a time: what is done with the first so many steps does not depend on how many
  /// there are, so that more of them only add to what is found. A start that there are not enough
  /// for is not made; but the first of all goes as far as they do.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    const std::size_t count_at_once = budget_.counts_steps() ? 2 : most;
    for (std::size_t first = 0; first < most; first += count_at_once) {
      if (budget_.search_is_over() && !optima_.empty()) return;
      Round found;
      const std::size_t count = std::min(count_at_once, most - first);
      share_ = std::clamp(budget_.steps_left(), 1, most_steps_);
      threads_.each(count,
                    [&](std::size_t k, std::size_t lane) { found[k] = start(first + k, lane); });
      for (std::size_t k = 0; k < count; ++k) accept(found[k]);
    }
  }

  void accept(const LocalOptimum& place) {
    if (place.iterations >= budget_.steps_left() && !optima_.empty()) {
      budget_.spend_all();
      return;
    }
    add(place);
    if (budget_.counts_steps() && optima_.best() < settled_) settle();
  }
  void add(const LocalOptimum& place) {
    budget_.spend(place.iterations);
    optima_.add(place);
    if (place.y.head<3>().isZero(0) && place.depth < translated_.depth) translated_ = place;
  }

  /// The best place let come into contact: fit to be returned, should the steps end.
  void settle() {
    settled_ = optima_.best();
    verified_.add(refined(options_.method, optima_.nearest(1)[0], 0));
  }

  void first_sketches() {
    sketches_.make_starts(tuned_.first_sketches, tuned_.most_first_sketches, tuned_.clear);
  }
  /// From the nearest of the sketches' ends, which cost no steps: so near the best depth that few
  /// steps suffice, where a translation may take them all and end far above.
  void first_sketched_start() {
    if (!sketched()) return;
    first_sketches();
    from_ends(sketches_, options_.method, 1);
  }

  /// What comes before all others, by what the time or the steps are for.
  void begin() {
    if (rotates() && !budget_.is_limited()) {
      finish_translation();
    } else if (rotates() && budget_.counts_steps()) {
      first_sketched_start();
      first_translation();
    } else if (rotates() && budget_.is_timed() && !sketched()) {
      // What the first push ends in may be far out, and more time for it is then worse than the
      // translation that less time had to do with.
      first_translation();
      turn_from_translation();
    } else if (budget_.is_timed() && !sketched()) {
      // A translation: in 1 ms, 206 to 208 poses of depths.csv are within 5 % of the reference, and
      // 199 to 202 where the device pose is pushed apart first.
      starts_outside(1);
    }
  }

  /// From the sketches' ends and the device pose itself.
  void first_starts() {
    if (sketched()) {
      first_sketches();
      from_ends(sketches_, options_.method,
                rotates() && sketches_.is_clear(tuned_.clear) ? tuned_.ends_where_clear
                                                              : tuned_.first_ends);
    }
    push_device_pose(options_.method);
    if (!evidence_.sketches_see()) near_starts(options_.method);
  }

  void push_device_pose(Method method) {
    round([&](std::size_t,
              std::size_t lane) { return starts_.pushed(Vec6::Zero(), aim(method), lane); },
          1);
  }

  void near_starts(Method method) {
    const int tries =
        budget_.refining().microseconds > 0 ? tuned_.near_tries_timed : tuned_.near_tries;
    for (std::size_t lane = 0; lane < 2; ++lane)
      starts_.lane(lane).near = tuned_.smallest_ball * probe_.mass.radius;
    round([&](std::size_t k, std::size_t lane) {
      return starts_.near(stream(2000 + k), tries, aim(method), lane);
    });
  }

  /// From near the device pose: ways out that are too narrow for sketches and random poses.
  void pushed_starts() {
    round(
        [&](std::size_t k, std::size_t lane) {
          Random random = stream(2500 + k);
          const double radius = random.uniform(tuned_.nearest_push, tuned_.farthest_push) *
                                std::min(optima_.best(), probe_.mass.radius);
          return starts_.pushed_within(radius, random, aim(options_.method), lane);
        },
        rotates() ? tuned_.pushes : tuned_.pushes / 2);
  }

  /// On from so many ends on the sketches that have not been tried yet, two at a time, as long as
  /// they may be better than what has been found.
  void from_ends(SketchSearch& sketches, Method method, std::size_t most) {
    std::vector<SketchEnd*> next;
    for (SketchEnd& end : sketches.ends())
      if (end.came_to < 0) next.push_back(&end);
    next.resize(std::min(most, next.size()));
    const std::size_t count_at_once = budget_.is_short() ? 1 : 2;  // the nearest has all there is
    for (std::size_t first = 0; first < next.size() && !budget_.search_is_over();
         first += count_at_once) {
      const Aim at = aim(method);
      if (next[first]->depth - evidence_.sketch_error() > (1 + tuned_.same) * at.beat) break;
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

  /// Time was over before the bodies were free anywhere, though sketches say where they nearly are.
  void beyond_ends() {
    if (!budget_.searching().passed()) return;
    for (const SketchEnd& end : sketches_.ends()) {
      add(starts_.beyond(end, aim(options_.method), 0));
      if (!optima_.empty()) return;
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
    most_steps_ = tuned_.steps_of_first_translation;
    push_device_pose(Method::pdt);
    if (!std::isfinite(translated_.depth)) starts_outside(1);
    most_steps_ = std::numeric_limits<int>::max();
  }

  /// By translation alone, a little; and on from there by all six.
  void translation_on_the_way() {
    if (!budget_.searching().passed()) first_translations();
    if (!std::isfinite(translated_.depth))
      starts_outside(budget_.searching().passed() ? 2 : per_round);
    turn_from_translation();
  }
  void turn_from_translation() {
    if (budget_.search_is_over() || !std::isfinite(translated_.depth)) return;
    share_ = budget_.steps_left();
    accept(starts_.lane(0).descend(chart_, translated_.y, Method::pdg,
                                   {share_, optima_.best(), budget_.searching()}));
  }

  void first_translations() {
    push_device_pose(Method::pdt);
    if (!sketched()) return near_starts(Method::pdt);
    SketchSearch sketches(chart_, sketch_goal(Method::pdt), starts_.sketched(), threads_, tuned_);
    sketches.make_starts(tuned_.sketches_of_translations, tuned_.sketches_of_translations, 0);
    other_sketches_ += sketches.made();
    from_ends(sketches, Method::pdt, evidence_.settles() ? 1 : 2);
  }

  /// By translation alone to the end: what a search for it gives, and on from there by all six. So
  /// the depth is never more than that by translation; and on large meshes it finds what no other
  /// start does (1.5 % of the depth on one of the six poses of camel in armadillo).
  void finish_translation() {
    StaticOptions options = options_;
    options.method = Method::pdt;
    Search search(pair_, chart_.device(), options, tuned_, {});
    const Separation found = search.run();
    budget_.spend(found.iterations);
    other_sketches_ += search.sketches_made();
    limited_ += found.limited;
    times_ += found.phases;
    if (found.status != Status::penetrating) return;
    translated_.y = chart_.coordinates(found.separated);
    translated_.y.head<3>().setZero();
    translated_.depth = found.depth;
    finished_ = found;
    share_ = budget_.steps_left();
    add(starts_.lane(0).descend_exactly(chart_, translated_.y, Method::pdg, {share_, 0, {}}));
  }

  Random stream(std::uint64_t number) const {
    Random mixed(options_.seed + 0x51ed270b0f5a1d27ULL * number);
    return Random(mixed.next());
  }

  /// As long as it is open which end on the sketches is the best: more of them, and the bodies
  /// themselves from there.
  void more_sketches() {
    if (!sketched() || optima_.empty()) return;
    for (int made = std::max(1, 2 * sketches_.made()); made <= tuned_.most_sketches && goes_on();
         made *= 2) {
      sketches_.make_starts(made, made, 0);
      from_ends(sketches_, options_.method, tuned_.most_ends);
    }
  }
  /// What is left open then, from random poses; without sketches that is all there is.
  void random_rounds() {
    const bool few = sketched() && options_.by_evidence;
    const int most = few ? std::min(tuned_.most_after_sketches, options_.starts) : options_.starts;
    int start = 0;
    for (; start < most && goes_on(); start += int{per_round}) random_starts(start);
    if (start >= most && goes_on()) ++limited_;
  }
  /// Where the way out is long beside the overlap, next to no pose about the best optima is free:
  /// random free poses do not come near them, and how many starts agree says nothing. Overlaps that
  /// are pushed apart do, every other one with axes of both bodies on one line, as parts that are
  /// made to fit have; as many again as it took to find the best, since there may be another.
  void pushed_rounds() {
    int most = std::min(tuned_.most_after_sketches, options_.starts), start = 0;
    for (; start < most && !budget_.search_is_over(); start += int{per_round}) {
      const double before = optima_.best();
      round([&](std::size_t k, std::size_t lane) {
        Random random = stream(3000 + static_cast<std::uint64_t>(start) + k);
        const double radius =
            random.uniform(tuned_.nearest_overlap, tuned_.farthest_overlap) * optima_.best();
        if (k % 2 == 0)
          if (const auto y = starts_.along_axes(random, tuned_.farthest_overlap * optima_.best()))
            return starts_.pushed(*y, aim(options_.method), lane);
        return starts_.pushed_within(radius, random, aim(options_.method), lane);
      });
      if (optima_.best() < (1 - tuned_.same) * before)
        most = std::max(most, std::min(2 * (start + int{per_round}), options_.starts));
    }
    if (start >= most) ++limited_;
  }
  bool goes_on() { return !budget_.search_is_over() && !evidence_.settles(); }

  void random_starts(int first) {
    const std::vector<Vec6> ends = optima_.nearest(tuned_.ends_for_starts);
    const std::size_t turn = static_cast<std::size_t>(first) / per_round;
    round([&](std::size_t k, std::size_t lane) {
      Random random = stream(static_cast<std::uint64_t>(first) + k);
      return starts_.random(turn, k, ends, random, aim(options_.method), lane);
    });
  }

  /// The best few to the last digit; the best of all that stand the exact test.
  Separation finish() {
    for (const Vec6& y : optima_.nearest(tuned_.refined)) {
      if (y.norm() > tuned_.worth_refining * optima_.best() ||
          (budget_.is_over() && verified_.best()))
        break;
      add_unless_cut(refined(options_.method, y, budget_.steps_left()));
    }
    std::optional<double> pdt;
    if (rotates() && (finished_ || !budget_.refining().passed() || !verified_.best()))
      pdt = add_translation();
    if (!verified_.best()) return failed(chart_.device(), "no separated pose stood the exact test");
    Separation out = *verified_.best();
    out.iterations = budget_.steps_spent();
    out.limited = limited_ + starts_.limited();
    out.phases = starts_.phases();
    out.phases += times_;
    out.pdt = rotates() ? pdt : out.depth;
    return out;
  }

  /// What counted steps cut short may end a little above what fewer of them do.
  void add_unless_cut(const Separation& answer) {
    if (budget_.steps_left() > 0 || !verified_.best()) verified_.add(answer);
  }

  Separation refined(Method method, const Vec6& from, int steps) {
    Separation out =
        verified_.refined(method, from, starts_.lane(0).leaps(method), steps, budget_.refining());
    budget_.spend(out.iterations);
    return out;
  }

  /// The translational depth to the last digit. Where it competes with all six degrees, they go on
  /// from there: what holds the probe against a turn as well makes it an answer of theirs.
  std::optional<double> add_translation() {
    if (!std::isfinite(translated_.depth)) return std::nullopt;
    const Separation out =
        finished_ ? *finished_ : refined(Method::pdt, translated_.y, budget_.steps_left());
    if (!verified_.is_free(out)) return std::nullopt;
    const auto& best = verified_.best();
    const bool competes = !best || out.depth < tuned_.translation_competes * best->depth;
    if (competes && !budget_.is_over())
      add_unless_cut(refined(Method::pdg, chart_.coordinates(out.separated), budget_.steps_left()));
    if (!best || out.depth < (1 - 1e-12) * best->depth) verified_.add(out);
    return std::max(out.depth, best->depth);  // the same, but for rounding, where no turn helps
  }

  const Pair& pair_;
  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  const SearchTuning& tuned_;
  SearchBudget budget_;
  Starts starts_;
  PhaseTimes times_;  // of what is done outside of starts
  Verified verified_;
  ThreadPair threads_;
  SketchSearch sketches_;
  LocalOptima optima_;
  Evidence evidence_;
  LocalOptimum translated_;
  std::optional<Separation> finished_;  // the translation, from a search of its own
  double settled_ = std::numeric_limits<double>::infinity();  // m: what has come into contact
  int most_steps_ = std::numeric_limits<int>::max();          // of a start
  int share_ = 0;                                             // steps that a start may take
  int limited_ = 0;
  int other_sketches_ = 0;  // starts on sketches, by searches for translations
};

}  // namespace

Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                           const SearchTuning& tuning) {
  const Deadline deadline{options.budget.microseconds, now_us()};
  const Pose device = is_finite(X_FM) ? Pose{X_FM.q.normalized(), X_FM.p} : X_FM;
  if (const auto settled = trivial_separation(pair.probe(), pair.fixed(), device)) return *settled;
  if (auto touching = touching_separation(pair.probe(), pair.fixed(), device, options.method)) {
    if (options.want_lower_bound && (pair.probe().solid || pair.fixed().solid))
      touching->lower_bound = 0;
    return *touching;
  }
  const double kept = options.want_lower_bound ? std::clamp(options.share_for_bound, 0.0, 1.0) : 0;
  Search search(pair, device, options, tuning, deadline.part(1 - kept));
  Separation out = search.run();
  const bool in_time = options.whole_bound || options.share_for_bound > 0 ||
                       !deadline.passed(tuning.least_us_for_bound);
  if (options.want_lower_bound && in_time && out.status == Status::penetrating) {
    const PhaseTimer timer(options.time_phases ? &out.phases : nullptr, Phase::bound);
    BoundOptions bound;
    if (!options.whole_bound)
      bound.work = static_cast<int>(std::min<std::int64_t>(bound.work, search.work_of_bound()));
    out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), device, deadline, bound);
  }
  return out;
}

Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options) {
  return separate_static(pair, X_FM, options, search_tuning);
}

}  // namespace sonde
