// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/penetration/contact/separation.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The parts of the engine to which the study gives less or more time: the static search, the lower
/// bound of the depth, or a tick of the coherent solver.
enum class TradeKind { search, bound, tick };
const char* name_of(TradeKind kind);  ///< "static", "bound", "coherent"
const char* title_of(Method method);  ///< "PD_g", "PD_t"
/// The methods studied.
inline constexpr Method traded_methods[] = {Method::pdg, Method::pdt};

/// One setting of a trade study. The budget is counted: steps of a search (Budget::steps), work of
/// a bound (BoundOptions::work), work of a tick (Budget::work); 0: no limit, until converged.
struct TradeSetting {
  TradeKind kind = TradeKind::search;
  Method method = Method::pdg;
  std::int64_t budget = 0;
  bool operator==(const TradeSetting&) const = default;
};

/// The result of a setting at one pose.
struct TradeRun {
  TradeSetting setting;
  double depth = 0;    ///< m; for a bound, the bound. NaN if it failed
  int iterations = 0;  ///< of a search
  double time_us = 0;  ///< processor time
};

/// A pose with its best known depth and the result of each setting.
struct TradePose {
  std::array<double, 7> pose{};  ///< px, py, pz, qw, qx, qy, qz, of X_FM
  /// The depths found by the long searches, m, without those that failed.
  std::vector<double> long_pdg, long_pdt;
  std::vector<TradeRun> runs;

  /// The least depth that any search found, long or not, m; a translation also counts for all rigid
  /// motions. Infinite if none found any.
  double reference(Method method) const;
  /// Repeatability of the long searches: the largest of them over the least, minus 1. NaN if there
  /// is none.
  double spread(Method method) const;
};

/// The ticks of a device path followed with one setting. The three vectors have the same size.
struct TradePath {
  TradeSetting setting;
  std::vector<double> depth;    ///< m; NaN if a tick failed
  std::vector<char> converged;  ///< 0: the budget ran out, or the way was blocked
  std::vector<double> time_us;  ///< processor time
};

/// The answers without a budget for bodies that are tiny, huge or far away.
struct TradeExtreme {
  std::string world;  ///< "tiny", "huge", "far"
  TradeKind kind = TradeKind::search;
  Method method = Method::pdg;
  std::vector<double> change;  ///< for each pose: depth there / depth as given − 1; NaN: a failure
};

/// All measurements of a trade study.
struct TradeResults {
  std::string scene;
  double radius = 0;  ///< of the probe, m
  std::vector<TradeSetting> settings;
  std::vector<TradePose> poses;
  std::vector<TradePath> paths;
  std::vector<TradeExtreme> extremes;
};

/// As a JSON array.
std::string to_json(std::span<const TradeSetting> settings);
/// A part of the study as JSON text, its times in members named time_us; read back by read_trade.
std::string to_json(const TradePose& pose);
std::string to_json(const TradePath& path);
std::string to_json(std::span<const TradeExtreme> extremes);

/// The results in the parts of a complete folder; `folder` is for error messages. Throws InputError
/// if a part is missing or was not written by the study.
TradeResults read_trade(const std::string& folder, const StudyFolder& study);

/// The cost and accuracy of one setting, over all poses or ticks. The error of
/// - a search: depth / reference − 1;
/// - a bound: 1 − bound / reference, with the reference of PD_g;
/// - a tick: |depth − depth without a budget| over the largest depth without one on the path, at
///   the ticks where either is in contact.
/// A failure has an infinite error. Poses not deeper than 1e-6 of the probe's radius are left out.
struct TradeFigures {
  TradeSetting setting;
  std::size_t count = 0;  ///< poses, or ticks in contact
  std::size_t failed = 0;
  double median = 0, p90 = 0, worst = 0;                ///< of the error
  double within_1 = 0, within_5 = 0;                    ///< share with an error up to 1 %, 5 %
  double unconverged = 0;                               ///< share of the ticks; otherwise 0
  double time_median = 0, time_p99 = 0, time_p999 = 0;  ///< µs
};
/// The figures of every setting, in order. Without data the numbers are NaN.
std::vector<TradeFigures> trade_figures(const TradeResults& results);

/// The figures of one kind and method.
std::vector<TradeFigures> figures_of(const std::vector<TradeFigures>& all, TradeKind kind,
                                     Method method);

/// Repeatability of the long searches, over the poses that are not left out.
struct TradeReference {
  double median = 0, p90 = 0, worst = 0;  ///< of TradePose::spread; NaN if there is none
};
TradeReference trade_reference(const TradeResults& results, Method method);

/// The figures of one line of the extremes.
struct ExtremeFigures {
  std::size_t failed = 0;
  double median = 0, worst = 0;  ///< |change| of those that did not fail; NaN if all did
};
ExtremeFigures figures_of(const TradeExtreme& extreme);

/// depth / reference − 1 of a search, 1 − bound / reference of a bound.
double error_of(const TradePose& pose, const TradeRun& run);

/// Whether the pose counts; if not, it is left out.
bool is_deep_enough(const TradeResults& results, const TradePose& pose);

}  // namespace sonde
