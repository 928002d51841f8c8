// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "engine/study/identification/identification.hpp"

namespace sonde::test {

/// Within a twentieth of the value that the device is simulated from.
inline void expect_near(const Estimate& found, const ProfileValue& truth, const char* name) {
  EXPECT_NEAR(found.value, truth.value, 0.05 * truth.value) << name;
}

}  // namespace sonde::test
