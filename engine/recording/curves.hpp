// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/clearance_gauge.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/recording/tick_log.hpp"

namespace sonde {

/// The quantities that are plotted over time.
enum class Curve {
  held,      ///< m, depth of the separated pose
  nearest,   ///< m, √PD_g of the last search, or of the followed pose (with_followed)
  straight,  ///< m, PD_t of the last search
  bound,     ///< m, lower bound of the last search
  force,     ///< N, |F| on the hand
  force_x,
  force_y,
  force_z,
  torque,  ///< N·m, |τ|
  torque_x,
  torque_y,
  torque_z,
  tick_us,    ///< µs, time of the tick
  rows_us,    ///< µs, time that the geometry took for the tick's contact rows
  age,        ///< s, of the contact rows
  energy,     ///< J, net work on the hand
  clearance,  ///< m, the last measured distance; negative: minus the depth
};
constexpr std::size_t curve_count = 17;

struct CurvePoint {
  double time = 0;  ///< s
  double value = 0;
};

/// How far apart two ticks of a log may be, s, for a line from one to the other: further apart,
/// what was between them is not known. There is no limit along a path.
double longest_line(const TickLog& ticks);

/// Quantities of every tick, as columns that are fast to plot over minutes. A missing value is NaN.
class Curves {
 public:
  /// Drops the oldest ticks if there are more; 0: no limit. Between ticks that are further apart
  /// than `longest_line` (s) the curves are broken.
  explicit Curves(std::uint64_t most = 0,
                  double longest_line = std::numeric_limits<double>::infinity())
      : most_(most), longest_line_(longest_line) {}

  /// Adds the next tick, at a time that does not decrease, with the result of the last search and
  /// the last measured clearance.
  void add(const Snapshot& tick, double time, const BackgroundResult* searched,
           const GaugedClearance* clearance = nullptr);
  void clear();

  std::size_t size() const { return times_.size(); }
  double first_time() const { return times_.empty() ? 0 : times_.front(); }
  double last_time() const { return times_.empty() ? 0 : times_.back(); }
  /// The value at the last tick at or before that time; NaN if there is none.
  double at(Curve curve, double time) const;
  /// Divides the time from `from` to `to` into equal parts and returns the lowest and the highest
  /// point of each, in their order, with one point beyond each end: everything that a picture with
  /// that many columns can show. A break is a point without a value (NaN): where the ticks are far
  /// apart, or where values are missing for longer than a column.
  std::vector<CurvePoint> outline(Curve curve, double from, double to, std::size_t columns) const;
  std::size_t bytes() const;  ///< of memory

 private:
  std::uint64_t most_;
  double longest_line_;  ///< s
  std::deque<double> times_;
  std::array<std::deque<float>, curve_count> values_;
};

/// The curves of a whole log, which is decoded for them.
Curves curves_of(const TickLog& ticks, const Progress& progress = {});

}  // namespace sonde
