// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/readout_panel.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QLabel>

#include "tests/support/shapes.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// The dock alone, of two cubes of 40 mm.
class ReadoutPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<ReadoutPanel>();
    const auto cube = sonde::test::body(sonde::test::box({0.04, 0.04, 0.04}));
    panel->take(Pair(cube, cube));
    snapshot.separation.status = Status::penetrating;
    snapshot.hand.share = 1;
  }
  QString text(const char* name) const { return panel->findChild<QLabel*>(name)->text(); }

  std::unique_ptr<ReadoutPanel> panel;
  Snapshot snapshot;
};

TEST_F(ReadoutPanelTest, a_motion_is_split_into_what_moves_and_what_turns) {
  Separation& separation = snapshot.separation;
  separation.sigma = 25e-6;  // √σ = 5 mm = √(4² + 3²) mm
  separation.depth = 5e-3;
  separation.translation = 4e-3;
  separation.rotation = 3e-3;
  separation.separated.p = Vec3(0, 0, 4e-3);
  separation.separated.q = Quat(Eigen::AngleAxisd(std::acos(0.0) / 3, Vec3::UnitX()));
  separation.clusters.size = 2;
  panel->show_numbers({snapshot, {}});
  EXPECT_TRUE(text("depth_value").contains("5.000 mm</span> deep"))
      << text("depth_value").toStdString();
  EXPECT_EQ(text("translation_value"), "4.000 mm (64 %)");
  EXPECT_EQ(text("rotation_value"), "30.0°, 3.000 mm (36 %)");
  EXPECT_EQ(text("contacts_value"), "2");
  EXPECT_EQ(text("nearest_value"), "…") << "not searched yet";
}

/// As in the picture, where the arrow tells which way along the axis.
TEST_F(ReadoutPanelTest, a_slide_against_the_turn_is_a_length_like_any_other) {
  const Quat turn(Eigen::AngleAxisd(0.2, Vec3::UnitZ()));
  snapshot.separation.separated = {turn, Vec3(0, 0, -0.003)};  // the centre of mass is the origin
  panel->show_numbers({snapshot, {}});
  EXPECT_TRUE(text("screw_value").endsWith("slide 3.000 mm")) << text("screw_value").toStdString();
}

/// Straight along x, with a turn of 4e-6 degrees that only rounding made: about z, by the formula,
/// the axis is 85 km away and nothing slides along it. Reference: the way, 6 mm.
TEST_F(ReadoutPanelTest, a_screw_about_an_axis_out_of_reach_is_a_slide) {
  snapshot.separation.separated = {Quat(Eigen::AngleAxisd(7e-8, Vec3::UnitZ())), Vec3(6e-3, 0, 0)};
  panel->show_numbers({snapshot, {}});
  EXPECT_EQ(text("screw_value"), "slide 6.000 mm");
}

/// Turns and slides of every size, as an own part in a bore has them: the dock stays as wide, so
/// that at its right edge nothing is cut off. Reference: the room that the values have with none.
TEST_F(ReadoutPanelTest, numbers_of_any_size_fit_into_their_room) {
  for (const double size : {1.0, 1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9}) {
    Separation& separation = snapshot.separation;
    separation.sigma = 36e-6;
    separation.translation = 6e-3;
    separation.rotation = 9.876e-3 * size;
    separation.separated = {Quat(Eigen::AngleAxisd(0.888 * size, Vec3::UnitZ())),
                            Vec3(6e-3, 0, -7.89e-3 * size)};
    panel->show_numbers({snapshot, {}});
    for (const char* name : {"translation_value", "rotation_value", "screw_value"}) {
      const QLabel& value = *panel->findChild<QLabel*>(name);
      EXPECT_LE(value.fontMetrics().horizontalAdvance(value.text()), value.minimumWidth())
          << name << ": " << value.text().toStdString();
    }
  }
}

