// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "engine/base/progress.hpp"
#include "engine/base/thread_pair.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/geometry/random.hpp"
#include "engine/penetration/search/evidence.hpp"
#include "engine/penetration/search/local_optima.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/search_budget.hpp"
#include "engine/penetration/search/search_tuning.hpp"
#include "engine/penetration/search/sketch_search.hpp"
#include "engine/penetration/search/starts.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/penetration/search/verified.hpp"

namespace sonde {

/// One global search in stages: descents on the sketches; descents on the bodies from the ends of
/// these, from overlaps that are pushed apart and from random poses; translation only as an
/// intermediate result; and the refinement of the best. An object serves for one search: call run()
/// once, and again() if know() has been called since.
class Search {
 public:
  /// Starts that descend in parallel; their results count from the next round on.
  static constexpr std::size_t per_round = Starts::per_round;

  Search(const Pair& pair, const Pose& device, const StaticOptions& options,
         const SearchTuning& tuning, const Deadline& deadline, const Progress& progress = {});

  /// @throws Cancelled if `progress` returns false. It is called with the share of the maximum
  /// number of starts.
  Separation run();

  /// Adds a free pose that another search found, as a known local optimum. A start of this search
  /// that also reaches it confirms it.
  void know(const Pose& separated);
  /// The result of run(), including the poses added by know() since.
  Separation again() { return finish(); }

  /// Whether the result of run() is probably the best: its evidence is conclusive, and it is not so
  /// long that agreement of starts proves nothing.
  bool is_settled() const { return evidence_.is_conclusive() && !evidence_.may_be_deep(); }

  int sketches_made() const { return other_sketches_ + sketches_.made(); }

 private:
  using Round = std::array<LocalOptimum, per_round>;
  bool rotates() const { return options_.method == Method::pdg; }
  bool has_sketches() const { return !starts_.sketch_descents().empty(); }

  SketchGoal sketch_goal(Method method) const;
  Aim aim(Method method) const;

  /// Runs start(k, lane) for each start of a round, and adds the results. If steps are counted, two
  /// starts run at a time. The work done with the first n steps does not depend on the total number
  /// of steps, so more steps only add to the results. A start for which too few steps are left is
  /// discarded, except the first one, which goes as far as the steps allow.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    const std::size_t count_at_once = budget_.counts_steps() ? 2 : std::min(most, per_round);
    for (std::size_t first = 0; first < most; first += count_at_once) {
      if (is_over() && !optima_.empty()) return;
      Round found;
      const std::size_t count = std::min(count_at_once, most - first);
      share_ = std::clamp(budget_.steps_left(), 1, most_steps_);
      threads_.each(count,
                    [&](std::size_t k, std::size_t lane) { found[k] = start(first + k, lane); });
      for (std::size_t k = 0; k < count; ++k) accept(found[k]);
    }
  }

  void accept(const LocalOptimum& place);
  void add(const LocalOptimum& place);

  /// Moves the best local optimum into contact, so that it can be returned if the steps run out.
  void bring_into_contact();

  void first_sketches();
  /// Starts from the nearest end on the sketches, which costs no steps. That end is so near the
  /// best depth that few steps suffice, whereas a descent by translation may use all of them and
  /// end far above.
  void first_start_on_sketches();

  /// The stages before all others, depending on the time or step budget.
  void begin();

  /// Starts from the ends on the sketches and from the device pose.
  void first_starts();

  /// One start from the overlap at y, which is pushed apart, or from y itself if it is free. y = 0
  /// is the device pose.
  void push_from(const Vec6& y, Method method);

  void near_starts(Method method);

  /// Starts from overlaps near the device pose: these find separating motions through gaps that are
  /// too narrow for sketches and random poses.
  void pushed_starts();

  /// Starts from the poses, of some random ones, in which the bodies would best fit into each
  /// other. All other starts miss a fit with little room, and then agree on a longer separating
  /// motion, however many they are.
  void fitted_starts();

  /// Starts from free images of the nearest ends under the symmetries of bits, plugs and gears: of
  /// many equivalent seats, random starts find some, but mostly not the nearest.
  void turned_ends();

  /// Starts from up to `most` untried ends on the sketches, two at a time, as long as they may be
  /// better than the best result.
  void from_ends(SketchSearch& sketches, Method method, std::size_t most);

  /// If the time ran out before any free pose of the bodies was found: tries poses beyond the ends
  /// on the sketches, where the bodies are nearly free.
  void beyond_ends();

  /// Starts from outside, along the first `most` lines of Starts::descend_from_outside, and moves
  /// to contact. If the time is over, callers ask for fewer lines.
  void starts_outside(std::size_t most);

  /// Finds some separating translation at small cost.
  void first_translation();

  /// Searches briefly by translation only, and descends from there with all six degrees of freedom.
  void translation_on_the_way();
  void turn_from_translation();

  void first_translations();

  /// Searches PD_t to its end, and descends from there with all six degrees of freedom. So the
  /// depth never exceeds PD_t. On large meshes this also finds optima that no other start reaches
  /// (on one of the six poses of camel in armadillo, nearer by 1.5 % of the depth).
  void finish_translation();

  Random stream(std::uint64_t number) const;

  /// As long as it is undecided which end on the sketches is the best: makes more starts on
  /// sketches, and descends with the bodies from their ends.
  void more_sketches();
  /// As long as the evidence is not conclusive: starts from random poses. Without sketches, these
  /// are the whole search.
  void random_rounds();
  /// For a separating motion that is long compared with the overlap. Then almost no pose near the
  /// best optima is free: random free poses do not come near these optima, and the number of
  /// agreeing starts proves nothing. Overlaps that are pushed apart do come near. In every other
  /// one, a principal axis of each body lies on one common line, as in parts that are made to fit.
  /// After each improvement of the best depth, as many starts as before follow, since there may be
  /// a still better optimum.
  void pushed_rounds();
  bool goes_on() const { return !is_over() && !evidence_.is_conclusive(); }
  /// No more starts. Called before each start, on the calling thread only.
  bool is_over() const {
    report(progress_, std::min(1.0, made_ / std::max(1.0, static_cast<double>(options_.starts))));
    return budget_.search_is_over();
  }

  void random_starts(int first);

  /// Refines the best few local optima, and returns the best that passes the exact test.
  Separation finish();

  /// Adds the answer unless the steps ran out: a refinement cut short may end slightly above that
  /// of a smaller budget.
  void add_unless_cut(const Separation& answer);

  Separation refined(Method method, const Vec6& from, int steps);

  /// The refined translational depth. If it competes with the depth of all six degrees of freedom,
  /// a refinement with these starts from it: if its contacts also hold the probe against turning,
  /// it is an optimum of that problem too.
  std::optional<double> add_translation();

  const Pair& pair_;
  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  const SearchTuning& tuned_;
  SearchBudget budget_;
  const Progress& progress_;
  Starts starts_;
  PhaseTimes times_;  // of the work outside of starts
  Verified verified_;
  ThreadPair threads_;
  SketchSearch sketches_;
  LocalOptima optima_;
  Evidence evidence_;
  LocalOptimum translated_;
  std::optional<Separation> finished_;  // PD_t result from a search of its own
  double in_contact_ = std::numeric_limits<double>::infinity();  // m: best depth moved into contact
  int most_steps_ = std::numeric_limits<int>::max();             // limit per start
  int share_ = 0;                                                // steps that a start may take
  int made_ = 0;                                                 // starts made
  int limited_ = 0;
  int other_sketches_ = 0;  // starts on sketches in searches for translations
};

}  // namespace sonde
