// SPDX-License-Identifier: GPL-3.0-or-later
// The one knob in the window: a time or an accuracy for each tick.
#include "ui/actions/accuracy_control.hpp"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QRadioButton>
#include <QSlider>
#include <QTest>
#include <cmath>
#include <limits>

#include "engine/calibration/calibration_file.hpp"
#include "engine/proximity/sketch/sketch.hpp"
#include "engine/scene/scene.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/base/format.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

class AccuracyTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    window->accuracy().panel().show();
    ASSERT_TRUE(wait_until([this] { return window->accuracy().panel().isVisible(); }));
  }
  void click(const char* radio) {
    auto* button = find<QRadioButton>(radio);
    QTest::mouseClick(button, Qt::LeftButton, Qt::NoModifier, QPoint(8, button->height() / 2));
  }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
  const ServoSettings& saved() { return window->documents().document().content().scene.servo; }
  const ServoSettings& running() { return window->session()->loaded().servo; }
};

/// The curve of the calibration that comes with the build, which every pair with sketches has.
AccuracyCurve shipped() { return {default_calibration(), Answers::tick, Method::pdg, true}; }

TEST_F(AccuracyTest, the_calibration_that_ships_knows_ticks) {
  EXPECT_TRUE(std::isfinite(shipped().within(800)));
  EXPECT_GT(shipped().time_for(0.05), 0);
}

// Reference: the claim of the calibration that ships for that time, or the lower bound's.
TEST_F(AccuracyTest, the_search_beside_says_what_it_claims_and_is_surer_where_that_is_chosen) {
  const auto claims = [this](double sure) -> QString {
    const auto searched = window->session()->searched();
    if (!searched || !searched->nearest || searched->sure != sure) return {};
    const double expected = AccuracyCurve(default_calibration(), Answers::search, Method::pdg,
                                          bool(window->session()->loaded().pair.sketches()), sure)
                                .within(searched->budget_us, searched->far_out);
    const double certified = searched->lower_bound.value_or(0) > 0
                                 ? searched->nearest->depth / *searched->lower_bound - 1
                                 : std::numeric_limits<double>::infinity();
    const bool is_certified = certified <= expected;
    return QStringLiteral("within %1 %, %2")
        .arg(number(100 * std::min(certified, expected)),
             is_certified ? QStringLiteral("certified")
                          : QStringLiteral("%1 in 100").arg(std::lround(100 * sure)));
  };
  ASSERT_TRUE(wait_until([&] {
    const QString claim = claims(0.9);
    return !claim.isEmpty() && text("search_claim") == claim;
  })) << text("search_claim").toStdString();
  auto* sure = find<QComboBox>("search_sure");
  ASSERT_EQ(sure->count(), 3);
  EXPECT_EQ(sure->currentText(), "90 %");
  sure->setCurrentIndex(2);
  emit sure->activated(2);
  ASSERT_TRUE(wait_until([&] {
    const QString claim = claims(0.99);
    return !claim.isEmpty() && text("search_claim") == claim;
  })) << text("search_claim").toStdString();
  open_cubes();
  ASSERT_TRUE(wait_until([&] { return !claims(0.99).isEmpty(); })) << "the next pair is as sure";
}

TEST_F(AccuracyTest, an_accuracy_is_chosen_moved_saved_and_undone) {
  click("knob_accuracy");
  ASSERT_GT(saved().accuracy, 0);
  EXPECT_NEAR(saved().accuracy, std::clamp(shipped().within(800), least_share, most_share), 1e-4)
      << "what the time before was worth";
  EXPECT_EQ(running().accuracy, saved().accuracy);
  auto* slider = find<QSlider>("tick_accuracy_slider");
  const double before = saved().accuracy;
  const QString expected = text("expected_accuracy");
  // From the end of its range the slider goes one way alone.
  const bool wide = before > 0.01;
  for (int i = 0; i < 2; ++i) QTest::keyClick(slider, wide ? Qt::Key_PageDown : Qt::Key_PageUp);
  EXPECT_GT(wide ? before / saved().accuracy : saved().accuracy / before, 1.5);
  EXPECT_EQ(running().accuracy, saved().accuracy) << "acts at once";
  EXPECT_NE(text("expected_accuracy"), expected);
  act("save");
  EXPECT_EQ(read_scene(scene).servo.accuracy, saved().accuracy);
  while (find<QAction>("undo")->isEnabled()) act("undo");
  EXPECT_EQ(saved().accuracy, 0);
  EXPECT_EQ(running().accuracy, 0);
  EXPECT_TRUE(find<QRadioButton>("knob_time")->isChecked());
}

TEST_F(AccuracyTest, a_typed_time_is_kept_in_the_scene) {
  type("tick_time_value", "250");
  EXPECT_DOUBLE_EQ(saved().budget.microseconds, 250);
  EXPECT_DOUBLE_EQ(running().budget.microseconds, 250);
  act("save");
  EXPECT_DOUBLE_EQ(read_scene(scene).servo.budget.microseconds, 250);
}

