// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/chatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/study/parts/fourier.hpp"

namespace sonde {
namespace {

using Complex = std::complex<double>;
using Line = std::array<std::vector<double>, 3>;  // three coordinates over time
using Lines = std::array<std::vector<Complex>, 3>;

constexpr double sureness = 1.5;  // factor on a profile's mass, either way
constexpr FeltHandle::Range any_mass{0.02, 2}, any_inertia{5e-6, 5e-3};
constexpr std::size_t fewest_ticks = 64;
constexpr std::size_t half_peak = 2;  // bins: a Hann window's main lobe
constexpr double coherent = 0.5;      // least coherence of handle and force
constexpr double fed = 0.02;          // share of |D|: below it the motors do no significant work
constexpr double lasts = 0.6;         // share of the largest part: a time constant of 0.4 s or more
constexpr double even = 0.02;         // of the largest second difference of a position: none
constexpr double seen_even = 0.2;     // share of the ticks
constexpr double all_alike = 1.01;    // ratio of second differences
// Of a step: the saw teeth of a glide have an amplitude of 1/π of it, and what goes to and fro
// between two readings 2/π.
constexpr double above_steps = 0.5;
constexpr std::size_t parts = 5;  // each a third of the window, half of it new

double hann(std::size_t i, std::size_t n) {
  return 1 - elementary::cos(2 * std::numbers::pi * double(i) / double(n));
}

/// Second differences, which suppress a hand's slow motion before it leaks into high frequencies.
/// Applied to force and position alike, so that their ratio stays.
Line differences(std::span<const FeltTick> ticks, Eigen::Index row, const Vec6 FeltTick::*of) {
  Line out;
  for (Eigen::Index c = 0; c < 3; ++c)
    for (std::size_t i = 1; i + 1 < ticks.size(); ++i)
      out[static_cast<std::size_t>(c)].push_back(
          (ticks[i + 1].*of)[row + c] - 2 * (ticks[i].*of)[row + c] + (ticks[i - 1].*of)[row + c]);
  return out;
}

constexpr double rarely = 0.05;         // share of the ticks that may repeat a place
constexpr std::size_t most_missed = 3;  // ticks in a row

/// The ticks with the places that a device did not report: such a tick repeats the place before it,
/// and the next report has the way of both, which looks like a step. They are taken from between
/// the reports, where they are rare. A handle that rests, or an encoder's coarse steps, repeat
/// more.
std::vector<FeltTick> with_missed(std::span<const FeltTick> ticks) {
  std::vector<FeltTick> out(ticks.begin(), ticks.end());
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < out.size(); ++i) repeated += ticks[i].place == ticks[i - 1].place;
  if (double(repeated) > rarely * double(out.size())) return out;
  for (std::size_t i = 1; i < out.size();) {
    std::size_t end = i;
    while (end < out.size() && ticks[end].place == ticks[i - 1].place) ++end;
    const std::size_t missed = end - i;
    const bool goes_on =
        i > 1 && end < out.size() &&
        (ticks[end].place - ticks[i - 1].place).dot(ticks[i - 1].place - ticks[i - 2].place) > 0;
    if (missed > 0 && missed <= most_missed && goes_on)
      for (std::size_t m = i; m < end; ++m)
        out[m].place +=
            double(m - i + 1) / double(missed + 1) * (ticks[end].place - ticks[m].place);
    i = end + 1;
  }
  return out;
}

double square(double x) { return x * x; }

/// The size of the steps in which a position is read; 0 if it is not seen to be read in steps. What
/// moves slowly then goes evenly, or stands, in many ticks, and in others is off that by a step; at
/// half a step a tick it is so in every one.
double step_of(const Line& places) {
  const std::size_t count = places[0].size();
  std::vector<double> bends;
  for (std::size_t i = 0; i < count; ++i)
    bends.push_back(std::sqrt(square(places[0][i]) + square(places[1][i]) + square(places[2][i])));
  ordering::sort(bends.begin(), bends.end(), std::less<>());
  const auto first = std::ranges::lower_bound(bends, even * bends.back());
  const auto evenly = static_cast<std::size_t>(first - bends.begin());
  const bool alike = bends[9 * count / 10] <= all_alike * bends[count / 2];
  if (!(bends.back() > 0) || (double(evenly) < seen_even * double(count) && !alike)) return 0;
  return bends[evenly + (count - evenly) / 4];
}

/// The factor of second differences on an oscillation of amplitude 1.
double gain(double omega, double T) { return 2 - 2 * elementary::cos(omega * T); }

/// Of signals of one length: what depends on that alone is computed once.
class Spectra {
 public:
  explicit Spectra(std::size_t n) : transform_(n) {
    for (std::size_t i = 0; i < n; ++i) window_.push_back(hann(i, n));
  }

