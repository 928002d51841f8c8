// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that identify() refuses, whole or in part. References: the truth of true_handle.hpp.
#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/error.hpp"
#include "engine/study/identification/identification.hpp"
#include "tests/engine/study/identification/plan_along.hpp"
#include "tests/engine/study/identification/true_handle.hpp"

namespace sonde {
namespace {

using test::device_of_mass;
using test::plan_along;
using test::TrueHandle;
using testing::HasSubstr;

/// Why the recording tells nothing.
std::string identifying_complaint(const Response& response) {
  try {
    identify(response);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class Refused : public testing::Test {
 protected:
  const TrueHandle truth{0.1, 0.4, 0.1, 1e-3, 3e-5};
  const PulsePlan plan = plan_along(0, device_of_mass(0.1));
};

TEST_F(Refused, a_handle_that_does_not_move) {
  EXPECT_THAT(identifying_complaint(test::answer({0.1, 0.4, 3, 1e-3, 3e-5}, plan, 0)),
              HasSubstr("force along x: the handle did not move under pulses of up to 2 N"));
  EXPECT_THAT(identifying_complaint(test::answer({0.1, 0.4, 0.1, 1e-3, 1e-3}, plan, 0)),
              HasSubstr("20 steps of its encoder"));
}

TEST_F(Refused, too_few_and_too_short_pulses) {
  PulsePlan few = plan;
  few.pulses.resize(6);
  EXPECT_THAT(identifying_complaint(test::answer(truth, few, 0)),
              HasSubstr("6 pulses; it takes 8"));
  PulsePlan brief = plan;
  for (Pulse& pulse : brief.pulses) pulse.part = 4;
  EXPECT_THAT(identifying_complaint(test::answer(truth, brief, 0)),
              HasSubstr("t = 0.25 s has 16 samples; it takes 20"));
}

TEST_F(Refused, one_amplitude) {
  PulsePlan same = plan;
  for (Pulse& pulse : same.pulses) pulse.amplitude = std::copysign(2.0, pulse.amplitude);
  EXPECT_THAT(identifying_complaint(test::answer(truth, same, 0)),
              HasSubstr("friction and damping are told"));
}

TEST_F(Refused, noise_as_large_as_the_motion) {
  EXPECT_THAT(identifying_complaint(test::answer(truth, plan, 0, 1, 0.01)),
              HasSubstr("beyond its noise"));
}

TEST_F(Refused, a_hand_that_holds_the_handle) {
  TrueHandle held = truth;
  held.hand = 300;
  EXPECT_THAT(identifying_complaint(test::answer(held, plan, 0)), HasSubstr("Was it held"));
}

/// The recording without `count` samples about the change of sign before the last part of so many
/// pulses, the first ones.
Response with_gaps(const Response& response, const PulsePlan& plan, std::size_t pulses,
                   std::ptrdiff_t count) {
  std::vector<std::size_t> changes;
  std::size_t begin = plan.rest;
  for (const Pulse& pulse : plan.pulses) {
    changes.push_back(begin + 3 * pulse.part);
    begin += 4 * pulse.part + plan.rest;
  }
  Response out = response;
  for (std::size_t k = pulses; k-- > 0;) {
    const auto from = out.begin() + static_cast<std::ptrdiff_t>(changes[k]) - count / 2;
    out.erase(from, from + count);
  }
  return out;
}

TEST_F(Refused, samples_that_are_missing_in_all_but_a_few_pulses) {
  const Response response = test::answer(truth, plan, 0);
  const std::size_t pulses = plan.pulses.size();
  ASSERT_GE(pulses, 12u);
  EXPECT_THAT(identifying_complaint(with_gaps(response, plan, pulses - 7, 5)),
              HasSubstr("no sample for 6 ms before t = "));
  // Other ticks were late: these pulses are left out. Longer gaps cut a pulse in two. What was
  // commanded in a gap is not known, and nothing stops a handle without friction.
  TrueHandle smooth = truth;
  smooth.friction = 0;
  for (const TrueHandle& handle : {truth, smooth})
    for (const std::ptrdiff_t missing : {5, 30}) {
      const Identification found =
          identify(with_gaps(test::answer(handle, plan, 0), plan, 4, missing));
      ASSERT_EQ(found.axes.size(), 1u);
      EXPECT_EQ(found.axes[0].pulses, pulses - 4);
      EXPECT_EQ(found.axes[0].with_gaps, 4u);
      EXPECT_NEAR(found.translation->inertia.value, 0.1, 0.01 * 0.1) << missing;
      EXPECT_NEAR(found.translation->damping.value, 0.4, 0.05 * 0.4) << missing;
    }
}

// A logger that holds the last pose where it got none: the times are even, the poses are not.
TEST_F(Refused, poses_that_are_told_twice_in_all_but_a_few_pulses) {
  Response response = test::answer(truth, plan, 0);
  for (std::size_t k = 6; k < response.size(); k += 7) response[k].X_BH = response[k - 1].X_BH;
  EXPECT_THAT(identifying_complaint(response),
              testing::AllOf(HasSubstr("repeats the one before, while the handle moves"),
                             HasSubstr("0 are whole")));
}

TEST_F(Refused, two_axes_at_once) {
  Response response = test::answer(truth, plan, 0);
  for (ResponseSample& s : response) s.command.force.y() = 0.5 * s.command.force.x();
  EXPECT_THAT(identifying_complaint(response),
              HasSubstr("another axis is commanded too at t = 0.25 s"));
}

TEST_F(Refused, a_recording_without_commands) {
  Response response = test::answer(truth, plan, 0);
  for (ResponseSample& s : response) s.command = {};
  EXPECT_THAT(identifying_complaint(response), HasSubstr("no pulse in the recording"));
  EXPECT_THAT(identifying_complaint({}), HasSubstr("no samples"));
  response.resize(1);
  EXPECT_THAT(identifying_complaint(response), HasSubstr("a single sample"));
}

TEST_F(Refused, an_axis_beside_one_that_tells) {
  Response response = test::answer(truth, plan, 0);
  const double later = response.back().t + 1e-3;
  for (ResponseSample s :
       test::answer({0.1, 0.4, 3, 1e-3, 3e-5}, plan_along(1, device_of_mass(0.1)), 1)) {
    s.t += later;
    s.X_BH.p.x() = response.back().X_BH.p.x();
    response.push_back(s);
  }
  const Identification found = identify(response);
  ASSERT_EQ(found.refused.size(), 1u);
  EXPECT_EQ(found.refused[0].axis, 1u);
  EXPECT_THAT(found.refused[0].reason, HasSubstr("did not move"));
}

}  // namespace
}  // namespace sonde
