// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "tests/ui/views/viewport_fixture.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui::test {

/// The view alone, and sessions for what is done in it.
class SessionInView : public ViewportAloneTest {
 protected:
  void SetUp() override {
    ViewportAloneTest::SetUp();
    if (HasFatalFailure()) return;
    session = make_session(loaded());
  }
  /// Shown in the view too.
  std::unique_ptr<Session> make_session(LoadedScene scene) {
    scene.servo.real_time = false;
    show(scene);
    return std::make_unique<Session>(std::move(scene));
  }
  QImage drawn() { return view->picture(now, {.size = {640, 480}}); }
  std::unique_ptr<Session> session;
};

/// Pixels of about that hue, whatever light falls on them.
inline int pixels_of_hue(const QImage& image, const QColor& colour) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int hue = std::abs(pixel.hsvHue() - colour.hsvHue());
      count += std::min(hue, 360 - hue) < 12 && pixel.hsvSaturation() > 90 && pixel.value() > 60;
    }
  return count;
}

}  // namespace sonde::ui::test
