// SPDX-License-Identifier: GPL-3.0-or-later
// What a person expects of any window: titles without gaps, one minus sign, sliders that go where
// one clicks, and a page that says why a file was not opened.

#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QStatusBar>
#include <QTest>
#include <QTreeWidget>
#include <cmath>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {
namespace {

class NoSurprise : public WindowTest {
 protected:
  QString text(const char* label) const { return find<QLabel>(label)->text(); }
  const TickLog& ticks() { return *window->history().recorder().ticks(); }
  void wait_seconds_kept(double seconds) {
    ASSERT_TRUE(wait_until([&] { return ticks().last_time() - ticks().first_time() > seconds; }));
  }
};

TEST_F(NoSurprise, undo_is_named_with_its_step_or_alone) {
  open_cubes();
  auto *undo = find<QAction>("undo"), *redo = find<QAction>("redo");
  EXPECT_EQ(undo->text(), "&Undo");
  EXPECT_EQ(redo->text(), "&Redo");
  EXPECT_FALSE(undo->isEnabled());
  Pose moved = window->session()->device_pose();
  moved.p.z() += 0.01;
  window->set_device_pose(moved);
  act("reset");
  EXPECT_EQ(undo->text(), "&Undo: Reset");
  EXPECT_TRUE(undo->isEnabled());
  undo->trigger();
  EXPECT_EQ(undo->text(), "&Undo");
  EXPECT_EQ(redo->text(), "&Redo: Reset");
}

TEST_F(NoSurprise, there_is_one_minus_sign) {
  open_cubes();
  wait(300);
  const QChar other(0x2212);
  for (const QAction* action : window->findChildren<QAction*>())
    EXPECT_FALSE(action->text().contains(other)) << action->text().toStdString();
  for (const QLabel* label : window->findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains(other)) << label->text().toStdString();
}

TEST_F(NoSurprise, the_timeline_jumps_where_one_clicks) {
  open_cubes();
  wait_seconds_kept(1.5);
  window->set_paused(true);  // the range stays
  settle();
  auto* track = find<QSlider>("timeline");
  QTest::mouseClick(track, Qt::LeftButton, Qt::NoModifier,
                    QPoint(track->width() / 4, track->height() / 2));
  ASSERT_TRUE(window->history().looking_back());
  const double part = (window->history().playback().time() - ticks().first_time()) /
                      (ticks().last_time() - ticks().first_time());
  EXPECT_NEAR(part, 0.25, 0.02);
}

/// The cubes stand still, so nothing of the picture changes but its time.
TEST_F(NoSurprise, the_view_says_the_time_of_the_tick_that_the_timeline_shows) {
  open_cubes();
  wait_seconds_kept(2.5);
  auto* hints = find<HintView>("hint_view");
  for (const double back : {2.0, 1.0, 0.5}) {
    window->history().look_at(ticks().last_time() - back);
    const auto time = [](const QString& words) {
      return words.section(' ', words.startsWith("At ") ? 1 : 0, words.startsWith("At ") ? 1 : 0);
    };
    EXPECT_TRUE(wait_until([&] { return time(hints->banner()) == time(text("timeline_text")); }))
        << hints->banner().toStdString() << " | " << text("timeline_text").toStdString();
    EXPECT_EQ(time(hints->banner()), QString::number(shown().time, 'f', 3));
  }
}

/// Reference: by hand. The cube reaches that far into the other, and no motion out is shorter than
/// nothing or longer than straight back. With the readout folded, the plots show what is, and with
/// both folded nothing is known.
TEST_F(NoSurprise, the_nearest_way_out_is_that_of_the_present_pose_whatever_dock_is_folded) {
  open_cubes();
  const auto plotted = [this] {
    const Curves& curves = window->history().recorder().curves();
    return curves.at(Curve::nearest, curves.last_time());
  };
  const auto reach = [this](double depth) {
    Pose moved = window->session()->device_pose();
    moved.p.x() = 0.1 - depth;
    window->set_device_pose(moved);
  };
  const auto comes_to = [&](double depth) {
    reach(depth);
    return wait_until([&] { return plotted() <= depth * (1 + 1e-4) && plotted() > 0.5 * depth; });
  };
  ASSERT_TRUE(comes_to(8e-3));
  find<QDockWidget>("plots_panel")->show();
  find<QDockWidget>("readout_panel")->hide();
  ASSERT_TRUE(wait_until([this] { return !find<QDockWidget>("readout_panel")->isVisible(); }));
  EXPECT_TRUE(comes_to(3e-3)) << plotted();
  find<QDockWidget>("plots_panel")->hide();
  reach(6e-3);
  EXPECT_TRUE(wait_until([&] { return std::isnan(plotted()); }));
  act("show_nearest");
  EXPECT_TRUE(comes_to(5e-3)) << plotted();
}

TEST_F(NoSurprise, record_says_since_when) {
  open_cubes();
  wait_seconds_kept(1);
  window->history().record(path("run.sonderec"));
  EXPECT_TRUE(wait_until([this] { return text("timeline_text").contains("recording since"); }));
  const QString before =
      text("timeline_text").section(QStringLiteral("with the "), 1).section(' ', 0, 0);
  EXPECT_GE(before.toDouble(), 1) << text("timeline_text").toStdString();
  window->history().set_recording(false);
}

TEST_F(NoSurprise, the_start_page_says_why_nothing_was_opened_and_looks_for_it) {
  window->show_start_page("broken.stl: is not an STL file", {path("broken.stl")});
  auto* page = find<QWidget>("start_page");
  EXPECT_TRUE(page->isVisible());
  EXPECT_EQ(text("start_reason"), "Nothing was opened. broken.stl: is not an STL file");
  int asked = 0;
  window->prompts().ask_meshes = [&](const QString&) -> std::optional<std::pair<QString, QString>> {
    ++asked;
    return std::pair{path("cube.off"), path("cube.off")};
  };
  answered_unit = 1;
  QTest::mouseClick(find<QPushButton>("start_locate"), Qt::LeftButton);
  EXPECT_EQ(asked, 1);
  ASSERT_TRUE(wait_until([this] { return opened == 1; }));
  EXPECT_FALSE(page->isVisible());
  window->show_start_page();
  EXPECT_FALSE(find<QWidget>("start_complaint")->isVisible()) << "of then";
}

TEST_F(NoSurprise, one_mesh_is_read_before_the_other_is_asked_for) {
  int asked = 0;
  window->prompts().ask_meshes =
      [&](const QString& first) -> std::optional<std::pair<QString, QString>> {
    ++asked;
    EXPECT_EQ(first, path("cube.off"));
    return std::nullopt;
  };
  folder.write("broken.stl", "PK\x03\x04");
  open({path("broken.stl")});
  EXPECT_EQ(asked, 0);
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("is not an STL file")) << complaints[0].toStdString();
  EXPECT_EQ(window->statusBar()->currentMessage(), QString()) << "it is not being opened any more";
  open({path("cube.off")});
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(window->statusBar()->currentMessage(), QString());
}

