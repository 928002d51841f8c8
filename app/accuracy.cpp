// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/accuracy.hpp"

#include <iostream>

#include "engine/calibration/calibration_file.hpp"
#include "engine/proximity/sketch/sketch.hpp"
#include "engine/text/quantity.hpp"

namespace sonde::app {
namespace {

/// What a flag is given is usage, whatever else it may be in a file.
double value_of(const std::string& text, double (*read)(std::string_view, const std::string&),
                const char* flag) {
  try {
    return read(text, flag);
  } catch (const InputError& bad) {
    throw UsageError(bad.what());
  }
}

}  // namespace

void add_flags(CLI::App& parser, AccuracyOptions& options) {
  const char* group = "Time or accuracy";
  parser
      .add_option("--time", options.time,
                  "time for each pose, 1ms, 800us or 0.02s: the accuracy follows")
      ->group(group);
  parser
      .add_option("--accuracy", options.accuracy,
                  "accuracy that nine in ten poses should reach, 1% or 0.01: the time follows")
      ->group(group);
  parser
      .add_option("--sure", options.sure,
                  "share of the poses that keep to their claim, 50%, 90% (as without it), 99% or "
                  "0.99: where the way out is long, more starts are searched from")
      ->group(group);
  parser
      .add_option("--calibration", options.calibration,
                  "file that relates the two (sonde calibrate); without it the program's own")
      ->group(group);
  parser
      .add_flag("--claim", options.claim,
                "state the accuracy that each result claims; --time and --accuracy imply it")
      ->group(group);
}

Accuracy::Accuracy(const AccuracyOptions& options, const SolverOptions& solver)
    : options_(options) {
  if (options.time && options.accuracy)
    throw UsageError("--time and --accuracy: the one follows from the other");
  if (options.turned() && (solver.budget.microseconds > 0 || solver.budget.steps > 0))
    throw UsageError("--time and --accuracy are budgets: give no other");
  if (options.time) knob_.time = value_of(*options.time, time_in, "--time");
  if (options.accuracy) knob_.accuracy = value_of(*options.accuracy, share_in, "--accuracy");
  if (options.sure) sure_ = value_of(*options.sure, share_in, "--sure");
  options_.claim |= options.turned() || options.sure;
  if (!options.calibration.empty())  // a bad file is told of whether it is needed or not
    calibration_ = read_calibration(options.calibration);
  else if (options_.claim)
    calibration_ = default_calibration();
}

SolverOptions Accuracy::applied(const SolverOptions& solver, const Pair& pair) {
  SolverOptions out = solver;
  out.sure = sure_;
  if (!options_.claim) return out;
  // What was measured is measured in time: of a budget of steps it says nothing.
  const Calibration& known = out.budget.steps > 0 ? Calibration{} : calibration_;
  curve_ = {AccuracyCurve(known, solver.coherent() ? Answers::tick : Answers::search,
                          solver.chosen_method(), bool(pair.sketches()), sure_)};
  if (options_.turned()) {
    out.budget.microseconds = budget_us(knob_, curve_[0]);
    out.bound = solver.bound.value_or(false);
  }
  time_us_ = out.budget.microseconds;
  return out;
}

void Accuracy::note_unreached() const {
  if (options_.accuracy && time_us_ == 0)
    std::cerr << "sonde: no measured time reaches an accuracy of " << *options_.accuracy
              << ": there is no limit of time\n";
}

std::vector<Column> Accuracy::with_claims(std::span<const Column> columns) const {
  std::vector<Column> out(columns.begin(), columns.end());
  if (options_.claim) out.insert(out.end(), {{"within", ""}, {"claim", ""}});
  return out;
}

void Accuracy::append_claim(Row& row, const Separation& answer) const {
  if (!options_.claim) return;
  const Claim claim = claim_of(answer, time_us_, curve_[0]);
  if (claim.by == Claim::By::nothing) return append_nothing(row, 2);
  row.insert(row.end(),
             {claim.within, claim.by == Claim::By::certified ? "certified" : "expected"});
}

}  // namespace sonde::app
