// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/calibration/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "engine/base/elementary.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/base/quantile.hpp"
#include "engine/penetration/descent/descent.hpp"

namespace sonde {
namespace {

/// Shares below this count as equal in the interpolation; it is the accuracy of the reference.
constexpr double least_within = 1e-6;

/// The answers of one pair are not independent. With fewer pairs than this, the worst one counts,
/// since another may be as bad. If it is larger, claims of kinds with few pairs are wider than
/// necessary.
constexpr std::size_t enough_pairs = 10;

/// The errors of one pair with one time limit.
struct ErrorsOfPair {
  std::string family;
  std::vector<double> errors;
};
using ErrorsByTime = std::map<double, std::vector<ErrorsOfPair>>;  // by that limit

struct KindOfAnswer {
  Answers answers;
  Method method;
  std::optional<bool> has_sketches;  ///< none: either
  bool far_out;

  bool holds(const CalibrationSeries& series) const {
    return series.answers == answers && series.method == method &&
           series.has_sketches == has_sketches.value_or(series.has_sketches);
  }
};

ErrorsByTime of_kind(const Calibration& calibration, const KindOfAnswer& kind) {
  ErrorsByTime out;
  for (const CalibrationSeries& series : calibration.series) {
    if (!kind.holds(series)) continue;
    for (const CalibrationPoint& point : series.points)
      if (const auto& errors = kind.far_out ? point.far_out.value_or(point.errors) : point.errors;
          !errors.empty())
        out[point.time_us].push_back({family_of(series), errors});
  }
  return out;
}

/// The least error that this share of the answers keeps, of all families alike: what is asked next
/// is as likely of one kind as of another, however many pairs of each were measured.
double kept_by_families(const std::vector<ErrorsOfPair>& of_pairs, double sure) {
  std::map<std::string, std::size_t> sizes;
  for (const ErrorsOfPair& pair : of_pairs) sizes[pair.family] += pair.errors.size();
  struct Weighted {
    double error, weight;
  };
  std::vector<Weighted> all;
  for (const ErrorsOfPair& pair : of_pairs)
    for (const double error : pair.errors)
      all.push_back({error, 1 / static_cast<double>(sizes[pair.family] * sizes.size())});
  ordering::sort(all, {}, &Weighted::error);
  double share = 0;
  for (const Weighted& one : all)
    if (share += one.weight; share >= sure - 1e-9) return one.error;  // beyond the sum's rounding
  return all.back().error;
}

/// The error that this share of the answers keeps.
double kept_to(const std::vector<ErrorsOfPair>& of_pairs, double sure) {
  if (of_pairs.size() >= enough_pairs) return kept_by_families(of_pairs, sure);
  double worst = 0;
  for (const ErrorsOfPair& pair : of_pairs) worst = std::max(worst, quantile(pair.errors, sure));
  return worst;
}

/// Linear interpolation in logarithmic axes.
double between(double x, double x0, double y0, double x1, double y1) {
  const auto up = [](double y) { return elementary::log(std::max(y, least_within)); };
  const double part =
      (elementary::log(x) - elementary::log(x0)) / (elementary::log(x1) - elementary::log(x0));
  return elementary::exp(up(y0) + part * (up(y1) - up(y0)));
}

}  // namespace

const std::string& family_of(const CalibrationSeries& series) {
  return series.family.empty() ? series.pair : series.family;
}

Calibration of_pair(const Calibration& calibration, const std::string& pair) {
  Calibration out;
  std::ranges::copy_if(calibration.series, std::back_inserter(out.series),
                       [&](const CalibrationSeries& series) { return series.pair == pair; });
  return out;
}

Calibration joined(Calibration measured, const Calibration& other) {
  const auto same = [](const CalibrationSeries& a, const CalibrationSeries& b) {
    return a.pair == b.pair && a.answers == b.answers && a.method == b.method;
  };
  Calibration out;
  std::ranges::copy_if(
      other.series, std::back_inserter(out.series), [&](const CalibrationSeries& old) {
        return std::ranges::none_of(measured.series,
                                    [&](const CalibrationSeries& now) { return same(old, now); });
      });
  std::ranges::move(measured.series, std::back_inserter(out.series));
  return out;
}

AccuracyCurve::AccuracyCurve(const Calibration& calibration, Answers answers, Method method,
                             bool has_sketches, double sure) {
  // The references of searches stand off their contacts as the answers do, the true depth does not.
  // Ticks are compared with ticks.
  const double least = answers == Answers::search ? clearance_of_depth : 0;
  const auto line = [&](bool far_out) {
    auto errors = of_kind(calibration, {answers, method, has_sketches, far_out});
    if (errors.empty()) errors = of_kind(calibration, {answers, method, std::nullopt, far_out});
    Line out{.without_limit = infinity};
    double best = infinity;
    for (const auto& [time_us, of_pairs] : errors) {
      if (time_us <= 0) continue;
      best = std::min(best, std::max(least, kept_to(of_pairs, sure)));
      out.points.push_back({time_us, best});
    }
    // Ticks without a limit are the reference of the other ticks.
    const auto unlimited = errors.find(0);
    if (answers == Answers::search && unlimited != errors.end())
      out.without_limit = std::min(best, std::max(least, kept_to(unlimited->second, sure)));
    return out;
  };
  near_ = line(false);
  far_ = line(true);
}

double AccuracyCurve::Line::within(double time_us) const {
  if (!(time_us > 0)) return without_limit;
  const auto later = std::ranges::upper_bound(points, time_us, {}, &Point::time_us);
  if (later == points.begin()) return infinity;
  const Point& before = *(later - 1);
  if (later == points.end() || !std::isfinite(before.within)) return before.within;
  return between(time_us, before.time_us, before.within, later->time_us, later->within);
}

double AccuracyCurve::time_for(double accuracy) const {
  const std::vector<Point>& points = near_.points;
  const auto first =
      std::ranges::find_if(points, [&](const Point& point) { return point.within <= accuracy; });
  if (first == points.end()) return 0;
  if (first == points.begin()) return first->time_us;
  const Point& before = *(first - 1);
  if (!std::isfinite(before.within)) return first->time_us;
  const double high = elementary::log(before.within),
               low = elementary::log(std::max(first->within, least_within));
  const double part = (high - elementary::log(std::max(accuracy, least_within))) / (high - low);
  return before.time_us *
         elementary::pow(first->time_us / before.time_us, std::clamp(part, 0.0, 1.0));
}

double budget_us(const Knob& knob, const AccuracyCurve& curve) {
  return knob.accuracy > 0 ? curve.time_for(knob.accuracy) : 1e6 * knob.time;
}

Claim claim_of(const Separation& answer, double time_us, const AccuracyCurve& curve) {
  if (answer.status == Status::failed) return {};
  if (answer.status == Status::separated) return {Claim::By::certified, 0};
  const double bound = answer.lower_bound.value_or(0);
  const double certified = bound > 0 ? answer.depth / bound - 1 : infinity;
  const double expected = curve.within(time_us, answer.far_out);
  if (std::isfinite(certified) && certified <= expected) return {Claim::By::certified, certified};
  if (std::isfinite(expected)) return {Claim::By::expected, expected};
  return {};
}

}  // namespace sonde
