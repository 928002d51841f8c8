// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "app/result_table.hpp"
#include "engine/calibration/calibration.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde::app {

/// The one knob on the command line: a time or an accuracy, and the calibration that relates them.
struct AccuracyOptions {
  std::optional<std::string> time, accuracy;  ///< as given
  std::optional<std::string> sure;            ///< the share of poses that are to reach it, as given
  std::string calibration;                    ///< a file; empty: the program's own
  bool claim = false;                         ///< results state their claim even without the knob

  bool turned() const { return time || accuracy; }
};
void add_flags(CLI::App& parser, AccuracyOptions& options);

/// The effect of the knob, for one pair of bodies.
class Accuracy {
 public:
  /// Reads the flags and the file, before any work. Throws UsageError where flags contradict each
  /// other or a value is none, InputError where the file cannot be used.
  Accuracy(const AccuracyOptions& options, const SolverOptions& solver);

  /// The solver's options with the knob's budget of time for this pair. With the knob, a bound is
  /// computed only if requested.
  SolverOptions applied(const SolverOptions& solver, const Pair& pair);
  /// After `applied`: says on stderr where no time that was measured reaches the wanted accuracy.
  void note_unreached() const;

  /// The columns of the results, and, where wanted, the two with the claims.
  std::vector<Column> with_claims(std::span<const Column> columns) const;
  void append_claim(Row& row, const Separation& answer) const;
  /// µs for each answer, as `applied` found it; 0: without a limit.
  double time_us() const { return time_us_; }

 private:
  AccuracyOptions options_;
  Knob knob_;
  double sure_ = usually_sure;
  Calibration calibration_;
  std::vector<AccuracyCurve> curve_;  // one, once it is known of which pair
  double time_us_ = 0;
};

}  // namespace sonde::app