  Lines operator()(const Line& signal) const {
    Lines out;
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<double> windowed = signal[c];
      for (std::size_t i = 0; i < windowed.size(); ++i) windowed[i] *= window_[i];
      out[c] = transform_(windowed);
    }
    return out;
  }

 private:
  FourierTransform transform_;
  std::vector<double> window_;
};

/// The amplitude at omega in a part of the signal, with the effect of second differences removed.
double amplitude(const Line& signal, std::size_t from, std::size_t count, double omega, double T) {
  std::array<Complex, 3> at = {};
  for (std::size_t i = 0; i < count; ++i) {
    const double window = hann(i, count);
    const Complex turn = elementary::polar(1.0, -omega * T * double(i));
    for (std::size_t c = 0; c < 3; ++c) at[c] += window * signal[c][from + i] * turn;
  }
  double sum = 0;
  for (const Complex& each : at) sum += std::norm(each);
  return 2 * std::sqrt(sum) / double(count) / gain(omega, T);
}

/// Cross spectrum of force and position about the frequency of the largest oscillation of the
/// force.
struct Swing {
  double omega = 0;               // rad/s
  double places = 0, forces = 0;  // power
  Complex both = 0;
  double coherence() const { return std::norm(both) / (places * forces); }
  /// The dynamic stiffness, force over position, corrected for the lag.
  Complex stiffness(double lag) const {
    return both / places * elementary::polar(1.0, -omega * lag);
  }
};

Swing largest_swing(const Line& places, const Line& forces, double T) {
  const Spectra spectra(places[0].size());
  const Lines x = spectra(places), f = spectra(forces);
  const std::size_t n = x[0].size();
  const double bin = 2 * std::numbers::pi / (double(n) * T);
  const auto bin_of = [&](double hertz) { return 2 * std::numbers::pi * hertz / bin; };
  const auto power = [&](const Lines& of, std::size_t m) {
    return std::norm(of[0][m]) + std::norm(of[1][m]) + std::norm(of[2][m]);
  };
  const auto first = static_cast<std::size_t>(std::ceil(bin_of(slowest_chatter)));
  const auto last = static_cast<std::size_t>(std::min(bin_of(fastest_chatter), 0.45 * double(n)));
  Swing out;
  const auto own = [&](std::size_t m) { return power(f, m) / square(gain(bin * double(m), T)); };
  std::size_t peak = first;
  for (std::size_t m = first; m <= last; ++m)
    if (own(m) > own(peak)) peak = m;
  if (own(peak - 1) > own(peak)) return out;  // the flank of a slower oscillation
  double weighted = 0, weights = 0;
  for (std::size_t m = peak - half_peak; m <= std::min(peak + half_peak, n / 2); ++m) {
    out.places += power(x, m);
    out.forces += power(f, m);
    weighted += own(m) * bin * double(m);
    weights += own(m);
    for (std::size_t c = 0; c < 3; ++c) out.both += std::conj(x[c][m]) * f[c][m];
  }
  out.omega = weights > 0 ? weighted / weights : 0;
  return out;
}

/// Whether a handle of this inertia oscillates like this under this force and a passive hand.
bool by_the_loop(const Swing& swing, const FeltHandle::Range& inertia, double lag) {
  if (!(swing.places > 0 && swing.forces > 0) || swing.coherence() < coherent) return false;
  if (swing.omega < 2 * std::numbers::pi * slowest_chatter) return false;  // its flank alone
  const Complex D = swing.stiffness(lag);
  const double square = swing.omega * swing.omega;
  if (D.imag() < fed * elementary::size(D)) return false;
  return inertia.most * square + D.real() >= 0 &&
         inertia.least * square + D.real() <= elementary::size(D);
}

