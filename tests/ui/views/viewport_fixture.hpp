// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <memory>
#include <utility>

#include "tests/support/shapes.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui::test {

/// The view alone, of 640 × 480 pixels: the fixed body is a cube of 100 mm about the origin, and
/// the probe one of 40 mm above it, free.
class ViewportAloneTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    darken();
    view = std::make_unique<Viewport>();
    view->resize(640, 480);
    view->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(view.get()));
    now.snapshot.separation.status = Status::separated;
    now.snapshot.separation.device.p = now.snapshot.separation.separated.p = Vec3(0, 0, 0.12);
    show(loaded());
  }
  static LoadedScene loaded() {
    LoadedScene out{.pair = Pair(cube(0.04), cube(0.1))};
    out.start.p = Vec3(0, 0, 0.12);
    return out;
  }
  static std::shared_ptr<const Body> cube(double side) {
    return sonde::test::body(sonde::test::box({side, side, side}));
  }
  void show(const LoadedScene& scene) {
    view->show_bodies(draw_bodies(scene));
    view->draw(now, 1);
  }
  /// From that side, with z up where it can be.
  void look_from(const Vec3& side) {
    const Vec3 up = std::abs(side.z()) > 0.9 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
    view->look({.position = side, .target = Vec3::Zero(), .up = up});
    view->draw(now, 1);
  }
  std::optional<Pick> pick_at(const Vec3& x) const { return view->pick(view->on_screen(x)); }

  std::unique_ptr<Viewport> view;
  Instant now{};
};

}  // namespace sonde::ui::test
