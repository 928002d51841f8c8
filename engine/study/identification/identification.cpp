// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/identification.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/base/elementary.hpp"
#include "engine/base/error.hpp"
#include "engine/base/ordering.hpp"
#include "engine/study/identification/encoder_step.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

constexpr std::size_t axis_count = 6;
constexpr std::size_t least_pulses = 8;  // with fewer, an interval is unreliable
// Samples of a pulse: each of its four parts then has five or more.
constexpr std::size_t least_samples = 20;
// Steps of the encoder: its rounding is then below 2 % of the excursion.
constexpr double least_steps = 20;
constexpr double least_ratio = 1.5;  // of amplitudes
constexpr double most_misfit = 0.1;  // of the motion's rms
constexpr double most_half = 0.25;   // of the inertia's interval, as a share
constexpr double longest_gap = 2.5;  // sample times
// s: the loop trusts no older sample of a device, and ends the pulses
constexpr double longest_late_tick = 0.02;

using Windows = std::vector<PulseWindow>;

std::string with_unit(double value, std::size_t axis, const char* unit, const char* turning) {
  return number_text(value, 3) + ' ' + (axis < 3 ? unit : turning);
}

double median_step(const Response& response) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < response.size(); ++i)
    steps.push_back(response[i].t - response[i - 1].t);
  if (steps.empty()) throw InputError("the recording has a single sample");
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  ordering::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// The noise before the pulses, by second differences, which are insensitive to slow drift;
/// expressed as an encoder step that would be as coarse.
double grain_of_noise(const AxisResponse& r, const Windows& windows) {
  double squares = 0, count = 0;
  for (const PulseWindow& w : windows)
    for (std::size_t i = w.begin + 1; i + 1 <= w.first; ++i) {
      const double bend = r.positions[i - 1] - 2 * r.positions[i] + r.positions[i + 1];
      squares += bend * bend / 6;
      ++count;
    }
  return count > 0 ? std::sqrt(12 * squares / count) : 0;
}

double largest(const Windows& windows) {
  return std::ranges::max_element(windows, {}, &PulseWindow::amplitude)->amplitude;
}

/// Throws unless the commands of the other axes are zero.
void check_alone(const AxisResponse& r, const PulseWindow& w) {
  for (std::size_t k = w.begin; k < w.end; ++k)
    if (r.others[k])
      throw std::invalid_argument(
          "another axis is commanded too at t = " + number_text(r.times[k]) + " s");
}

struct WithoutGaps {
  Windows windows;
  std::vector<std::size_t> at_rest;  ///< index of the next window after each gap
  std::size_t gaps = 0;              ///< number of the other windows
};

double change(const AxisResponse& r, std::size_t k) { return r.positions[k] - r.positions[k - 1]; }

/// What makes a sample unfit for use.
struct Lateness {
  double step;         ///< s, the sample time
  double gap;          ///< s: the command is not known over a longer one
  double encoder = 0;  ///< m | rad
  bool repeats_count = true;
};

/// The change to sample k, as far as it would be in one sample time: it took as long as the
/// position before it was told.
double pace(const AxisResponse& r, std::size_t k, double step) {
  std::size_t since = k - 1;
  while (since > 0 && change(r, since) == 0 && r.times[k] - r.times[since] < longest_late_tick)
    --since;
  return change(r, k) * step / (r.times[k] - r.times[since]);
}

/// A logger without a new pose repeats the last one: the position is constant for some samples,
/// while the steps before and after go the same way and are far larger than a step of the encoder,
/// and than the slow end of a motion. The number of samples from k on that repeat the one before,
/// none if they last longer than a loop trusts a device: a handle may rest so long.
std::size_t repeated(const AxisResponse& r, const PulseWindow& w, std::size_t k,
                     const Lateness& late) {
  if (k < w.begin + 2 || change(r, k) != 0 || change(r, k - 1) == 0) return 0;
  std::size_t end = k + 1;
  while (end < r.times.size() && change(r, end) == 0) ++end;
  if (end == r.times.size() || r.times[end - 1] - r.times[k - 1] > longest_late_tick) return 0;
  double most = 0;
  for (std::size_t i = w.begin + 1; i < w.end; ++i)
    most = std::max(most, std::abs(pace(r, i, late.step)));
  const double before = pace(r, k - 1, late.step), after = pace(r, end, late.step);
  const bool moves = before * after > 0 && std::min(std::abs(before), std::abs(after)) >
                                               std::max(3 * late.encoder, 0.1 * most);
  return moves ? end - k : 0;
}

/// The first sample of a pulse, from the one before it to the one after, that comes too late, or
/// that only repeats the previous one. If there is none: the size of the recording.
std::size_t late_sample(const AxisResponse& r, const PulseWindow& w, const Lateness& late) {
  for (std::size_t k = std::max<std::size_t>(w.begin, 1); k <= w.end && k < r.times.size(); ++k) {
    if (r.times[k] - r.times[k - 1] > late.gap) return k;
    if (late.repeats_count && k < w.end && repeated(r, w, k, late) == 1) return k;
  }
  return r.times.size();
}

