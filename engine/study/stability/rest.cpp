// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/rest.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// Energies are compared over this many windows: 1.5 s.
constexpr std::size_t looked_back = 5;
constexpr double falls_to = 0.9;
constexpr double next_to_nothing = 0.01;  // share of the quiet energy

/// One window of the hold.
class Window {
 public:
  Window(const SimulatedDeviceParameters& device, const HandleState& from)
      : device_(device),
        from_(from.X_WD),
        radius_(std::sqrt(device.rotation.inertia / device.translation.inertia)) {}

  void add(const HandleState& state) {
    energy_ += kinetic_energy(device_, state);
    way_.emplace_back();
    way_.back() << state.X_WD.p - from_.p,
        radius_ * rotation_vector(state.X_WD.q * from_.q.conjugate());
  }

  double energy() const { return energy_ / double(way_.size()); }

  void describe_swing(double sample_time, RestReport& out) const {
    Vec6 low = way_.front(), high = low, sum = Vec6::Zero();
    for (const Vec6& x : way_) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      sum += x;
    }
    Eigen::Index most = 0;
    out.swing = (high - low).maxCoeff(&most) / 2;
    const double mean = sum[most] / double(way_.size());
    int crossings = 0;
    for (std::size_t i = 1; i < way_.size(); ++i)
      crossings += (way_[i][most] > mean) != (way_[i - 1][most] > mean);
    out.frequency = crossings / (2 * double(way_.size()) * sample_time);
  }

 private:
  const SimulatedDeviceParameters& device_;
  Pose from_;
  double radius_;  ///< m, of gyration
  double energy_ = 0;
  std::vector<Vec6> way_;
};

bool rests(const std::vector<double>& energies, double quiet) {
  const double last = energies.back();
  if (energies.size() < 2 || last > quiet) return false;
  return last <= std::max(energies[energies.size() - 2], next_to_nothing * quiet);
}

bool still_falls(const std::vector<double>& energies) {
  if (energies.size() <= looked_back) return true;
  return energies.back() < falls_to * energies[energies.size() - 1 - looked_back];
}

}  // namespace

RestReport press_until_rest(ClosedLoop& loop, const Press& press, const RestPatience& patience) {
  const double T = loop.setup().sample_time;
  const double quiet = quiet_energy(press, loop.setup().device);
  const std::int64_t first = first_window_of(press, T);
  const auto length = std::max<std::int64_t>(1, std::llround(press.window_time / T));
  RestReport out;
  std::int64_t tick = 0;
  const auto step = [&] {
    loop.step(press.X_FM, push_at(press, T, tick++));
    if (loop.haptic_loop().separation().status == Status::failed) ++out.failures;
  };
  loop.reset(press.X_FM);
  while (tick < first) step();
  std::vector<double> energies;
  for (;;) {
    Window window(loop.setup().device, loop.device().state());
    for (std::int64_t i = 0; i < length; ++i) {
      step();
      window.add(loop.device().state());
    }
    energies.push_back(window.energy());
    out.time = press.settle_time + double(tick - first) * T;
    out.kinetic = energies.back();
    out.at_rest = out.failures == 0 && rests(energies, quiet);
    const double most = still_falls(energies) ? patience.fades : patience.lasts;
    if (!out.at_rest && out.failures == 0 && out.time < most) continue;
    window.describe_swing(T, out);
    return out;
  }
}

}  // namespace sonde
