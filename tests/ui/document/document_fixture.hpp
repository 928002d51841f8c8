// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/document/pose_text.hpp"

namespace sonde::ui::test {

/// A window with the scene of two cubes as its document.
class DocumentTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    activate();
  }
  Document& document() { return window->documents().document(); }
  Pose pose() { return window->session()->device_pose(); }
  testing::AssertionResult comes_to(const Pose& wanted) {
    const bool there = wait_until([&] {
      return (pose().p - wanted.p).norm() < 1e-12 && pose().q.angularDistance(wanted.q) < 1e-12 &&
             window->shown() && (shown().separation.device.p - wanted.p).norm() < 1e-12;
    });
    if (there) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "it is at " << pose_text(pose()) << "and was to be at " << pose_text(wanted);
  }
};

}  // namespace sonde::ui::test
