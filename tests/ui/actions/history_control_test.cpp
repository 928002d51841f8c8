// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/history_control.hpp"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

class HistoryTest : public WindowTest {
 protected:
  /// Half a second at one pose, half a second at another.
  void SetUp() override {
    WindowTest::SetUp();
    open_cubes();
    before = window->session()->device_pose();
    wait_ticks(500);
    after = before;
    after.p.x() += 0.01;
    window->set_device_pose(after);
    wait_ticks(500);
  }
  HistoryControl& history() { return window->history(); }
  const TickLog& ticks() { return *history().recorder().ticks(); }
  void wait_ticks(std::uint64_t count) {
    const std::uint64_t end = ticks().end() + count;
    ASSERT_TRUE(wait_until([&] { return ticks().end() >= end; }));
  }
  template <class Widget>
  Widget* find(const char* name) {
    return window->findChild<Widget*>(QLatin1String(name));
  }
  void click(const char* button) { QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton); }
  Vec3 shown_place() { return shown().separation.device.p; }
  /// A frame was drawn of what is on show by now.
  void settle() {
    const std::size_t frames = window->frames();
    window->viewport().invalidate();
    ASSERT_TRUE(wait_until([&] { return window->frames() > frames; }));
  }
  std::string record_some() {
    const QString file = path("cubes.sonderec");
    history().record(file);
    wait_ticks(700);
    history().set_recording(false);
    EXPECT_TRUE(wait_until([this] { return !history().recorder().ending(); }));
    return file.toStdString();
  }
  Pose before, after;
};

TEST_F(HistoryTest, the_timeline_shows_what_was_then) {
  const QImage live = picture();
  EXPECT_NEAR(shown_place().x(), after.p.x(), 1e-12);
  auto* track = find<QSlider>("timeline");
  // A hand that pulls the handle to the left end.
  track->setSliderDown(true);
  track->setValue(0);
  track->setSliderDown(false);
  settle();
  EXPECT_TRUE(history().looking_back());
  EXPECT_EQ(shown_place(), before.p);
  EXPECT_GT(pixels_between(live, picture()), 200);
  EXPECT_TRUE(window->session()->paused());
  EXPECT_TRUE(find<QLabel>("timeline_text")->text().contains("tick 0"));
  // The numbers are those of that tick.
  const Snapshot first = ticks().at(ticks().begin());
  EXPECT_EQ(shown().separation.depth, first.separation.depth);
  EXPECT_EQ(shown().wrench.force, first.wrench.force);
  click("live");
  settle();
  EXPECT_FALSE(history().looking_back());
  EXPECT_FALSE(window->session()->paused());
  EXPECT_NEAR(shown_place().x(), after.p.x(), 1e-12);
}

/// The strips of the Readout lead up to the moment that is looked at, and are those of the servo
/// again after that.
TEST_F(HistoryTest, the_course_is_that_of_the_moment_on_show) {
  history().look_at(ticks().first_time() + 0.4);
  const PlotState then = history().course();
  ASSERT_TRUE(then.kept);
  EXPECT_NEAR(then.time, ticks().first_time() + 0.4, 1e-9);
  EXPECT_GT(then.kept->outline(Curve::held, then.time - 10, then.time, 2000).size(), 50u);
  wait(300);  // a gap
  history().go_live();
  wait_ticks(100);
  const PlotState live = history().course();
  EXPECT_EQ(live.time, ticks().last_time());
  const auto outline = live.kept->outline(Curve::held, live.time - 10, live.time, 200);
  EXPECT_EQ(std::ranges::count_if(outline, [](const CurvePoint& p) { return std::isnan(p.value); }),
            1)
      << "where nobody knows what was meanwhile";
}

TEST_F(HistoryTest, steps_by_one_tick) {
  history().look_at(ticks().first_time() + 0.2);
  const std::uint64_t at = history().playback().index();
  click("step_on");
  click("step_on");
  EXPECT_EQ(history().playback().index(), at + 2);
  click("step_back");
  EXPECT_EQ(history().playback().index(), at + 1);
  settle();
  EXPECT_EQ(shown().tick, ticks().at(at + 1).tick);
}

TEST_F(HistoryTest, plays_on_by_itself) {
  history().look_at(ticks().first_time());
  click("play");
  EXPECT_TRUE(wait_until([&] { return shown_place() == after.p; }));
  EXPECT_TRUE(wait_until([&] { return !history().playback().playing(); })) << "until its end";
  EXPECT_TRUE(history().looking_back());
}

TEST_F(HistoryTest, space_goes_on_live) {
  history().look_at(ticks().first_time());
  ASSERT_TRUE(window->session()->paused());
  activate();
  QTest::keyClick(window.get(), Qt::Key_Space);
  EXPECT_FALSE(history().looking_back());
  EXPECT_FALSE(window->session()->paused());
}

