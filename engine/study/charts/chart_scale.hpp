// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sonde {

/// One axis of a chart, as requested.
struct ChartAxis {
  std::string label;                         ///< with the unit: "force, N"
  bool logarithmic = false;                  ///< values that have no logarithm are left out
  std::optional<double> from = {}, to = {};  ///< none: as the values require
  /// For an upright axis from 0 to the number of names: names for the rows of height 1, instead of
  /// numbers. A line break separates two lines.
  std::vector<std::string> names = {};
};

/// Maps values to places along an axis, with round values for its marks.
class ChartScale {
 public:
  /// The range contains all values that can be drawn, extended to round values; 0 to 1
  /// (logarithmic: 1 to 10) if there is none. Ends given by the axis are kept.
  ChartScale(const ChartAxis& axis, const std::vector<double>& values);

  /// 0 at the axis' beginning, 1 at its end; no value if it cannot be drawn. May lie outside 0 to 1
  /// if the axis gave its ends.
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
