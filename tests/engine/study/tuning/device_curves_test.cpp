// SPDX-License-Identifier: GPL-3.0-or-later
// References: a wall sampled, held and late, over a motion in closed form, whose force is
// integrated here; the condition of Colgate and Schenkel with delay; eigenvalues beside the lines.
#include "engine/study/tuning/device_curves.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/engine/study/tuning/tuning_requests.hpp"

namespace sonde {
namespace {

constexpr double pi = std::numbers::pi;

/// Fundamental of the motors' force over the velocity's, for x = sin ωt, over one common period.
std::complex<double> measured(const SampledAxis& axis, double K, int swings, int samples) {
  const double T = axis.sample_time, omega = 2 * pi * swings / (samples * T);
  const auto at = [&](int k) { return std::sin(omega * k * T); };
  std::complex<double> sum = 0;
  constexpr int fine = 400;
  for (int i = 0; i < samples * fine; ++i) {
    const double t = (i + 0.5) * T / fine;
    const int k = int(std::floor((t - axis.delay) / T));
    const double f = K * at(k) + axis.virtual_damping * (at(k) - at(k - 1)) / T;
    sum += f * std::polar(1.0, -omega * t);
  }
  const std::complex<double> force = sum * 2.0 / double(samples * fine);
  const std::complex<double> velocity =
      std::complex<double>(0, -1) * std::complex<double>(0, omega);
  return force / velocity;
}

TEST(DeviceCurves, the_rendered_impedance_is_that_of_the_sampled_wall) {
  for (const double delay : {0.0, 1e-3, 1.7e-3})
    for (const double damping : {0.0, 4.0})
      for (const int swings : {1, 7, 40, 90}) {
        const SampledAxis axis{0.3, 2, damping, 1e-3, delay};
        const double omega = 2 * pi * swings / 0.2;
        const auto want = rendered_impedance(axis, 500, omega);
        EXPECT_LT(std::abs(measured(axis, 500, swings, 200) - want), 1e-2 * std::abs(want))
            << delay << ' ' << damping << ' ' << swings;
      }
}

TEST(DeviceCurves, slow_motion_meets_the_wall_that_is_wanted) {
  const SampledAxis axis{0.3, 2, 4, 1e-3, 1e-3};
  const auto wanted = wanted_impedance(500, 4, 1), rendered = rendered_impedance(axis, 500, 1);
  EXPECT_LT(std::abs(wanted - rendered), 5e-3 * std::abs(wanted));
  // The lag takes K (T/2 + t_d) of the damping away.
  EXPECT_NEAR(rendered.real(), 4 - 500 * 1.5e-3, 0.01);
}

TEST(DeviceCurves, the_lines_are_where_eigenvalues_and_passivity_say) {
  const SampledAxis axis{0.3, 2, 0, 1e-3, 1e-3};
  const auto width = z_width(axis, 30);
  ASSERT_GT(width.size(), 10u);
  EXPECT_EQ(width.front().damping, 0);
  EXPECT_NEAR(width.front().passive, 2 / 1.5e-3, 1e-9);
  for (const ZWidthPoint& p : width) {
    SampledAxis at = axis;
    at.virtual_damping = p.damping;
    EXPECT_LE(p.passive, p.stable);
    if (!(p.stable > 0)) continue;
    EXPECT_LE(spectral_radius(at, 0.999 * p.stable), 1) << p.damping;
    EXPECT_GT(spectral_radius(at, 1.01 * p.stable), 1) << p.damping;
  }
}

TEST(DeviceCurves, slopes_are_those_of_the_closed_form) {
  const SampledAxis axis{0.3, 2, 0, 1e-3, 1e-3};
  for (const LimitAt& l : limits_by_delay(axis))
    EXPECT_NEAR(l.slope, -l.value / (l.value + 0.5e-3), 1e-5);
  for (const LimitAt& l : limits_by_rate(axis))
    EXPECT_NEAR(l.slope, 0.5 / l.value / (0.5 / l.value + 1e-3), 1e-5);
  for (const LimitAt& l : limits_by_hand_damping(axis))
    EXPECT_NEAR(l.passive, (2 + l.value) / 1.5e-3, 1e-6 * l.passive);
  const auto by_step = limits_by_step(axis, 2e-6, 0.4);
  EXPECT_NEAR(by_step.front().passive, 2 / 1.5e-3, 1e-9) << "friction keeps small steps quiet";
  EXPECT_NEAR(by_step.back().passive, std::min(2 / 1.5e-3, 2 * 0.4 / 2e-4), 1e-6);
}

TEST(DeviceCurves, are_files_of_a_study) {
  TuningRequest request = test::pressed_boxes();
  request.device.mass.assumed = false;
  const auto files = device_curve_files(test::tuned(request));
  std::vector<std::string> names;
  for (const StudyFile& file : files) names.push_back(file.name);
  EXPECT_THAT(names, testing::ElementsAre("z_width.csv", "z_width.svg", "limits.csv", "limits.svg",
                                          "impedance.csv", "impedance.svg", "hardness.csv",
                                          "hardness.svg"));
  EXPECT_THAT(files[1].text, testing::HasSubstr("object norm, stable"));
  EXPECT_THAT(files[2].text, testing::HasSubstr("translation,delay,"));
}

}  // namespace
}  // namespace sonde
