// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sonde {

/// One axis of a chart, as asked for.
struct ChartAxis {
  std::string label;                         ///< with the unit: "force, N"
  bool logarithmic = false;                  ///< values that have no logarithm are left out
  std::optional<double> from = {}, to = {};  ///< without: what the values need
  /// Of an upright axis from 0 to their number: what each row of height 1 is, instead of numbers. A
  /// line break parts two lines.
  std::vector<std::string> names = {};
};

/// The place of values along an axis, and the round values at which it is marked.
class ChartScale {
 public:
  /// Holds all the values that can be drawn, up to the next round ones; 0 to 1 (logarithmic: 1 to
  /// 10) where there is none. Ends that the axis gives are kept.
  ChartScale(const ChartAxis& axis, const std::vector<double>& values);

  /// 0 at the axis' beginning, 1 at its end; no value where the axis has no place for it. May lie
  /// outside of 0 to 1 where the axis' ends were given.
  std::optional<double> place(double value) const;

  struct Tick {
    double place;
    std::string text;  ///< empty: a mark without a number
  };
  std::vector<Tick> ticks() const;

 private:
  double raw(double value) const;
  void hold(const ChartAxis& axis, std::vector<double> values);
  void give_length();
  void round_ends();
  std::vector<Tick> linear_ticks() const;
  std::vector<Tick> logarithmic_ticks() const;
  bool logarithmic_;
  double low_ = 0, high_ = 1;  ///< values, or their decimal logarithms
};

}  // namespace sonde