TEST_F(ReadoutPanelTest, a_free_probe_has_a_clearance_and_a_failed_answer_no_number) {
  snapshot.separation.status = Status::separated;
  panel->show_numbers({snapshot, {}});
  EXPECT_TRUE(text("depth_value").contains(">free<")) << text("depth_value").toStdString();
  EXPECT_EQ(text("screw_value"), "–");
  Instant now{snapshot, {}};
  now.clearance = GaugedClearance{.device = {}, .distance = 0.0025};
  panel->show_numbers(now);
  EXPECT_TRUE(text("depth_value").contains("2.500 mm</span> clear"));
  EXPECT_FALSE(text("depth_value").contains("color")) << "it was measured here";
  now.clearance->device.p.x() = 1e-3;
  panel->show_numbers(now);
  EXPECT_TRUE(text("depth_value").contains("color")) << "it was measured elsewhere: grey";
  snapshot.separation.status = Status::failed;
  snapshot.separation.clusters.size = 3;
  panel->show_numbers({snapshot, {}});
  EXPECT_TRUE(text("depth_value").contains("not found"));
  EXPECT_EQ(text("contacts_value"), "–");
}

TEST_F(ReadoutPanelTest, ways_out_are_compared_with_the_nearest) {
  const Pose hand = snapshot.separation.device;
  snapshot.separation.depth = 0.004;
  const BackgroundResult found{.device = hand,
                               .nearest = FoundSeparation{.depth = 0.004, .separated = hand},
                               .pdt = FoundSeparation{.depth = 0.006, .separated = hand},
                               .lower_bound = 0.003};
  panel->show_numbers({snapshot, found});
  EXPECT_EQ(text("nearest_value"), "4.000 mm");
  EXPECT_EQ(text("pdt_value"), "6.000 mm (150 %)");
  EXPECT_EQ(text("bound_value"), "3.000 mm (75 %)");
  EXPECT_EQ(text("why_value"), "");
  const BackgroundResult none{.device = hand, .nearest = {}, .pdt = {}, .lower_bound = {}};
  panel->show_numbers({snapshot, none});
  EXPECT_EQ(text("nearest_value"), "not found");
  EXPECT_EQ(text("pdt_value"), "not found");
  EXPECT_EQ(text("bound_value"), "none found");
}

TEST_F(ReadoutPanelTest, a_probe_that_is_free_beyond_a_wall_is_not_shown_as_a_depth_of_nothing) {
  snapshot.separation.depth = 0.0118;
  const Pose hand = snapshot.separation.device;
  BackgroundResult free{.device = hand,
                        .nearest = FoundSeparation{.depth = 0, .separated = hand},
                        .pdt = FoundSeparation{.depth = 0, .separated = hand},
                        .lower_bound = 0.0};
  panel->show_numbers({snapshot, free});
  EXPECT_EQ(text("nearest_value"), "free at the hand");
  EXPECT_EQ(text("pdt_value"), "free at the hand");
  EXPECT_EQ(text("bound_value"), "–");
  EXPECT_EQ(text("why_value"), words(WayOut::free_blocked));
  EXPECT_TRUE(text("depth_value").contains("11.800 mm")) << text("depth_value").toStdString();
  free.device.p.x() += 1e-3;  // of a pose before: no judgement
  panel->show_numbers({snapshot, free});
  EXPECT_TRUE(text("pdt_value").contains("mm"));
}

TEST_F(ReadoutPanelTest, a_force_has_its_size_its_parts_and_why_it_is_less) {
  snapshot.wrench.force = Vec3(3, -4, 0);
  snapshot.wrench.torque = Vec3(0, 0, 0.05);
  snapshot.hand.asked = snapshot.wrench;
  panel->show_numbers({snapshot, {}});
  EXPECT_EQ(text("force_value"), "5.00 N");
  EXPECT_EQ(text("force_parts_value"), "3.00, -4.00, 0");
  EXPECT_EQ(text("torque_value"), "0.0500 N·m");
  EXPECT_EQ(text("torque_parts_value"), "0, 0, 50.0") << "in mN·m: narrower";
  snapshot.coupling.max_force = 5;
  panel->show_numbers({snapshot, {}});
  EXPECT_EQ(text("force_value"), "5.00 N");
  EXPECT_EQ(text("lessened_value"), "force: limit");
  snapshot.hand.share = 0.25;
  panel->show_numbers({snapshot, {}});
  EXPECT_EQ(text("lessened_value"), "force and torque: coming in, 25 %");
}

