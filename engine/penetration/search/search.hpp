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

/// One global search, stage by stage: descents on the sketches, on the bodies from where those end,
/// from overlaps that are pushed apart and from random poses, by translation alone on the way, and
/// the best of them to the last digit. It is used once: run(), and again() where more has become
/// known since.
class Search {
 public:
  /// Starts that are descended side by side; what they find counts from the next round on.
  static constexpr std::size_t per_round = Starts::per_round;

  Search(const Pair& pair, const Pose& device, const StaticOptions& options,
         const SearchTuning& tuning, const Deadline& deadline, const Progress& progress = {});

  /// @throws Cancelled where the progress says so, which is told the share of the starts that it
  /// may make at most.
  Separation run();

  /// A place that is known from another search, free as far as is known there: a start of this
  /// one's own that comes to it too confirms it.
  void know(const Pose& separated);
  /// What it ends with, with what has become known since.
  Separation again() { return finish(); }

  int sketches_made() const { return other_sketches_ + sketches_.made(); }

 private:
  using Round = std::array<LocalOptimum, per_round>;
  bool rotates() const { return options_.method == Method::pdg; }
  bool sketched() const { return !starts_.sketched().empty(); }

  SketchGoal sketch_goal(Method method) const;
  Aim aim(Method method) const;

  /// Runs start(k, lane) for each of a round, and adds what they found. Where steps are
  /// counted, two at a time: what is done with the first so many steps does not depend on how many
  /// there are, so that more of them only add to what is found. A start that there are not enough
  /// for is not made; but the first of all goes as far as they do.
  template <class Start>
  void round(const Start& start, std::size_t most = per_round) {
    const std::size_t count_at_once = budget_.counts_steps() ? 2 : most;
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

  /// The best place let come into contact: fit to be returned, should the steps end.
  void settle();

  void first_sketches();
  /// From the nearest of the sketches' ends, which cost no steps: so near the best depth that few
  /// steps suffice, where a translation may take them all and end far above.
  void first_sketched_start();

  /// What comes before all others, by what the time or the steps are for.
  void begin();

  /// From the sketches' ends and the device pose itself.
  void first_starts();

  void push_device_pose(Method method);

  void near_starts(Method method);

  /// From near the device pose: ways out that are too narrow for sketches and random poses.
  void pushed_starts();

  /// On from so many ends on the sketches that have not been tried yet, two at a time, as long as
  /// they may be better than what has been found.
  void from_ends(SketchSearch& sketches, Method method, std::size_t most);

  /// Time was over before the bodies were free anywhere, though sketches say where they nearly are.
  void beyond_ends();

  /// From outside to contact. Only along the first lines where time is over.
  void starts_outside(std::size_t most);

  /// Some way out by translation alone, at small cost.
  void first_translation();

  /// By translation alone, a little; and on from there by all six.
  void translation_on_the_way();
  void turn_from_translation();

  void first_translations();

  /// By translation alone to the end: what a search for it gives, and on from there by all six. So
  /// the depth is never more than that by translation; and on large meshes it finds what no other
  /// start does (1.5 % of the depth on one of the six poses of camel in armadillo).
  void finish_translation();

  Random stream(std::uint64_t number) const;

  /// As long as it is open which end on the sketches is the best: more of them, and the bodies
  /// themselves from there.
  void more_sketches();
  /// What is left open then, from random poses; without sketches that is all there is.
  void random_rounds();
  /// Where the way out is long beside the overlap, next to no pose about the best optima is free:
  /// random free poses do not come near them, and how many starts agree says nothing. Overlaps that
  /// are pushed apart do, every other one with axes of both bodies on one line, as parts that are
  /// made to fit have; as many again as it took to find the best, since there may be another.
  void pushed_rounds();
  bool goes_on() const { return !is_over() && !evidence_.settles(); }
  /// No more starts. Asked on the calling thread alone, before each of them.
  bool is_over() const {
    report(progress_, std::min(1.0, made_ / std::max(1.0, static_cast<double>(options_.starts))));
    return budget_.search_is_over();
  }

  void random_starts(int first);

  /// The best few to the last digit; the best of all that stand the exact test.
  Separation finish();

  /// What counted steps cut short may end a little above what fewer of them do.
  void add_unless_cut(const Separation& answer);

  Separation refined(Method method, const Vec6& from, int steps);

  /// The translational depth to the last digit. Where it competes with all six degrees, they go on
  /// from there: what holds the probe against a turn as well makes it an answer of theirs.
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
  int made_ = 0;                                              // starts
  int limited_ = 0;
  int other_sketches_ = 0;  // starts on sketches, by searches for translations
};

/// A PD_t search without a limit, and how many descents on sketches it made. A way out of the probe
/// is one of the fixed body, back: both are searched for, with starts of their own, and the shorter
/// one counts. So exchanged bodies mostly have the same PD_t.
struct Translated {
  Separation found;
  int sketches = 0;
};
Translated translated_both_ways(const Pair& pair, const Pose& device, const StaticOptions& options,
                                const SearchTuning& tuning, const Progress& progress);

}  // namespace sonde