std::vector<bool> repeats_of(const AxisResponse& r, const Windows& windows, const Lateness& late) {
  std::vector<bool> out(r.times.size(), false);
  for (const PulseWindow& w : windows)
    for (std::size_t k = w.begin; k < w.end; ++k)
      std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(k),
                  std::min(repeated(r, w, k, late), w.end - k), true);
  return out;
}

std::string what_is_missing(const AxisResponse& r, std::size_t late, double longest) {
  const double gap = r.times[late] - r.times[late - 1];
  const std::string at = "t = " + number_text(r.times[late], 9) + " s";
  return gap > longest ? "no sample for " + number_text(1e3 * gap, 3) + " ms before " + at
                       : "the sample at " + at + " repeats the one before, while the handle moves";
}

/// If a sample is missing, the commands meanwhile are unknown, so that pulse is not used. (A longer
/// gap cuts a pulse in two, with the gap between them.)
WithoutGaps without_gaps(const AxisResponse& r, const Windows& windows, const Lateness& lateness) {
  WithoutGaps out;
  std::size_t last = r.times.size();
  bool after_gap = false;
  for (const PulseWindow& w : windows) {
    const std::size_t late = late_sample(r, w, lateness);
    if (late == r.times.size()) {
      if (after_gap) out.at_rest.push_back(w.begin);
      out.windows.push_back(w);
    } else {
      out.gaps += late != last;
      last = late;
    }
    after_gap = late != r.times.size();
  }
  if (out.gaps > 0 && out.windows.size() < least_pulses)
    throw std::invalid_argument(what_is_missing(r, last, lateness.gap) +
                                ", and samples are missing in " + std::to_string(out.gaps) +
                                " pulses: " + std::to_string(out.windows.size()) +
                                " are whole; it takes " + std::to_string(least_pulses));
  return out;
}

/// The windows in which the handle moved far enough to be useful.
Windows telling(const AxisResponse& r, const Windows& windows, double grain, std::size_t axis) {
  Windows out;
  for (const PulseWindow& w : windows)
    if (excursion(r.positions, w) > least_steps * grain) out.push_back(w);
  if (out.size() >= least_pulses) return out;
  const std::string most = with_unit(largest(windows), axis, "N", "N·m");
  if (out.empty() && grain == 0)
    throw std::invalid_argument("the handle did not move under pulses of up to " + most);
  throw std::invalid_argument("the handle moved by " + number_text(least_steps) +
                              " steps of its encoder, or as far beyond its noise, in " +
                              std::to_string(out.size()) + " of " + std::to_string(windows.size()) +
                              " pulses of up to " + most + "; it takes " +
                              std::to_string(least_pulses));
}

void check_pulses(const AxisResponse& r, const Windows& windows) {
  if (windows.size() < least_pulses)
    throw std::invalid_argument(std::to_string(windows.size()) + " pulses; it takes " +
                                std::to_string(least_pulses));
  for (const PulseWindow& w : windows) {
    if (w.last - w.first < least_samples)
      throw std::invalid_argument("the pulse at t = " + number_text(r.times[w.first]) + " s has " +
                                  std::to_string(w.last - w.first) + " samples; it takes " +
                                  std::to_string(least_samples));
    check_alone(r, w);
  }
}

void check_amplitudes(const Windows& windows, std::size_t axis) {
  const double least = std::ranges::min_element(windows, {}, &PulseWindow::amplitude)->amplitude;
  if (largest(windows) >= least_ratio * least) return;
  throw std::invalid_argument(
      "the handle moved under pulses of " + with_unit(least, axis, "N", "N·m") + " to " +
      with_unit(largest(windows), axis, "N", "N·m") +
      " alone: friction and damping are told apart only by amplitudes that differ by half");
}

void check_fit(const HandleFit& fit, std::size_t axis) {
  if (!(fit.misfit <= most_misfit))
    throw std::invalid_argument("a free handle does not move like this: it leaves " +
                                number_text(100 * fit.misfit, 2) +
                                " % of the motion. Was it held, or did it reach a stop?");
  if (!(fit.inertia.high - fit.inertia.low <= 2 * most_half * fit.inertia.value))
    throw std::invalid_argument("too much noise: " + std::string(axis < 3 ? "mass" : "inertia") +
                                " is between " + with_unit(fit.inertia.low, axis, "kg", "kg·m²") +
                                " and " + with_unit(fit.inertia.high, axis, "kg", "kg·m²"));
}

