// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/calibration/knob.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The kind of answers: a search's at one pose, or those of the ticks along a path.
enum class Answers { search, tick };

/// The errors measured on one pair of bodies with one limit of time, ascending; infinite where an
/// answer failed. The error of a search is depth / reference − 1, that of a tick |depth − depth
/// without a limit| over the largest depth of the path.
struct CalibrationPoint {
  double time_us = 0;  ///< wall-clock time; 0: none
  std::vector<double> errors;
  /// Of the answers whose way out is long (Separation::far_out), which `errors` are without. None:
  /// these were not told apart, `errors` are of all.
  std::optional<std::vector<double>> far_out = {};
};

/// One pair, one kind of answer.
struct CalibrationSeries {
  std::string pair;
  Answers answers = Answers::search;
  Method method = Method::pdg;
  bool sketched = true;                  ///< the pair has sketches: one of the bodies is a solid
  std::vector<CalibrationPoint> points;  ///< by time, none last
  std::string family = {};               ///< shapes alike; empty: the pair is one by itself
};

/// The measurements on all pairs.
struct Calibration {
  std::vector<CalibrationSeries> series;
};
/// The measurements on the pair of that name alone; none where there are none.
Calibration of_pair(const Calibration& calibration, const std::string& pair);

/// The measurements of `measured`, and those of `other` that were not measured again: of another
/// pair, another kind of answer, or by another method.
Calibration joined(Calibration measured, const Calibration& other);

/// Of the time that was asked for: an answer that takes more did not have it.
inline constexpr double not_late = 1.1;

/// Of the answers: how many keep to what is expected of them where nothing else is asked for.
inline constexpr double usually_sure = 0.9;

/// The accuracy that nine in ten answers of a kind reach, or another share of them, by their time:
/// of all answers together where ten pairs or more were measured, else of the answers of the worst
/// pair. Answers whose way out is long (Separation::far_out) are expected to be as those are.
class AccuracyCurve {
 public:
  /// Uses the series of that kind, from pairs with sketches or from pairs without; where there are
  /// none of these, all of that kind. `sure`: the share of answers, above 0 and below 1.
  AccuracyCurve(const Calibration& calibration, Answers answers, Method method, bool sketched,
                double sure = usually_sure);

  bool known() const { return !near_.points.empty(); }
  /// The expected accuracy, as a share of the depth, of so many answers. Infinite where nothing
  /// is known: with less time than was measured, where too many failed, or for a tick without a
  /// limit, which the others are compared with. 0 µs: no limit.
  double within(double time_us, bool far_out = false) const {
    return (far_out ? far_ : near_).within(time_us);
  }
  /// The least time for which that accuracy is expected of answers whose way out is not long, µs;
  /// 0: no limit of time.
  double time_for(double accuracy) const;

 private:
  struct Point {
    double time_us, within;
  };
  struct Line {
    std::vector<Point> points = {};  // with a limit, by time; more time is no worse
    double without_limit;
    double within(double time_us) const;
  };
  Line near_, far_;
};

/// A budget of time for the knob, µs; 0: none.
double budget_us(const Knob& knob, const AccuracyCurve& curve);

/// The claim of the answer, the narrower of two: from the bound where it has one, and from what is
/// expected of an answer in that time (0: without a limit).
Claim claim_of(const Separation& answer, double time_us, const AccuracyCurve& curve);

}  // namespace sonde
