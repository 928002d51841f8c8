// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {

/// The cubes in contact, and nothing moves.
class SeeingTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    activate();
    settle();
    window->set_paused(true);
    settle();
  }
  /// The overlays of the bodies would be counted as bodies.
  void hide_overlays() {
    for (const Layer layer : {Layer::ghost, Layer::screw, Layer::contacts, Layer::wrench})
      window->viewport().set_shown(layer, false);
  }
  const CutPlane& cut() { return window->viewport().seeing().cut; }
  void click(QPointF at) {
    send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, {});
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, {});
  }
};

}  // namespace sonde::ui::test
