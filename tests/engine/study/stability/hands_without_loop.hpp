// SPDX-License-Identifier: GPL-3.0-or-later
// Hands that move a probe, and the force that follows: no force moves anything, so nothing buzzes.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/geometry/random.hpp"
#include "engine/study/stability/chatter.hpp"

namespace sonde::test {

/// The way that a hand makes along one axis, m, over time, s.
using HandWay = std::function<double(double)>;

/// A kind of hand, drawn at random; the way is into a wall at 0.
struct HandKind {
  const char* name;
  HandWay (*draw)(Random&);
  bool tried = true;  ///< whether the detector's rules for an encoder's steps were tried on it
};

namespace hands {

constexpr double turn = 2 * std::numbers::pi;

inline HandWay tremor(Random& random, double least_hertz, double most_hertz, double most) {
  const double hertz = random.uniform(least_hertz, most_hertz), at = random.uniform(0, turn);
  const double size = most * std::pow(random.uniform(0.1, 1), 2);
  const double swells = random.uniform(0.3, 1.5);
  return [=](double t) {
    return size * (1 + 0.3 * std::sin(turn * swells * t)) * std::sin(turn * hertz * t + at);
  };
}
inline HandWay sum(HandWay a, HandWay b) {
  return [a = std::move(a), b = std::move(b)](double t) { return a(t) + b(t); };
}
inline HandWay glide(Random& random) {
  const double speed = std::exp(random.uniform(std::log(2e-4), std::log(0.05)));
  const double start = random.uniform(0, 1e-3);
  return [=](double t) { return start + speed * t; };
}
inline HandWay reach(Random& random) {
  const double way = random.uniform(1e-3, 0.04), lasts = random.uniform(0.2, 1.2);
  const double begins = random.uniform(0, 0.6);
  return [=](double t) {
    const double s = std::clamp((t - begins) / lasts, 0.0, 1.0);
    return way * s * s * s * (10 + s * (6 * s - 15));  // of least jerk
  };
}
inline HandWay steps(Random& random) {
  const double size = random.uniform(1e-4, 3e-3), rate = random.uniform(2, 150);
  return [=](double t) { return size * std::floor(rate * t); };
}
inline HandWay taps(Random& random) {
  const double size = random.uniform(1e-3, 6e-3), hertz = random.uniform(1, 7);
  return [=](double t) { return size * std::sin(turn * hertz * t); };
}
inline HandWay rest(Random& random) {
  const double depth = random.uniform(1e-3, 8e-3), drift = random.uniform(-1e-4, 1e-4);
  return [=](double t) { return depth + drift * t; };
}

inline HandWay strokes(Random& random) {
  const double size = random.uniform(5e-4, 1e-2), rate = random.uniform(0.3, 3);
  return [=](double t) { return size * std::abs(2 * (rate * t - std::floor(rate * t)) - 1); };
}
inline HandWay fades(Random& random) {
  const double size = random.uniform(2e-4, 4e-3), hertz = random.uniform(2, 12);
  const double depth = random.uniform(0, 5e-3), lasts = random.uniform(0.1, 1);
  return [=](double t) { return depth + size * std::exp(-t / lasts) * std::sin(turn * hertz * t); };
}
inline HandWay slips(Random& random) {
  const double speed = random.uniform(1e-3, 0.03), every = random.uniform(0.1, 0.4);
  const double back = random.uniform(0.2, 1);
  return [=](double t) { return speed * (t - back * every * std::floor(t / every)); };
}

}  // namespace hands

inline const HandKind hand_kinds[] = {
    {"a glide", [](Random& r) { return hands::glide(r); }},
    {"a slow drift with a tremor",
     [](Random& r) { return hands::sum(hands::rest(r), hands::tremor(r, 8, 18, 3e-4)); }},
    {"a tremor that presses",
     [](Random& r) { return hands::sum(hands::rest(r), hands::tremor(r, 8, 18, 1e-3)); }},
    {"a glide with a tremor",
     [](Random& r) { return hands::sum(hands::glide(r), hands::tremor(r, 8, 18, 5e-4)); }},
    {"steps", [](Random& r) { return hands::steps(r); }},
    {"a reach", [](Random& r) { return hands::reach(r); }},
    {"taps with a tremor",
     [](Random& r) { return hands::sum(hands::taps(r), hands::tremor(r, 8, 18, 3e-4)); }},
    {"a reach with a tremor",
     [](Random& r) { return hands::sum(hands::reach(r), hands::tremor(r, 13, 18, 5e-4)); }},
    {"strokes to and fro", [](Random& r) { return hands::strokes(r); }, false},
    {"a push that fades", [](Random& r) { return hands::fades(r); }, false},
    {"slips", [](Random& r) { return hands::slips(r); }, false},
};

/// What holds the handle, and what it is pressed into.
struct HandSetting {
  double step = 0;       ///< m, of the encoder; 0: exact
  double stiffness = 0;  ///< N/m
  double softer = 1;     ///< factor on it from `changes` on: another contact
  double changes = 0;    ///< s
  double mass = 0;       ///< kg; 0: unknown
};

inline HandSetting draw_setting(Random& random) {
  constexpr double encoders[] = {0, 1e-6, 5e-6, 2e-5, 5.5e-5, 1e-4};
  constexpr double masses[] = {0.05, 0.1, 0.16, 0.25, 0.3, 0.35, 0};
  const auto one_of = [&](const auto& values) {
    const auto count = static_cast<double>(std::size(values));
    return values[static_cast<std::size_t>(random.uniform(0, count - 1e-9))];
  };
  return {.step = one_of(encoders),
          .stiffness = std::exp(random.uniform(std::log(100), std::log(8000))),
          .softer = random.uniform(0, 1) < 0.25 ? random.uniform(0.3, 3) : 1,
          .changes = random.uniform(0, 1.2),
          .mass = one_of(masses)};
}

/// The ticks of such a hand, of `tick` s.
inline std::vector<FeltTick> without_loop(const HandWay& way, const HandSetting& setting,
                                          double tick, double seconds) {
  std::vector<FeltTick> out;
  for (int i = 0; i < int(seconds / tick); ++i) {
    const double x = way(i * tick);
    const double read = setting.step > 0 ? setting.step * std::round(x / setting.step) : x;
    const double k = setting.stiffness * (i * tick < setting.changes ? 1 : setting.softer);
    FeltTick felt;
    felt.place.setZero();
    felt.wrench.setZero();
    felt.place[2] = read;
    felt.wrench[2] = -k * std::max(0.0, read);
    out.push_back(felt);
  }
  return out;
}

}  // namespace sonde::test
