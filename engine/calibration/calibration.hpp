// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/calibration/knob.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The kind of answers: of a search at one pose, or of the ticks along a path.
enum class Answers { search, tick };

/// The errors measured on one pair of bodies with one time limit, ascending; infinite for a failed
/// answer. The error of a search is depth / reference − 1, that of a tick how much it is deeper
/// than without a limit, over the largest depth of the path.
struct CalibrationPoint {
  double time_us = 0;  ///< wall-clock time; 0: none
  std::vector<double> errors;
  /// The errors of answers whose way out is long (Separation::far_out), which are not in `errors`.
  /// None: they were not distinguished, and `errors` contains all.
  std::optional<std::vector<double>> far_out = {};
};

/// One pair, one kind of answer.
struct CalibrationSeries {
  std::string pair;
  Answers answers = Answers::search;
  Method method = Method::pdg;
  bool has_sketches = true;              ///< the pair has sketches: one of the bodies is a solid
  std::vector<CalibrationPoint> points;  ///< by time, the one without a limit last
  std::string family = {};  ///< group of similar shapes; empty: the pair is its own group
};

/// The name of the family that the series is of.
const std::string& family_of(const CalibrationSeries& series);

/// The measurements on all pairs.
struct Calibration {
  std::vector<CalibrationSeries> series;
};
/// The measurements on the pair of that name only; empty if there are none.
Calibration of_pair(const Calibration& calibration, const std::string& pair);

/// The measurements of `measured`, plus those of `other` that were not measured again: of another
/// pair, another kind of answer, or another method.
Calibration joined(Calibration measured, const Calibration& other);

/// Factor on the requested time: an answer that takes longer is not an answer in that time.
inline constexpr double not_late = 1.1;

/// The share of answers that keep their claim, unless another share is requested.
inline constexpr double usually_sure = 0.9;

/// The accuracy that nine in ten answers of a kind (or another share) reach, as a function of their
/// time: of all families alike if ten pairs or more were measured, otherwise of the worst pair's.
/// Of searches it is at least clearance_of_depth, by which an answer may stand off its contacts.
/// Answers whose way out is long (Separation::far_out) have a curve of their own.
class AccuracyCurve {
 public:
  /// Uses the series of that kind, from pairs with sketches or from pairs without; if there are
  /// none of these, all of that kind. `sure`: the share of answers, above 0 and below 1.
  AccuracyCurve(const Calibration& calibration, Answers answers, Method method, bool has_sketches,
                double sure = usually_sure);

  bool known() const { return !near_.points.empty(); }
  /// The expected accuracy of that share of answers, as a share of the depth. Infinite if nothing
  /// is known: with less time than was measured, if too many failed, or for a tick without a limit,
  /// which is the reference of the others. 0 µs: no limit.
  double within(double time_us, bool far_out = false) const {
    return (far_out ? far_ : near_).within(time_us);
  }
  /// The least time for which that accuracy is expected of answers whose way out is not long, µs;
  /// 0: no time limit.
  double time_for(double accuracy) const;

 private:
  struct Point {
    double time_us, within;
  };
  struct Line {
    std::vector<Point> points = {};  // with a limit, by time; more time is never worse
    double without_limit;
    double within(double time_us) const;
  };
  Line near_, far_;
};

/// The time budget that a knob stands for, µs; 0: none.
double budget_us(const Knob& knob, const AccuracyCurve& curve);

/// The narrower of two claims about the answer: from its lower bound, if it has one, and from the
/// calibration for that time (0: without a limit).
Claim claim_of(const Separation& answer, double time_us, const AccuracyCurve& curve);

}  // namespace sonde
