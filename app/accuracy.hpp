// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/options.hpp"
#include "app/result_table.hpp"
#include "engine/calibration/calibration.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde::app {

/// The one knob on the command line: a time or an accuracy, and what ties them together.
struct AccuracyOptions {
  std::string time, accuracy;  ///< as given; empty: not given
  std::string calibration;     ///< a file; empty: what ships with the program
  bool claim = false;          ///< results say how near they claim to be, also without the knob

  bool turned() const { return !time.empty() || !accuracy.empty(); }
};
void add_flags(CLI::App& parser, AccuracyOptions& options);

/// What became of the knob, for one pair of bodies.
class Accuracy {
 public:
  /// Reads the flags and the file, before any work. Throws UsageError where flags contradict each
  /// other, InputError where a value or the file is no good.
  Accuracy(const AccuracyOptions& options, const SolverOptions& solver);

  /// The solver's options with the budget of time that the knob comes to on this pair. With it, a
  /// bound is made only where it was asked for.
  SolverOptions applied(const SolverOptions& solver, const Pair& pair);

  /// The columns of the results, and the two that say what each claims, where it is to.
  std::vector<Column> with_claims(std::span<const Column> columns) const;
  void append_claim(Row& row, const Separation& answer) const;

 private:
  AccuracyOptions options_;
  Knob knob_;
  Calibration calibration_;
  std::vector<AccuracyCurve> curve_;  // one, once it is known of which pair
  double time_us_ = 0;                // of each answer; 0: without a limit
};

}  // namespace sonde::app