/// If no step was seen, it may be as large as the residual noise and model error.
Estimate largest_step(const AxisResponse& r, const Windows& windows, const HandleFit& fit) {
  double squares = 0, count = 0;
  for (const PulseWindow& w : windows) {
    double mean = 0;
    const auto size = static_cast<double>(w.end - w.begin);
    for (std::size_t i = w.begin; i < w.end; ++i) mean += r.positions[i] / size;
    for (std::size_t i = w.begin; i < w.end; ++i)
      squares += (r.positions[i] - mean) * (r.positions[i] - mean);
    count += size;
  }
  const double most = fit.misfit * std::sqrt(12 * squares / count);
  return {most, 0, most};
}

/// Throws std::invalid_argument, with the reason, if the pulses are not sufficient.
IdentifiedAxis identified(AxisResponse r, const Windows& all, std::size_t axis, double sample_time,
                          Rows rows, const Progress& progress) {
  const std::optional<Estimate> step = encoder_step(r.positions);
  const double encoder = step ? step->value : 0;
  const bool known = rows == Rows::all_logged;
  const Lateness late{sample_time, known ? longest_late_tick : longest_gap * sample_time, encoder,
                      !known};
  const auto [whole, at_rest, gaps] = without_gaps(r, all, late);
  r.at_rest = at_rest;
  if (known) r.repeats = repeats_of(r, whole, late);
  check_pulses(r, whole);
  const double grain = std::max(encoder, grain_of_noise(r, whole));
  const Windows windows = telling(r, whole, grain, axis);
  check_amplitudes(windows, axis);
  IdentifiedAxis out{.axis = axis,
                     .handle = fit_handle(r, windows, encoder, progress),
                     .resolution = {},
                     .has_steps = step.has_value(),
                     .pulses = windows.size(),
                     .with_gaps = gaps,
                     .most = largest(windows)};
  check_fit(out.handle, axis);
  out.resolution = step ? *step : largest_step(r, windows, out.handle);
  return out;
}

template <class Get>
Estimate joined(const std::vector<const IdentifiedAxis*>& axes, const Get& get) {
  Estimate out{0, get(*axes.front()).low, get(*axes.front()).high};
  for (const IdentifiedAxis* axis : axes) {
    const Estimate one = get(*axis);
    out.value += one.value / static_cast<double>(axes.size());
    out.low = std::min(out.low, one.low);
    out.high = std::max(out.high, one.high);
  }
  return out;
}

std::optional<IdentifiedKind> kind_of(const std::vector<IdentifiedAxis>& axes, bool turning) {
  std::vector<const IdentifiedAxis*> own;
  for (const IdentifiedAxis& each : axes)
    if ((each.axis >= 3) == turning) own.push_back(&each);
  if (own.empty()) return std::nullopt;
  return IdentifiedKind{joined(own, [](const IdentifiedAxis& a) { return a.handle.inertia; }),
                        joined(own, [](const IdentifiedAxis& a) { return a.handle.damping; }),
                        joined(own, [](const IdentifiedAxis& a) { return a.handle.friction; }),
                        joined(own, [](const IdentifiedAxis& a) { return a.resolution; })};
}

void expect_any(const Identification& found) {
  if (!found.axes.empty()) return;
  if (found.refused.empty()) throw InputError("no pulse in the recording: no command is not zero");
  std::string reasons = "no axis can be identified";
  for (const RefusedAxis& each : found.refused)
    reasons += (&each == &found.refused.front() ? ": " : "; ") + name_of_axis(each.axis) + ": " +
               each.reason;
  throw InputError(reasons);
}

}  // namespace

Identification identify(const Response& response, Rows rows, const Progress& progress) {
  if (response.empty()) throw InputError("the recording has no samples");
  Identification out;
  out.sample_time = median_step(response);
  for (std::size_t axis = 0; axis < axis_count; ++axis) {
    const AxisResponse r = axis_response(response, axis);
    const Windows windows = pulse_windows(r);
    if (windows.empty()) continue;
    try {
      const auto done = static_cast<double>(axis), all = static_cast<double>(axis_count);
      out.axes.push_back(identified(r, windows, axis, out.sample_time, rows,
                                    part_of(progress, done / all, (done + 1) / all)));
    } catch (const std::invalid_argument& reason) {
      out.refused.push_back({axis, reason.what()});
    }
  }
  expect_any(out);
  out.translation = kind_of(out.axes, false);
  out.rotation = kind_of(out.axes, true);
  std::vector<const IdentifiedAxis*> all;
  for (const IdentifiedAxis& each : out.axes) all.push_back(&each);
  out.delay = joined(all, [](const IdentifiedAxis& a) { return a.handle.delay; });
  return out;
}

std::string name_of_axis(std::size_t axis) {
  constexpr const char* names[] = {"force along x",  "force along y",  "force along z",
                                   "torque about x", "torque about y", "torque about z"};
  return names[axis];
}

}  // namespace sonde