TEST_F(HistoryTest, a_servo_that_was_paused_stays_so) {
  window->set_paused(true);
  history().look_at(ticks().first_time());
  click("live");
  EXPECT_TRUE(window->session()->paused());
}

TEST_F(HistoryTest, esc_cuts_the_force_of_a_servo_that_is_not_on_show) {
  history().look_at(ticks().first_time());
  ASSERT_TRUE(window->session()->force_on());
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_FALSE(window->session()->force_on());
  click("live");
  EXPECT_FALSE(window->session()->force_on());
}

TEST_F(HistoryTest, the_mouse_moves_no_probe_that_is_looked_back_on) {
  history().look_at(ticks().first_time());
  drag(Qt::LeftButton, {640, 400}, {60, 0});
  EXPECT_EQ(window->session()->device_pose().p, after.p);
}

TEST_F(HistoryTest, a_recording_holds_what_was_kept_and_what_came) {
  const std::uint64_t kept = ticks().end();
  const QString file = path("cubes.sonderec");
  window->prompts().ask_record = [file] { return file; };
  click("record_button");
  EXPECT_TRUE(history().recorder().recording());
  wait_ticks(700);
  click("record_button");
  EXPECT_FALSE(history().recorder().recording());
  const auto* said = window->findChild<QPlainTextEdit*>("log_lines");
  ASSERT_TRUE(wait_until([&] { return said->toPlainText().contains("Recorded " + file); }));
  const auto recording = read_recording(file.toStdString());
  EXPECT_EQ(recording->cut, "");
  EXPECT_GE(recording->ticks.end(), kept + 700);
  EXPECT_EQ(recording->ticks.at(0).separation.device.p, before.p);
  EXPECT_EQ(recording->ticks.at(recording->ticks.end() - 1).separation.device.p, after.p);
  EXPECT_TRUE(complaints.empty()) << complaints[0].toStdString();
}

TEST_F(HistoryTest, a_recording_is_opened_with_its_scene) {
  const std::string file = record_some();
  const std::uint64_t count = read_recording(file)->ticks.end();
  open({QString::fromStdString((folder / "cube.off").string()),
        QString::fromStdString((folder / "large.off").string())},
       1e-3);
  ASSERT_FALSE(history().looking_back());
  open({QString::fromStdString(file)});
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  ASSERT_TRUE(wait_until([this] { return history().looking_back(); }));
  settle();
  EXPECT_EQ(window->session()->fixed().mass.radius, window->session()->probe().mass.radius);
  EXPECT_EQ(history().playback().ticks()->end(), count);
  EXPECT_EQ(shown_place(), before.p) << "at its beginning";
  EXPECT_TRUE(find<QLabel>("timeline_text")->text().startsWith("cubes.sonderec"));
}

TEST_F(HistoryTest, a_bad_recording_leaves_what_is_open) {
  const std::string file = record_some();
  const std::string bytes = sonde::test::text_of(file);
  const auto refuse = [&](const char* name, const std::string& text, const char* reason) {
    SCOPED_TRACE(reason);
    complaints.clear();
    folder.write(name, text);
    open({path(name)});
    ASSERT_EQ(complaints.size(), 1u);
    EXPECT_TRUE(complaints[0].contains(reason)) << complaints[0].toStdString();
    EXPECT_TRUE(complaints[0].contains(name));
    EXPECT_FALSE(history().looking_back());
    EXPECT_NE(window->session(), nullptr);
  };
  refuse("short.sonderec", bytes.substr(0, 100), "cut within its header");
  std::string newer = bytes;
  newer[8] = 9;
  refuse("newer.sonderec", newer, "version 9");
  folder.write("cube.off", cube(0.2));
  refuse("other.sonderec", bytes, "another mesh than was recorded");
}

TEST_F(HistoryTest, a_recording_that_cannot_be_written_is_told_of) {
  history().record("/dev/full");
  ASSERT_TRUE(wait_until([this] { return !complaints.empty(); }));
  EXPECT_TRUE(complaints[0].contains("No space left")) << complaints[0].toStdString();
  EXPECT_FALSE(history().recorder().recording());
  complaints.clear();
  history().record(path("nowhere/x.sonderec"));
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("nowhere/x.sonderec"));
}

/// The mesh that is open is the recorded one, also where another lies in its place by then.
TEST_F(HistoryTest, a_mesh_replaced_while_it_is_open_is_not_the_recorded_one) {
  const MeshMarks opened = window->session()->loaded().marks;
  EXPECT_EQ(opened.probe, mark_of(folder / "cube.off"));
  window->prompts().ask_reload = [](const QString&) { return false; };
  folder.write("cube.off", cube(0.1) + "# another\n");
  ASSERT_NE(mark_of(folder / "cube.off"), opened.probe);
  history().record(path("cubes.sonderec"));
  history().set_recording(false);
  EXPECT_TRUE(wait_until([this] { return !history().recorder().ending(); }));
  const auto recording = read_recording((folder / "cubes.sonderec").string());
  EXPECT_EQ(recording->header.meshes.probe, opened.probe);
  EXPECT_THROW(check_meshes(recording->header, folder / "cubes.sonderec"), InputError);
}

