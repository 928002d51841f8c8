// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gap_painter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/actions/session_fixture.hpp"
#include "ui/views/gap_view.hpp"

namespace sonde::ui::test {
namespace {

/// The probe, hidden, stands on the upper side of the fixed body.
class GapPainterTest : public SessionInView {
 protected:
  void SetUp() override {
    SessionInView::SetUp();
    if (HasFatalFailure()) return;
    for (const Layer layer : {Layer::hint, Layer::grid, Layer::ghost, Layer::handles})
      view->set_shown(layer, false);
    Seeing seeing;
    seeing.probe = Look::hidden;
    view->set_seeing(seeing);
    look_from_above();
    painter = std::make_unique<GapPainter>(*view);
    painter->attach(session.get());
    separation.status = Status::penetrating;
    stand_at(0);
  }
  void TearDown() override { painter.reset(); }
  void look_from_above() {
    view->look({.position = {0, 0, 0.4}, .target = Vec3::Zero(), .up = Vec3::UnitY()});
  }
  void stand_at(double x) {
    separation.separated.p = Vec3(x, 0, 0.07);
    now.snapshot.separation.separated = separation.separated;
  }
  int touched() { return pixels_of_hue(drawn(), gap_colour(0)); }
  /// Frames until that holds.
  bool comes(const std::function<bool()>& holds) {
    return wait_until([&] {
      painter->frame(separation);
      return holds();
    });
  }
  /// The middle of what is painted as a touch, in pixels from the left.
  double painted_at() {
    const QImage image = drawn();
    double sum = 0, count = 0;
    for (int x = 0; x < image.width(); ++x) {
      const int pixels = pixels_of_hue(image.copy(x, 0, 1, image.height()), gap_colour(0));
      sum += double(x) * pixels;
      count += pixels;
    }
    return count > 0 ? sum / count : -1;
  }
  std::unique_ptr<GapPainter> painter;
  Separation separation;
};

TEST_F(GapPainterTest, paints_where_the_probe_touches_while_it_is_on) {
  const int before = touched();
  painter->frame(separation);
  EXPECT_FALSE(painter->on());
  painter->set_on(true);
  EXPECT_TRUE(painter->on());
  ASSERT_TRUE(comes([&] { return touched() > before + 1500; }));

  painter->set_on(false);
  EXPECT_LE(touched(), before + 20);
}

TEST_F(GapPainterTest, follows_the_separated_probe) {
  painter->set_on(true);
  ASSERT_TRUE(comes([&] { return touched() > 1500; }));
  const double first = painted_at();
  const int count = touched();
  stand_at(0.02);
  EXPECT_TRUE(comes([&] { return std::abs(painted_at() - first) > 20 && touched() > count / 2; }));
}

TEST_F(GapPainterTest, a_failed_separation_leaves_the_last_colours) {
  painter->set_on(true);
  ASSERT_TRUE(comes([&] { return touched() > 1500; }));
  const QImage before = drawn();
  separation.status = Status::failed;
  separation.separated.p = Vec3(0.04, 0.04, 0.07);
  for (int i = 0; i < 10; ++i) {
    painter->frame(separation);
    wait(20);
  }
  EXPECT_LT(pixels_between(before, drawn()), 20);
}

TEST_F(GapPainterTest, a_reach_that_was_asked_for_is_painted_at_once) {
  painter->set_on(true);
  ASSERT_TRUE(comes([&] { return touched() > 1500; }));
  const QImage suited = drawn();
  painter->set_reach(0.05);
  // Far more of the body is near then, also beside the probe.
  EXPECT_TRUE(comes([&] { return pixels_between(suited, drawn()) > 2000; }));
  painter->set_reach(std::nullopt);
  EXPECT_TRUE(comes([&] { return pixels_between(suited, drawn()) < 200; })) << "as at first";
}

TEST_F(GapPainterTest, the_scale_fits_the_clearance_and_stays_until_it_is_switched_on_again) {
  separation.status = Status::separated;
  const auto hang_at = [&](double gap) { separation.separated.p = Vec3(0, 0, 0.07 + gap); };
  const auto shows = [&](double part) {
    return comes([&] { return pixels_of_hue(drawn(), gap_colour(part)) > 1500; });
  };
  hang_at(1e-4);
  painter->set_on(true);
  EXPECT_TRUE(shows(0.2)) << "of 0.5 mm, not of the 2 mm that suit the probe";
  hang_at(3.5e-4);
  EXPECT_TRUE(shows(0.7)) << "the same scale";
  painter->set_on(false);
  painter->set_on(true);
  EXPECT_TRUE(shows(0.175)) << "of 2 mm";
  painter->set_reach(5e-4);
  EXPECT_TRUE(shows(0.7));
  painter->set_on(false);
  painter->set_on(true);
  EXPECT_TRUE(shows(0.7)) << "what was set stays";
}

/// While the first bodies are still being looked at.
TEST_F(GapPainterTest, other_bodies_or_none_take_over_at_any_time) {
  painter->set_on(true);
  painter->frame(separation);
  painter->attach(nullptr);
  session.reset();
  painter->frame(separation);
  LoadedScene other{.pair = Pair(cube(0.04), cube(0.1))};
  other.start.p = Vec3(0, 0, 0.2);
  session = make_session(other);
  Seeing seeing;
  seeing.probe = Look::hidden;
  view->set_seeing(seeing);
  look_from_above();
  EXPECT_LT(touched(), 300) << "the legend alone";
  painter->attach(session.get());
  EXPECT_TRUE(comes([&] { return touched() > 1500; })) << "at the same pose too";
}

}  // namespace
}  // namespace sonde::ui::test