/// Closed form: the cubes of 100 mm, the one 130 mm beside the other, are 30 mm apart.
TEST_F(NoSurprise, a_free_probe_shows_its_clearance_in_readout_status_view_and_plots) {
  open_cubes();
  window->set_device_pose({Quat::Identity(), {0.13, 0.02, 0.013}});
  ASSERT_TRUE(wait_until([this] { return text("depth_value").contains("30.000 mm</span> clear"); }))
      << text("depth_value").toStdString();
  EXPECT_TRUE(wait_until([this] { return text("what_happens").contains("30.000 mm clear"); }))
      << text("what_happens").toStdString();
  const Curves& curves = window->history().recorder().curves();
  EXPECT_TRUE(wait_until([&] {
    return std::abs(curves.at(Curve::clearance, curves.last_time()) - 0.03) < 1e-8;
  })) << curves.at(Curve::clearance, curves.last_time());
  window->set_paused(true);
  settle();
  const QImage with = picture();
  act("show_clearance");
  EXPECT_GT(pixels_between(with, picture()), 40) << "two points and a line";
  act("show_clearance");
  window->set_paused(false);
  // Held, the same quantity goes on below zero.
  window->set_device_pose({Quat::Identity(), {0.09, 0.02, 0.013}});
  ASSERT_TRUE(wait_until([this] { return text("depth_value").contains("10.0"); }));
  EXPECT_TRUE(text("depth_value").contains(" deep"));
  EXPECT_TRUE(wait_until(
      [&] { return std::abs(curves.at(Curve::clearance, curves.last_time()) + 0.01) < 1e-3; }));
}

/// The forces of the table are those that add up to what the hand feels.
TEST_F(NoSurprise, contacts_have_their_force_place_and_normal) {
  open_cubes();
  ASSERT_TRUE(wait_until([this] { return shown().hand.share >= 1; }));
  auto* panel = find<QWidget>("contacts_panel");
  panel->show();
  auto* rows = find<QTreeWidget>("contact_rows");
  ASSERT_TRUE(wait_until([&] { return rows->topLevelItemCount() > 0; }));
  window->set_paused(true);
  wait(300);
  double force = 0;
  for (int i = 0; i < rows->topLevelItemCount(); ++i) {
    const QTreeWidgetItem& row = *rows->topLevelItem(i);
    force += row.text(2).section(' ', 0, 0).toDouble();
    EXPECT_EQ(row.text(4).count(','), 2) << row.text(4).toStdString();
    EXPECT_EQ(row.text(5), "1.00, 0, 0") << "out of the face that is touched";
  }
  // 10 mm at 500 N/m.
  EXPECT_NEAR(force, 5, 0.05);
  const QTreeWidgetItem& head = *rows->headerItem();
  for (int i = 0; i < rows->columnCount(); ++i) {
    EXPECT_NE(head.text(i), "Multiplier");
    EXPECT_NE(head.text(i), "Rows");
  }
}

}  // namespace
}  // namespace sonde::ui::test