TEST_F(HistoryTest, what_the_window_shows_is_not_recorded_over) {
  const std::filesystem::path mesh = window->session()->loaded().scene.probe.mesh;
  const auto size = std::filesystem::file_size(mesh);
  history().record(QString::fromStdString(mesh.string()));
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("the window shows this file")) << complaints[0].toStdString();
  EXPECT_FALSE(history().recorder().recording());
  EXPECT_EQ(std::filesystem::file_size(mesh), size);
  complaints.clear();
  const QString file = QString::fromStdString(record_some());
  history().open_recording(file);
  ASSERT_TRUE(wait_until([&] { return history().looking_back(); }));
  history().record(file);
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_FALSE(history().recorder().recording());
  EXPECT_TRUE(history().instant().has_value()) << "it can be read on";
}

// Under the address sanitizer: the plots hold no curves that are gone.
TEST_F(HistoryTest, a_second_run_takes_the_place_of_the_first_while_plots_are_held) {
  history().plots().show();
  settle();
  int runs = 0;
  QObject::connect(&history(), &HistoryControl::replayed, [&] { ++runs; });
  const Coupling gains = window->session()->coupling();
  for (const int run : {1, 2}) {
    history().run_again(Method::pdg, gains);
    ASSERT_TRUE(wait_until([&] { return runs == run; }));
    settle();
    find<QCheckBox>("hold_plots")->setChecked(true);
  }
  QWidget& charts = history().plots().charts();
  QTest::mouseMove(&charts, charts.rect().center());
  QTest::mouseMove(&charts, charts.rect().center() + QPoint(5, 0));
  settle();
  EXPECT_NE(history().replay(), nullptr);
}

TEST_F(HistoryTest, runs_again_with_other_gains_beside_the_first) {
  Coupling soft = window->session()->coupling();
  soft.k = 50;
  bool ran = false;
  QObject::connect(&history(), &HistoryControl::replayed, [&] { ran = true; });
  history().run_again(Method::pdg, soft);
  ASSERT_TRUE(wait_until([&] { return ran; }));
  ASSERT_NE(history().replay(), nullptr);
  const double end = ticks().last_time();
  history().look_at(end);
  const Snapshot again = window->history().instant()->snapshot;
  history().show_replay(false);
  const Snapshot first = history().instant()->snapshot;
  EXPECT_EQ(again.time, first.time);
  EXPECT_EQ(again.separation.device.p, first.separation.device.p);
  EXPECT_EQ(again.coupling.k, 50);
  EXPECT_NEAR(again.wrench.force.norm(), 50 * again.separation.depth, 1e-3);
  EXPECT_NEAR(again.separation.depth, first.separation.depth, 1e-4);
}

TEST_F(HistoryTest, runs_again_with_a_and_b_and_lays_both_over_what_was_felt) {
  history().plots().show();
  history().plots().raise();
  settle();
  bool ran = false;
  QObject::connect(&history(), &HistoryControl::replayed, [&] { ran = true; });
  find<QPushButton>("gains_b")->click();
  find<TypedValue>("k_value")->setValue(100);
  find<QAction>("run_both")->trigger();
  ASSERT_TRUE(wait_until([&] { return ran; }));
  ASSERT_TRUE(history().replay() && history().second_replay());
  // Of the first half second, in contact; at the end the probe but touches.
  const double then = history().replay()->log().first_time() + 0.45;
  const double a = history().replay()->curves.at(Curve::force, then);
  const double b = history().second_replay()->curves.at(Curve::force, then);
  const double held = history().replay()->curves.at(Curve::held, then);
  ASSERT_GT(held, 1e-3);
  EXPECT_NEAR(a, 500 * held, 1e-3 * a) << "Hooke's law with the k of A";
  EXPECT_NEAR(b, 100 * held, 1e-3 * a) << "and of B";
  // In the dock: a third line of each curve, and both values.
  const auto values = [&] { return find<QLabel>("plot_values")->text(); };
  EXPECT_TRUE(wait_until([&] { return values().contains("/ A ") && values().contains("/ B "); }))
      << values().toStdString();
  ran = false;
  history().run_again(Method::pdg, window->session()->coupling());
  ASSERT_TRUE(wait_until([&] { return ran; }));
  EXPECT_EQ(history().second_replay(), nullptr) << "one run takes the place of both";
}

TEST_F(HistoryTest, what_is_opened_next_has_a_history_of_its_own) {
  history().look_at(ticks().first_time());
  open_cubes();
  EXPECT_FALSE(history().looking_back());
  EXPECT_FALSE(window->session()->paused());
  EXPECT_LT(ticks().end(), 1000u);
}

}  // namespace
}  // namespace sonde::ui::test
