// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/compare.hpp"
#include "tests/bench/stage.hpp"

namespace sonde::bench {

/// One library with a query to answer at the poses of one kind.
struct Contender {
  std::string library;
  std::function<Answer(std::size_t pose)> ask;  ///< what is timed
  double touch_doubtful_within = 0;             ///< see Peer
  /// What is asked before the timing, where that is more than `ask` (empty: it is not).
  std::function<Answer(std::size_t pose)> examine = {};
  bool timed = true;  ///< false: there for its answers alone
  /// Several threads work at it: the wall clock times it, not the processor time of one.
  bool threads = false;
};

/// Judges the answer of one contender (the first one, Sonde, too).
using Judge =
    std::function<Verdict(const Stage& stage, Place place, std::size_t pose, const Answer& ours,
                          const Contender& contender, const Answer& theirs)>;

/// A kind of query. To add one, add it to the list that queries() returns.
struct Query {
  std::string name;
  std::vector<Place> places;
  std::vector<std::string> others;  ///< whom it is timed beside, where installed
  /// Sonde first.
  std::function<std::vector<Contender>(const Stage& stage, Place place)> contenders;
  std::string amount_name;  ///< of Answer::amount
  Judge judge = {};         ///< empty: touch and distance are compared
};

std::vector<Query> queries();

/// The judge of a query that has none of its own.
Verdict judge_answers(const Stage& stage, Place place, std::size_t pose, const Answer& ours,
                      const Contender& contender, const Answer& theirs);

}  // namespace sonde::bench
