// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/bench/queries.hpp"
#include "tests/bench/result.hpp"
#include "tests/bench/stage.hpp"

namespace sonde::bench {

struct SessionOptions {
  std::uint64_t seed = 1;
  double budget_s = 1;     ///< time for the repetitions of one benchmark
  double patience_s = 10;  ///< a library that needs longer for its first pass gets fewer poses
};

/// One library with one query on one pair at the poses of one kind.
struct Job {
  PairSpec pair;
  std::size_t query = 0;
  Place place = Place::none;
  std::string library;
};

/// Runs the jobs: loads a pair when its first job comes, compares all answers of a query before its
/// first timing, and collects what was measured.
class Session {
 public:
  explicit Session(SessionOptions options) : options_(options), queries_(queries()) {}

  /// The jobs of a pair, in an order that loads nothing twice.
  std::vector<Job> jobs(const PairSpec& pair) const;
  std::string name_of(const Job& job) const;

  /// Compares where that has not been done, then times. Null where answers are wrong, where the
  /// library is not a contender, or where something failed, which failures() then tells.
  const LibraryResult* run(const Job& job);

  const std::vector<Result>& results() const { return results_; }
  /// A wrong answer names the pair, the pose and both answers.
  const std::vector<std::string>& failures() const { return failures_; }

 private:
  /// What is kept of a query while its libraries are timed.
  struct Trial {
    std::string name;
    Place place = Place::none;
    std::size_t result = 0;
    std::size_t wrong = 0;  ///< answers
    std::vector<Contender> contenders;
    std::vector<std::vector<Answer>> answers;  ///< of each contender
    std::vector<double> pass_s;                ///< how long they took
  };
  void prepare(const Job& job);
  void begin_trial(const Job& job);
  void examine(const Contender& contender, std::size_t poses);
  void compare(const Query& query, std::size_t contender);
  void fail(const Contender& contender, std::size_t pose, const Answer& ours, const Answer& theirs);

  SessionOptions options_;
  std::vector<Query> queries_;
  std::unique_ptr<Stage> stage_;
  Trial trial_;
  std::vector<Result> results_;
  std::vector<std::string> failures_;
};

}  // namespace sonde::bench
