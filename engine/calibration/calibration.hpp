// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/calibration/knob.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// Whose answers: a search's at one pose, or the ticks' that follow a path.
enum class Answers { search, tick };

/// What was measured on one pair of bodies with one limit of time: the error of each answer,
/// ascending; infinite where it failed. That of a search is depth / reference − 1, that of a tick
/// |depth − depth without a limit| over the largest depth of the path.
struct CalibrationPoint {
  double time_us = 0;  ///< of the wall's clock; 0: none
  std::vector<double> errors;
};

/// One pair, one kind of answer.
struct CalibrationSeries {
  std::string pair;
  Answers answers = Answers::search;
  Method method = Method::pdg;
  bool sketched = true;                  ///< the pair has sketches: one of the bodies is a solid
  std::vector<CalibrationPoint> points;  ///< by time, none last
};

/// What was measured, on as many pairs as there are.
struct Calibration {
  std::vector<CalibrationSeries> series;
};

/// The accuracy that nine in ten answers of a kind keep to, by their time.
class AccuracyCurve {
 public:
  /// Made of the series of that kind; where none is of pairs with (or without) sketches, of all.
  AccuracyCurve(const Calibration& calibration, Answers answers, Method method, bool sketched);

  bool known() const { return !points_.empty(); }
  /// The share of the depth, expected of nine in ten; infinite where nothing is known: with less
  /// time than was measured, or where more than one in ten failed. 0 µs: no limit.
  double within(double time_us) const;
  /// The least time for which that accuracy is expected, µs; 0 where it takes as long as it takes.
  double time_for(double accuracy) const;

 private:
  struct Point {
    double time_us, within;
  };
  std::vector<Point> points_;  // with a limit, by time; more time is no worse
  double without_limit_;
};

/// A budget of time for the knob, µs; 0: none.
double budget_us(const Knob& knob, const AccuracyCurve& curve);

/// What the answer claims, the narrower of the two: the bound where it has one, or what is expected
/// of an answer in so much time (0: without a limit).
Claim claim_of(const Separation& answer, double time_us, const AccuracyCurve& curve);

}  // namespace sonde
