// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: closed forms of steps, ramps and sines.
#include "engine/study/rendering/smoothness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace sonde {
namespace {

constexpr double rate = 1024;  // Hz: the frequencies of the spectrum are whole numbers, two apart

std::vector<Vec3> signal(std::size_t samples, const std::function<Vec3(double t)>& at) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < samples; ++i) out.push_back(at(static_cast<double>(i) / rate));
  return out;
}

double sine(double frequency, double t) { return std::sin(2 * std::numbers::pi * frequency * t); }

double total(const Spectrum& spectrum) {
  double sum = 0;
  for (const double power : spectrum.power) sum += power;
  return sum;
}

TEST(Smoothness, the_variation_of_a_step_is_its_height_and_of_a_rise_and_fall_twice) {
  const std::vector<Vec3> step{Vec3::Zero(), Vec3::Zero(), Vec3(3, 4, 0), Vec3(3, 4, 0)};
  EXPECT_EQ(total_variation(step), 5);
  const auto hill =
      signal(2001, [](double t) { return Vec3(0, 2 * (1 - std::abs(1 - 1.024 * t)), 0); });
  EXPECT_NEAR(total_variation(hill), 4, 1e-12);
  EXPECT_EQ(total_variation({}), 0);
  EXPECT_EQ(total_variation(std::vector<Vec3>{Vec3(1, 1, 1)}), 0);
}

TEST(Smoothness, the_variation_of_a_sine_is_four_amplitudes_a_period) {
  const auto x = signal(1025, [](double t) { return Vec3(0.5 * sine(8, t), 0, 0); });
  EXPECT_NEAR(total_variation(x), 8 * 4 * 0.5, 1e-9);
}

TEST(Smoothness, a_sine_has_its_power_at_its_frequency) {
  for (const double frequency : {10.0, 50.0, 120.0, 400.0}) {
    const auto x = signal(3000, [&](double t) { return Vec3(0, 0, 0.3 * sine(frequency, t)); });
    const Spectrum s = spectrum(x, rate);
    ASSERT_EQ(s.frequency.size(), 256u);
    EXPECT_EQ(s.frequency[0], 2);
    EXPECT_EQ(s.frequency.back(), rate / 2);
    EXPECT_NEAR(total(s), 0.3 * 0.3 / 2, 1e-6) << frequency;
    const auto at = static_cast<std::size_t>(frequency / 2) - 1;
    EXPECT_NEAR(s.power[at] / total(s), 2.0 / 3, 1e-6) << frequency;
    EXPECT_NEAR(s.power[at - 1] / total(s), 1.0 / 6, 1e-6) << frequency;
    EXPECT_NEAR(s.power[at + 1] / total(s), 1.0 / 6, 1e-6) << frequency;
  }
}

TEST(Smoothness, powers_of_components_and_frequencies_add) {
  const auto x =
      signal(4096, [](double t) { return Vec3(2 * sine(20, t), sine(200, t), sine(300, t) + 7); });
  const Spectrum s = spectrum(x, rate);
  EXPECT_NEAR(total(s), 4.0 / 2 + 1.0 / 2 + 1.0 / 2, 1e-6);
  EXPECT_NEAR(*share_above(s, 50), 1.0 / 3, 1e-6);
  EXPECT_NEAR(*share_above(s, 250), 1.0 / 6, 1e-6);
  EXPECT_NEAR(*share_above(s, 1), 1, 1e-12);
}

TEST(Smoothness, a_constant_has_no_power_and_no_share) {
  const Spectrum s = spectrum(std::vector<Vec3>(2000, Vec3(1, 2, 4)), rate);
  EXPECT_EQ(total(s), 0);
  EXPECT_FALSE(share_above(s, 50));
  EXPECT_FALSE(share_above(spectrum(std::vector<Vec3>(3, Vec3(1, 2, 3)), rate), 50));
  const auto slow = signal(100, [](double t) { return Vec3(t, 0, 0); });
  EXPECT_FALSE(share_above(spectrum(slow, 90), 50)) << "45 Hz is the highest frequency";
}

TEST(Smoothness, what_trembles_has_a_larger_share_than_what_does_not) {
  const auto press = [](double t) { return 2 * std::pow(sine(0.2, t), 2); };
  const auto smooth = signal(5000, [&](double t) { return Vec3(0, 0, press(t)); });
  const auto trembling =
      signal(5000, [&](double t) { return Vec3(0, 0, press(t) + 0.05 * sine(180, t)); });
  // 0.05²/2 of about 0.4 N² that the press varies by: thousands of times what the press leaves
  // there.
  EXPECT_GT(*share_above(spectrum(trembling, rate), 50), 1e-3);
  EXPECT_LT(*share_above(spectrum(smooth, rate), 50), 1e-6);
}

TEST(Smoothness, short_signals_are_one_piece) {
  const auto x = signal(64, [](double t) { return Vec3(sine(64, t), 0, 0); });
  const Spectrum s = spectrum(x, rate);
  ASSERT_EQ(s.frequency.size(), 32u);
  EXPECT_NEAR(total(s), 0.5, 1e-9);
}

TEST(Smoothness, only_even_times_have_a_rate) {
  EXPECT_NEAR(*sample_rate(std::vector<double>{1, 1.001, 1.002, 1.003}), 1000, 1e-6);
  EXPECT_FALSE(sample_rate(std::vector<double>{1, 1.001, 1.003}));
  EXPECT_FALSE(sample_rate(std::vector<double>{1}));
}

}  // namespace
}  // namespace sonde
