// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/pulse_windows.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

constexpr std::size_t lead = 10;  // samples of rest, from which the start position is known
/// s: a shorter time without a command belongs to the pulse.
constexpr double least_rest = 0.02;

/// The first sample from `from` on with a command, or the end.
std::size_t next_command(const AxisResponse& r, std::size_t from) {
  while (from < r.commands.size() && r.commands[from] == 0) ++from;
  return from;
}
/// One past the last sample with a command, of the pulse that begins at `first`.
std::size_t past_pulse(const AxisResponse& r, std::size_t first) {
  std::size_t last = first;
  for (std::size_t i = first; i < r.times.size() && r.times[i] - r.times[last] <= least_rest; ++i)
    if (r.commands[i] != 0) last = i;
  return last + 1;
}

/// The first sample from `earliest` on from which, until `first`, no other axis is commanded.
std::size_t undisturbed_since(const AxisResponse& r, std::size_t first, std::size_t earliest) {
  while (first > earliest && !r.others[first - 1]) --first;
  return first;
}
std::size_t undisturbed_until(const AxisResponse& r, std::size_t last, std::size_t latest) {
  while (last < latest && !r.others[last]) ++last;
  return last;
}

}  // namespace

AxisResponse axis_response(const Response& response, std::size_t axis) {
  AxisResponse out;
  const auto i = static_cast<Eigen::Index>(axis % 3);
  const Pose& start = response.front().X_BH;
  for (const ResponseSample& sample : response) {
    Wrench others = sample.command;
    (axis < 3 ? others.force : others.torque)[i] = 0;
    out.times.push_back(sample.t);
    out.others.push_back(!others.force.isZero(0) || !others.torque.isZero(0));
    out.commands.push_back((axis < 3 ? sample.command.force : sample.command.torque)[i]);
    out.positions.push_back(axis < 3 ? sample.X_BH.p[i] - start.p[i]
                                     : rotation_vector(sample.X_BH.q * start.q.conjugate())[i]);
  }
  return out;
}

std::vector<PulseWindow> pulse_windows(const AxisResponse& response) {
  const std::size_t size = response.times.size();
  std::vector<PulseWindow> out;
  std::size_t begin = 0;
  for (std::size_t first = next_command(response, 0); first < size;) {
    PulseWindow window{.first = first, .last = past_pulse(response, first)};
    const std::size_t following = next_command(response, window.last);
    window.begin =
        undisturbed_since(response, first, std::max(begin, first - std::min(lead, first)));
    window.end = undisturbed_until(response, window.last,
                                   std::min(following, window.last + (window.last - window.first)));
    for (std::size_t i = first; i < window.last; ++i)
      window.amplitude = std::max(window.amplitude, std::abs(response.commands[i]));
    out.push_back(window);
    begin = window.last;
    first = following;
  }
  return out;
}

std::size_t measured_in(const AxisResponse& response, const PulseWindow& window) {
  std::size_t count = 0;
  for (std::size_t k = window.begin; k < window.end; ++k) count += response.measured(k) ? 1 : 0;
  return count;
}

double excursion(const std::vector<double>& positions, const PulseWindow& window) {
  double most = 0;
  for (std::size_t i = window.begin; i < window.end; ++i)
    most = std::max(most, std::abs(positions[i] - positions[window.begin]));
  return most;
}

}  // namespace sonde