/// In a dock as narrow as it gets, on two lines, and nothing moves when it comes and goes.
TEST_F(ReadoutPanelTest, a_reason_is_never_cut_off) {
  panel->resize(panel->minimumSizeHint());
  panel->show();
  panel->show_numbers({snapshot, {}});
  const QLabel* reason = panel->findChild<QLabel*>("lessened_value");
  const int before = reason->height();
  snapshot.wrench.force = Vec3(3, -4, 0);
  snapshot.wrench.torque = Vec3(0, 0, 0.05);
  snapshot.hand.asked = snapshot.wrench;
  snapshot.hand.share = 0.25;
  panel->show_numbers({snapshot, {}});
  QApplication::processEvents();
  ASSERT_FALSE(reason->text().isEmpty());
  EXPECT_LE(reason->heightForWidth(reason->width()), reason->height());
  EXPECT_EQ(reason->height(), before);
}

TEST_F(ReadoutPanelTest, the_loop_tells_its_times_unless_it_has_no_clock_or_is_paused) {
  panel->show_numbers({snapshot, {}});
  for (const char* name : {"tick_value", "rate_value", "late_value"}) EXPECT_EQ(text(name), "–");
  snapshot.tick_us = 42;
  snapshot.rate_hz = 999.6;
  snapshot.late = 3;
  snapshot.tick = 5000;
  panel->show_numbers({snapshot, {}});
  EXPECT_EQ(text("tick_value"), "42.0 µs");
  EXPECT_EQ(text("rate_value"), "1000 Hz");
  EXPECT_EQ(text("late_value"), "3 of 5000");
  snapshot.paused = true;
  panel->show_numbers({snapshot, {}});
  EXPECT_EQ(text("rate_value"), "paused");
}

/// The dock in the window, of two cubes that overlap.
class ReadoutInWindow : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (!HasFatalFailure()) open_cubes();
  }
};

TEST_F(ReadoutInWindow, every_number_is_there_with_its_unit) {
  const auto text = [this](const char* name) { return find<QLabel>(name)->text(); };
  ASSERT_TRUE(wait_until([&] { return text("depth_value").contains("mm</span> deep"); }))
      << text("depth_value").toStdString();
  ASSERT_TRUE(wait_until([&] { return text("pdt_value").contains("mm"); }))
      << text("pdt_value").toStdString();
  EXPECT_TRUE(text("bound_value").contains("mm"));
  EXPECT_TRUE(text("nearest_value").contains("mm"));
  EXPECT_TRUE(text("translation_value").contains("mm"));
  EXPECT_TRUE(text("screw_value").contains("slide"));
  EXPECT_TRUE(text("rotation_value").contains('%'));
  EXPECT_TRUE(text("force_value").contains(" N"));
  EXPECT_TRUE(text("torque_value").contains("N·m"));
  for (const char* parts : {"force_parts_value", "torque_parts_value"})
    EXPECT_EQ(text(parts).count(", "), 2) << text(parts).toStdString();
  EXPECT_TRUE(text("tick_value").contains("µs"));
  EXPECT_TRUE(text("rate_value").contains("Hz"));
  EXPECT_FALSE(text("depth_value").contains(','));
  EXPECT_TRUE(text("what_happens").contains("closed"));
  EXPECT_TRUE(text("rates").contains("Hz"));
}

TEST_F(ReadoutInWindow, slow_numbers_are_computed_only_while_shown) {
  ASSERT_TRUE(wait_until([this] { return window->searched().has_value(); }));
  find<QDockWidget>("readout_panel")->hide();
  EXPECT_TRUE(wait_until([this] { return !window->searched(); }))
      << "nothing is known from then on";
  wait(300);  // one may have been on its way
  const Pose last = window->session()->searched()->device;
  Pose moved = window->session()->device_pose();
  moved.p.y() += 0.001;
  window->set_device_pose(moved);
  wait(300);
  EXPECT_EQ(window->session()->searched()->device.p, last.p);
  find<QDockWidget>("readout_panel")->show();
  ASSERT_TRUE(wait_until([this] { return window->searched().has_value(); }));
  EXPECT_EQ(window->searched()->device.p, moved.p) << "not what was found before";
}

}  // namespace
}  // namespace sonde::ui::test
