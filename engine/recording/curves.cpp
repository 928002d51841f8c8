// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"

namespace sonde {
namespace {

std::array<double, curve_count> values_of(const Snapshot& tick, const BackgroundResult* searched,
                                          const GaugedClearance* clearance) {
  const Separation& s = tick.separation;
  const auto depth = [](const std::optional<FoundSeparation>& way) {
    return way ? way->depth : no_number;
  };
  return {s.status == Status::failed ? no_number : s.depth,
          searched ? depth(with_followed(*searched, s).nearest) : no_number,
          searched ? depth(searched->pdt) : no_number,
          searched ? searched->lower_bound.value_or(no_number) : no_number,
          tick.wrench.force.norm(),
          tick.wrench.force.x(),
          tick.wrench.force.y(),
          tick.wrench.force.z(),
          tick.wrench.torque.norm(),
          tick.wrench.torque.x(),
          tick.wrench.torque.y(),
          tick.wrench.torque.z(),
          tick.tick_us,
          tick.hand.rows.refresh_us,
          tick.hand.rows.age,
          tick.hand.energy.given,
          signed_clearance(s, clearance).value_or(no_number)};
}

/// s: a servo that is late on a busy machine loses fewer ticks than that.
constexpr double shortest_break = 0.1;
constexpr double break_periods = 20;  // of a slow servo

/// Collects the lowest and the highest point of one interval, in their order.
class GatheredTicks {
 public:
  void add(double time, float value) {
    if (!any_ || value < low_.value) low_ = {time, value};
    if (!any_ || value > high_.value) high_ = {time, value};
    any_ = true;
  }
  void end(std::vector<CurvePoint>& out) {
    if (!any_) return;
    const bool low_first = low_.time <= high_.time;
    out.push_back(low_first ? low_ : high_);
    if (low_.time != high_.time) out.push_back(low_first ? high_ : low_);
    any_ = false;
  }

 private:
  CurvePoint low_, high_;
  bool any_ = false;
};

}  // namespace

double longest_line(const TickLog& ticks) {
  return ticks.along_path ? std::numeric_limits<double>::infinity()
                          : std::max(shortest_break, break_periods / ticks.rate_hz());
}

void Curves::add(const Snapshot& tick, double time, const BackgroundResult* searched,
                 const GaugedClearance* clearance) {
  times_.push_back(time);
  const std::array<double, curve_count> values = values_of(tick, searched, clearance);
  for (std::size_t i = 0; i < curve_count; ++i) values_[i].push_back(static_cast<float>(values[i]));
  if (most_ == 0 || times_.size() <= most_) return;
  times_.pop_front();
  for (std::deque<float>& column : values_) column.pop_front();
}

void Curves::clear() {
  times_.clear();
  for (std::deque<float>& column : values_) column.clear();
}

std::size_t Curves::bytes() const {
  return times_.size() * (sizeof(double) + curve_count * sizeof(float));
}

double Curves::at(Curve curve, double time) const {
  const auto after = std::ranges::upper_bound(times_, time);
  if (after == times_.begin()) return no_number;
  return static_cast<double>(values_[static_cast<std::size_t>(curve)]
                                    [static_cast<std::size_t>(after - times_.begin() - 1)]);
}

std::vector<CurvePoint> Curves::outline(Curve curve, double from, double to,
                                        std::size_t columns) const {
  std::vector<CurvePoint> out;
  if (times_.empty() || columns == 0 || !(to > from)) return out;
  const std::deque<float>& values = values_[static_cast<std::size_t>(curve)];
  auto begin = std::ranges::lower_bound(times_, from), end = std::ranges::upper_bound(times_, to);
  if (begin != times_.begin()) --begin;
  if (end != times_.end()) ++end;
  const double part = (to - from) / static_cast<double>(columns);
  auto value = values.begin() + (begin - times_.begin());
  GatheredTicks gathered;
  double column = -1;
  const double longest = std::max(longest_line_, part);  // a shorter break is not seen
  std::optional<double> known;                           // time of the last value
  bool missing = false;                                  // since then
  for (auto time = begin; time != end; ++time, ++value) {
    const double now = std::floor((*time - from) / part);
    if (now != column) gathered.end(out);
    column = now;
    if (std::isnan(*value)) {
      missing = true;
      continue;
    }
    if (known && *time - *known > (missing ? part : longest))
      out.push_back({(*time + *known) / 2, no_number});
    known = *time;
    missing = false;
    gathered.add(*time, *value);
  }
  gathered.end(out);
  return out;
}

Curves curves_of(const TickLog& ticks, const Progress& progress) {
  Curves curves(0, longest_line(ticks));
  const std::uint64_t count = ticks.end() - ticks.begin();
  for (std::uint64_t i = 0; i < count; ++i) {
    const Snapshot tick = ticks.at(ticks.begin() + i);
    const RecordedSearch* search = ticks.searched(tick.time);
    curves.add(tick, tick.time, search ? &search->result : nullptr);
    if (progress && i % TickLog::block_ticks == 0 &&
        !progress(static_cast<double>(i) / static_cast<double>(count)))
      throw Cancelled();
  }
  return curves;
}

}  // namespace sonde
