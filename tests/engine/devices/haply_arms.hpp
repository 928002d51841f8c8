// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/devices/haply_arm.hpp"
#include "tests/engine/devices/haply_standin.hpp"
#include "tests/engine/devices/loaded_standin.hpp"

namespace sonde::test {

/// Tests of arms over a stand-in for Haply's service.
struct HaplyArms : testing::Test {
  HaplyStandin standin;
  ~HaplyArms() override { EXPECT_EQ(standin.broken(), ""); }

  /// A second pose from now: what was written has reached the service.
  static void exchange(HaplyArm& arm) {
    for (int i = 0; i < 2; ++i) awaited(arm, ArmReading::Kind::pose);
  }
  /// The first reading that says these words.
  static ArmReading until_said(HaplyArm& arm, const std::string& words) {
    for (int i = 0; i < 20000; ++i)
      if (ArmReading reading = arm.read(); reading.words.find(words) != std::string::npos)
        return reading;
    ADD_FAILURE() << "it never says " << words;
    return {};
  }
};

}  // namespace sonde::test