TEST_F(AccuracyTest, no_limit_is_a_choice_and_a_time_comes_back) {
  click("knob_none");
  EXPECT_EQ(running().budget.microseconds, 0);
  EXPECT_EQ(running().accuracy, 0);
  click("knob_time");
  EXPECT_EQ(running().budget.microseconds, ServoSettings{}.budget.microseconds);
}

TEST_F(AccuracyTest, it_shows_what_the_ticks_reach_and_rests_where_nobody_looks) {
  // Two cubes at rest: every tick ends at its optimum.
  ASSERT_TRUE(wait_until([this] { return text("reached_accuracy").contains('%'); }));
  EXPECT_EQ(text("converged_share"), "100 %");
  EXPECT_TRUE(text("rows_time").contains("µs"));
  for (const char* phase : {"look", "solve", "couple"})
    EXPECT_TRUE(text("phases").contains(phase)) << phase;
  EXPECT_GT(shown().hand.rows.phases[Phase::look], 0);
  // So are those of the search beside.
  Pose moved = window->session()->device_pose();
  moved.p.x() -= 0.001;
  window->set_device_pose(moved);
  ASSERT_TRUE(wait_until([this] { return text("search_phases").contains("sketch"); }));
  for (const char* phase : {"look", "solve", "sweep", "verify", "bound"})
    EXPECT_TRUE(text("search_phases").contains(phase)) << phase;
  EXPECT_TRUE(text("search_time").contains("µs"));
  const PhaseTimes searched = window->session()->searched()->phases;
  EXPECT_GT(searched[Phase::sketch], 0);
  EXPECT_GT(searched[Phase::bound], 0);
  EXPECT_EQ(text("expected_here"), "not measured") << "these cubes are no scene of Sonde's";
  window->accuracy().panel().close();
  find<QLabel>("reached_accuracy")->setText("untouched");
  wait(600);
  EXPECT_EQ(text("reached_accuracy"), "untouched");
  EXPECT_EQ(shown().hand.rows.phases.sum(), 0) << "nobody looks: nothing is timed";
}

TEST_F(AccuracyTest, a_scene_of_its_own_has_what_was_measured_on_it) {
  open({QStringLiteral(SONDE_RESOURCES "/scenes/linked-tori.sonde.json")});
  const AccuracyCurve here(of_pair(default_calibration(), "linked-tori"), Answers::tick,
                           Method::pdg, true);
  ASSERT_TRUE(std::isfinite(here.within(running().budget.microseconds)));
  EXPECT_EQ(text("expected_here"),
            "within " + number(100 * here.within(running().budget.microseconds)) + " %");
}

TEST_F(AccuracyTest, a_foreign_scene_of_the_same_name_has_none_of_that) {
  const auto file = folder.write("linked-tori.sonde.json", R"({"unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0.09, 0.02, 0.013, 1, 0, 0, 0]},
        "fixed": {"mesh": "cube.off"}})");
  open({QString::fromStdString(file.string())});
  EXPECT_EQ(text("expected_here"), "not measured");
}

/// Reference: what the file says.
TEST_F(AccuracyTest, what_was_measured_on_a_scene_lies_beside_it) {
  CalibrationSeries series{"cubes", Answers::tick, Method::pdg, true, {}};
  series.points = {{400, std::vector<double>(10, 0.03)}, {800, std::vector<double>(10, 0.002)}};
  const auto file = folder.write("cubes.calibration.json", to_json(Calibration{{series}}));
  open_cubes();
  EXPECT_EQ(text("expected_here"), "within " + number(0.2) + " %");
  type("tick_time_value", "400");
  EXPECT_EQ(text("expected_here"), "within " + number(3) + " %");
  click("knob_none");
  EXPECT_EQ(text("expected_here"), "not measured");
  EXPECT_EQ(text("expected_accuracy"), "no limit of time");

  std::filesystem::resize_file(file, 60);
  act("undo");
  open_cubes();
  EXPECT_EQ(text("expected_here"), "cannot be read");
  EXPECT_TRUE(find<QLabel>("expected_here")->toolTip().contains("cubes.calibration.json:"));
  series.pair = "others";
  folder.write("cubes.calibration.json", to_json(Calibration{{series}}));
  open_cubes();
  EXPECT_TRUE(find<QLabel>("expected_here")->toolTip().contains("nothing of the scene cubes"));
}

TEST_F(AccuracyTest, the_accuracy_of_a_scene_is_shown) {
  const auto file = folder.write("wanted.sonde.json", R"({"unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0.09, 0.02, 0.013, 1, 0, 0, 0]},
        "fixed": {"mesh": "cube.off"}, "servo": {"accuracy": 0.05}})");
  open({QString::fromStdString(file.string())});
  EXPECT_EQ(running().accuracy, 0.05);
  EXPECT_TRUE(find<QRadioButton>("knob_accuracy")->isChecked());
  EXPECT_NEAR(find<TypedValue>("tick_accuracy_value")->value(), 5, 1e-9);
}

}  // namespace
}  // namespace sonde::ui::test
