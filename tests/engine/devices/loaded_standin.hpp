// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <thread>

#include "engine/base/error.hpp"
#include "engine/devices/arm_reading.hpp"
#include "engine/devices/vendor_library.hpp"
#include "tests/engine/devices/standins/standin.hpp"

namespace sonde::test {

/// The controls of a stand-in, by its file. The first rule that was broken fails the test.
class LoadedStandin {
 public:
  explicit LoadedStandin(const char* file) {
    Standin* (*get)() = nullptr;
    VendorLibrary(file).bind(get, "standin");
    controls_ = get();
    reset();
  }
  ~LoadedStandin() {
    const char* const broken = controls_->broken;
    EXPECT_EQ(broken, nullptr) << broken;
    EXPECT_EQ(controls_->open, 0) << "left open";
    EXPECT_FALSE(controls_->force_on) << "left with its force on";
    reset();
  }
  LoadedStandin(const LoadedStandin&) = delete;
  LoadedStandin& operator=(const LoadedStandin&) = delete;
  Standin* operator->() const { return controls_; }

  void move_to(const Vec3& p) {
    for (int i = 0; i < 3; ++i) controls_->p[i] = p[i];
  }
  Vec3 force() const { return {controls_->force[0], controls_->force[1], controls_->force[2]}; }
  Vec3 torque() const { return {controls_->torque[0], controls_->torque[1], controls_->torque[2]}; }

 private:
  /// As it was loaded: a test may run in one process with others.
  void reset() {
    controls_->arms = 1;
    controls_->major = 3;
    controls_->minor = 14;
    controls_->angle = 0;
    controls_->axis = 2;
    for (auto* flag : {&controls_->nan, &controls_->skewed, &controls_->frozen,
                       &controls_->unplugged, &controls_->uncalibrated})
      *flag = false;
    controls_->fault = 0;
    controls_->buttons = 0;
    controls_->model = 104;
    controls_->frames = 0;
    controls_->opened = 0;
    controls_->broken = nullptr;
    move_to(Vec3::Zero());
  }

  Standin* controls_ = nullptr;
};

/// What is complained of; empty where nothing is.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The first of its kind that an arm says; gives up after a long while.
template <class Arm>
ArmReading awaited(Arm& arm, ArmReading::Kind kind) {
  ArmReading reading;
  for (int i = 0; i < 20000; ++i)
    if (reading = arm.read(); reading.kind == kind) return reading;
  ADD_FAILURE() << "it never says that";
  return reading;
}

}  // namespace sonde::test