/// The smallest amplitude over the parts; 0 if the oscillation decays.
double lasting_amplitude(const Line& forces, double omega, double T) {
  const std::size_t count = forces[0].size() / 3;
  double least = 0, most = 0, last = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    last = amplitude(forces, i * count / 2, count, omega, T);
    least = i == 0 ? last : std::min(least, last);
    most = std::max(most, last);
  }
  return last >= lasts * most ? least : 0;
}

/// For three translations or three rotations; `arm` (m) converts rotations to translations.
Chatter chatter_of(std::span<const FeltTick> ticks, Eigen::Index row, double T,
                   const FeltHandle::Range& inertia, double lag, double arm) {
  const Line places = differences(ticks, row, &FeltTick::place);
  const Line forces = differences(ticks, row, &FeltTick::wrench);
  const Swing swing = largest_swing(places, forces, T);
  if (!by_the_loop(swing, inertia, lag)) return {};
  const double force = lasting_amplitude(forces, swing.omega, T);
  if (!(force > 0)) return {};
  const double place = force / elementary::size(swing.stiffness(lag));
  // An oscillation of over a quarter of the rate looks like steps itself: on a circle all second
  // differences are alike, and at a third of the rate some vanish.
  const bool may_be_steps = swing.omega * T < std::numbers::pi / 2;
  if (may_be_steps && place < above_steps * step_of(places)) return {};
  return {.force = force / arm,
          .frequency = swing.omega / (2 * std::numbers::pi),
          .acceleration = arm * place * swing.omega * swing.omega / std::numbers::sqrt2};
}

}  // namespace

FeltHandle felt_handle(double mass, double inertia, double lag) {
  const auto about = [](double known, const FeltHandle::Range& any) {
    return known > 0 ? FeltHandle::Range{known / sureness, known * sureness} : any;
  };
  return {about(mass, any_mass), about(inertia, any_inertia), lag};
}

FeltHandle felt_handle(const DeviceTraits& device, double sample_time) {
  FeltHandle out = felt_handle(device.mass, device.inertia, device.delay + sample_time / 2);
  const auto at_probe = [](FeltHandle::Range& range, double ratio) {
    range.least /= ratio * ratio;
    range.most /= ratio * ratio;
  };
  if (!(device.mass > 0) && device.ratio > 0) at_probe(out.mass, device.ratio);
  if (!(device.inertia > 0) && device.turn_ratio > 0) at_probe(out.inertia, device.turn_ratio);
  return out;
}

FeltTick felt_tick(const HandleState& state, const Wrench& motors, const Pose& from) {
  FeltTick out;
  out.place << state.X_WD.p - from.p, rotation_vector(state.X_WD.q * from.q.conjugate());
  out.wrench << motors.force, motors.torque;
  return out;
}

FeltHandle felt_handle(const ClosedLoopSetup& setup) {
  const SimulatedDeviceParameters& device = setup.device;
  return felt_handle(device.translation.inertia, device.rotation.inertia, -setup.sample_time / 2);
}

Chatter chatter(std::span<const FeltTick> ticks, double sample_time, const FeltHandle& handle,
                double length) {
  const auto wanted = static_cast<std::size_t>(std::llround(chatter_window / sample_time));
  if (ticks.size() > wanted) ticks = ticks.last(wanted);
  if (ticks.size() < std::max(fewest_ticks, wanted / 2)) return {};
  const std::vector<FeltTick> reported = with_missed(ticks);
  const Chatter sliding = chatter_of(reported, 0, sample_time, handle.mass, handle.lag, 1);
  if (!(length > 0)) return sliding;
  const Chatter turning = chatter_of(reported, 3, sample_time, handle.inertia, handle.lag, length);
  return turning.acceleration > sliding.acceleration ? turning : sliding;
}

}  // namespace sonde
