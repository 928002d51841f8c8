// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/stiffness_control.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <cmath>
#include <fstream>

#include "engine/study/stability/press_and_hold.hpp"
#include "tests/ui/actions/stiffness_fixture.hpp"
#include "tests/ui/canned_study.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/map_plot.hpp"
#include "ui/panels/typed_value.hpp"
#include "ui/tuning/present_contact.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(StiffnessTest, the_point_on_the_map_moves_with_the_slider) {
  EXPECT_FALSE(find<MapPlot>("map_plot")->isVisible()) << "there is no map yet";
  load("tuned");
  auto* plot = find<MapPlot>("map_plot");
  ASSERT_TRUE(wait_until([&] { return plot->isVisible(); }));
  ASSERT_TRUE(plot->now());
  EXPECT_EQ(plot->now()->stiffness, 500);
  EXPECT_TRUE(
      text("map_place")
          .contains("By the study of sigma.7, k = 500 N/m is stable in every contact and hand "
                    "shown, with the device's friction; the study allows 600 N/m, limited by "
                    "stability (edge contact, light hand): could be 1.20 times as stiff"))
      << text("map_place").toStdString();
  const double before = plot->place(*plot->now()).x();
  auto* slider = find<QSlider>("k_slider");
  slider->setValue(slider->value() + 150);
  EXPECT_EQ(plot->now()->stiffness, k());
  EXPECT_GT(plot->place(*plot->now()).x(), before + 20);
  EXPECT_TRUE(text("map_place").contains("unstable")) << k();
  EXPECT_TRUE(text("map_place").contains(" times too stiff")) << text("map_place").toStdString();
  EXPECT_EQ(plot->recommended()->stiffness, 600);
}

TEST_F(StiffnessTest, one_kind_of_contact_can_be_looked_at) {
  load("tuned");
  auto* kinds = find<QComboBox>("map_kind");
  EXPECT_EQ(find<MapPlot>("map_plot")->map().rows.size(), 2u);
  kinds->setCurrentIndex(kinds->findText("flat"));
  EXPECT_EQ(find<MapPlot>("map_plot")->map().rows.size(), 1u);
}

TEST_F(StiffnessTest, the_recommended_gains_act_at_once_and_can_be_undone) {
  load("tuned");
  EXPECT_TRUE(text("recommendation").contains("stability (edge contact, light hand)"));
  EXPECT_TRUE(text("recommendation").contains("mass 0.5 to 1.11 times"));
  const double force = 500 * shown().separation.depth;
  ASSERT_TRUE(wait_until([&] { return shown().wrench.force.norm() > 0.99 * force; }));
  find<QPushButton>("apply_recommended")->click();
  EXPECT_EQ(k(), 600);
  EXPECT_EQ(window->session()->coupling().max_force, 8) << "the limits it was studied with too";
  EXPECT_EQ(find<TypedValue>("k_value")->value(), 600);
  EXPECT_TRUE(wait_until([&] {
    return std::abs(shown().wrench.force.norm() - 1.2 * force) < 0.01 * force;
  })) << shown().wrench.force.norm();
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 500);
  EXPECT_EQ(window->session()->coupling().max_force, 10);
  find<QAction>("redo")->trigger();
  EXPECT_EQ(k(), 600);
}

TEST_F(StiffnessTest, two_sets_of_gains_by_button_and_by_key_while_in_contact) {
  auto* value = find<TypedValue>("k_value");
  find<QPushButton>("gains_b")->click();
  EXPECT_EQ(k(), 500) << "both begin as opened";
  EXPECT_TRUE(find<QPushButton>("gains_b")->isChecked());
  EXPECT_FALSE(find<QPushButton>("gains_a")->isChecked());
  value->setValue(800);
  EXPECT_TRUE(find<QPushButton>("gains_b")->text().contains("800"));
  EXPECT_TRUE(find<QPushButton>("gains_a")->text().contains("500"));
  QApplication::setActiveWindow(window.get());  // there is no window manager to do it
  QTest::keyClick(window->viewport().canvas(), Qt::Key_B);
  EXPECT_TRUE(find<QPushButton>("gains_a")->isChecked());
  EXPECT_EQ(k(), 500);
  EXPECT_EQ(shown().separation.status, Status::penetrating);
  find<QPushButton>("gains_a")->click();
  EXPECT_EQ(k(), 500) << "it is active already";
  EXPECT_TRUE(find<QPushButton>("gains_a")->isChecked());
  // Undone in the order it was done: the switch, the gain, the first switch.
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 800);
  EXPECT_EQ(stiffness().sets().active(), 1u);
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 500);
  find<QAction>("undo")->trigger();
  EXPECT_EQ(stiffness().sets().active(), 0u);
}

TEST_F(StiffnessTest, what_cannot_be_read_says_why_and_the_map_stays) {
  load("tuned");
  const auto tells = [&](const char* name, const QString& what) {
    load(name);
    ASSERT_FALSE(complaints.empty());
    EXPECT_TRUE(complaints.back().contains(what)) << complaints.back().toStdString();
    ASSERT_TRUE(stiffness().tuning());
    EXPECT_EQ(stiffness().tuning()->folder, folder / "tuned");
    EXPECT_EQ(find<MapPlot>("map_plot")->map().rows.size(), 2u);
  };
  std::filesystem::create_directory(folder / "empty");
  tells("empty", "study.json");
  tells("nowhere", "nowhere");
  folder.write("garbled/study.json", "{\"study\": \"tune\", \"about\"");
  tells("garbled", "study.json");
  write_canned_study(folder / "half", folder / "cube.off", folder / "cube.off");
  std::filesystem::remove(folder / "half/parts/edge1.100.json");
  tells("half", "edge1.100");
  write_canned_study(folder / "broken", folder / "cube.off", folder / "cube.off");
  folder.write("broken/parts/edge1.100.json", "{\"situation\": 7}");
  tells("broken", "broken");
}

TEST_F(StiffnessTest, a_map_of_another_scene_or_another_device_says_so) {
  write_canned_study(folder / "other", folder / "large.off", folder / "cube.off");
  load("other");
  EXPECT_TRUE(text("tuning_doubt").contains("another scene: its probe is large.off, not cube.off"))
      << text("tuning_doubt").toStdString();
  load("tuned");
  EXPECT_FALSE(find<QLabel>("tuning_doubt")->isVisible());
  auto* sources = find<QComboBox>("holder");
  emit sources->activated(sources->findText("omega.7 (simulated)"));
  EXPECT_TRUE(text("tuning_doubt").contains("another device: sigma.7, not omega.7"));
  EXPECT_EQ(find<QComboBox>("tuning_device")->currentText(), "omega.7");
}

TEST_F(StiffnessTest, another_scene_has_no_map) {
  load("tuned");
  open_cubes();
  EXPECT_FALSE(stiffness().tuning());
  EXPECT_FALSE(find<QPushButton>("apply_recommended")->isVisible());
}

// Damped with 2 N·s/m of its own and 1 of the lightest hand, one sample late: beyond some 2 kN/m,
// or what its maker allows, gains wait or are taken as that, so that nothing buzzes.
TEST_F(StiffnessTest, gains_beyond_what_the_device_bears_wait_and_the_dock_says_so) {
  auto* sources = find<QComboBox>("holder");
  emit sources->activated(sources->findText("sigma.7 (simulated)"));
  auto* typed = find<TypedValue>("k_value");
  const auto settled = [&] {
    wait(1500);  // a whole second without what came before
    EXPECT_TRUE(wait_until([&] { return stiffness().buzz().has_value(); }));
    return *stiffness().buzz();
  };
  typed->setValue(200);
  const Buzz quiet = settled();
  EXPECT_TRUE(quiet.loop);
  EXPECT_FALSE(quiet.chatter.buzzes()) << quiet.chatter.force;
  EXPECT_EQ(shown().separation.status, Status::penetrating);
  typed->setValue(40'000);
  EXPECT_TRUE(wait_until([&] {
    const QString said = text("rendered_gains");
    return said.contains("wait") || said.contains("bears");
  })) << text("rendered_gains").toStdString();
  const Buzz after = settled();
  EXPECT_FALSE(after.chatter.buzzes());
  EXPECT_TRUE(stiffness().note().now.isEmpty());
  // What is felt is told apart from what waits, where the gains are set and in the view.
  EXPECT_EQ(find<QLabel>("gains_waiting")->isHidden(), !after.waiting);
  EXPECT_EQ(stiffness().note().text.contains("the gains set wait"), after.waiting);
  EXPECT_TRUE(!after.waiting || after.rendered.now.k < 40'000) << after.rendered.now.k;
  EXPECT_TRUE(text("energy_value").endsWith("mJ"));
}

TEST_F(StiffnessTest, the_present_contact_is_marked_on_the_map_with_its_own_boundary) {
  load("tuned");
  auto* plot = find<MapPlot>("map_plot");
  // Two cubes face to face: which the study has not.
  ASSERT_EQ(kind_of_contact(shown().separation), "conforming");
  EXPECT_TRUE(wait_until([&] { return text("map_place").contains("conforming, which the study"); }))
      << text("map_place").toStdString();
  EXPECT_EQ(plot->contact(), "");
  // The lower half is the row of flat contacts, the upper one that of the others.
  const auto yellow = [&](bool lower) {
    const QImage image = plot->grab().toImage();
    const double low = plot->place({1, 0}).y(), apart = 2 * (plot->bottom() - low);
    const int y = int(lower ? low : low - apart);
    int count = 0;
    for (int x = 0; x < image.width(); ++x)
      for (int dy = -2; dy <= 2; ++dy) count += image.pixelColor(x, y + dy) == colour::contact;
    return count;
  };
  EXPECT_EQ(yellow(false), 0);
  load("fitting");
  ASSERT_TRUE(wait_until([&] { return plot->contact() == "conforming"; }));
  EXPECT_TRUE(
      text("map_place")
          .contains("Contact now: conforming, in it the study allows 600 N/m, limited by stability "
                    "(conforming contact, light hand): could be 1.20 times as stiff"))
      << text("map_place").toStdString();
  EXPECT_GT(yellow(false), 20) << "the name's plate, and the boundary";
  EXPECT_EQ(yellow(true), 0);
  window->documents().place({Quat::Identity(), Vec3(0.3, 0.02, 0.013)}, "Away");
  EXPECT_TRUE(wait_until([&] { return plot->contact().empty(); })) << "no contact, no mark";
  EXPECT_FALSE(text("map_place").contains("Contact now"));
}

TEST_F(StiffnessTest, a_click_on_the_map_sets_k_there_and_can_be_undone) {
  load("tuned");
  auto* plot = find<MapPlot>("map_plot");
  ASSERT_TRUE(wait_until([&] { return plot->isVisible(); }));
  const QPoint at = plot->place({800, 0}).toPoint();
  QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, at);
  // To a pixel of the axis, and as it is shown: three digits.
  const double step = plot->point_at(at + QPoint(1, 0)).stiffness / plot->point_at(at).stiffness;
  EXPECT_NEAR(std::log(k() / 800), 0, std::log(step) + 0.005);
  EXPECT_EQ(k(), std::round(k()));
  EXPECT_EQ(find<TypedValue>("k_value")->value(), k());
  EXPECT_EQ(plot->now()->stiffness, k());
  find<QAction>("undo")->trigger();
  EXPECT_EQ(k(), 500);
  // Beside the cells nothing happens.
  QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, QPoint(3, 3));
  EXPECT_EQ(k(), 500);
}

TEST_F(StiffnessTest, use_recommended_is_in_sight_at_1280_by_800) {
  auto* use = find<QPushButton>("apply_recommended");
  EXPECT_FALSE(use->isVisible());
  load("tuned");
  ASSERT_EQ(window->size(), QSize(1280, 800));
  ASSERT_TRUE(wait_until([&] { return use->isVisible(); }));
  settle();
  EXPECT_EQ(use->visibleRegion().boundingRect(), use->rect()) << "all of it, without scrolling";
  EXPECT_TRUE(use->text().contains("600 N/m"));
  QTest::mouseClick(use, Qt::LeftButton);
  EXPECT_EQ(k(), 600);
}

TEST_F(StiffnessTest, so_are_the_gains_of_the_classic_coupling) {
  const auto replace = [](const std::filesystem::path& file, const QString& what, const char* by) {
    const std::string text = read_text(file, 1 << 20);
    std::ofstream(file) << QString::fromStdString(text).replace(what, by).toStdString();
  };
  const std::filesystem::path study = folder / "tuned";
  replace(study / "study.json", R"("mode": "object")", R"("mode": "classic")");
  replace(study / "study.json", R"("rotational_stiffness_per_translational": 0)",
          R"("rotational_stiffness_per_translational": 5.5e-5)");
  for (const auto& part : std::filesystem::directory_iterator(study / "parts"))
    replace(part.path(), R"("axis": "object")", R"("axis": "together")");
  load("tuned");
  auto* use = find<QPushButton>("apply_recommended");
  ASSERT_TRUE(wait_until([&] { return use->isVisible(); }));
  settle();
  EXPECT_EQ(use->text(), "Use recommended:\nk_t 600 N/m, k_r 0.0330 N·m/rad");
  EXPECT_EQ(use->visibleRegion().boundingRect(), use->rect());
}

TEST_F(StiffnessTest, the_view_says_beside_the_force_how_far_the_boundary_is) {
  const auto said = [&] { return stiffness().note().text; };
  // A prediction, so it names the hand that it is for; nothing is wrong now.
  const QString study = "by the study of sigma.7:\n";
  const QString by =
      " in conforming contact,\nlimited by stability (conforming contact, light hand)";
  const QString could = study + "could be 1.20 times as stiff" + by;
  const QString too = study + "3.00 times too stiff" + by;
  load("fitting");
  EXPECT_TRUE(wait_until([&] { return said() == could; })) << said().toStdString();
  auto* hints = find<QWidget>("hint_view");
  settle();
  const QImage within = hints->grab().toImage();
  find<TypedValue>("k_value")->setValue(1800);
  EXPECT_TRUE(wait_until([&] { return said() == too; })) << said().toStdString();
  settle();
  EXPECT_GT(pixels_between(within, hints->grab().toImage()), 50);
  EXPECT_TRUE(stiffness().note().now.isEmpty()) << "measured: the hand feels no buzzing";
  EXPECT_TRUE(stiffness().note().course.empty()) << "it does not buzz with the mouse alone";
  // A real device may be another than the map's.
  stiffness().set_holder({std::nullopt, "force-42", "omega.7"});
  EXPECT_TRUE(wait_until([&] { return said().isEmpty(); })) << said().toStdString();
  EXPECT_TRUE(text("tuning_doubt").contains("This map is of sigma.7. Whether omega.7 is one"));
  stiffness().set_holder({std::nullopt, "arm-7", "Sigma.7 right-handed"});
  EXPECT_TRUE(wait_until([&] { return said() == too; })) << said().toStdString();
  EXPECT_TRUE(text("tuning_doubt").isEmpty()) << text("tuning_doubt").toStdString();
  stiffness().set_holder({std::nullopt, "Mouse", {}});
  EXPECT_TRUE(wait_until([&] { return !said().isEmpty(); }));
  // Of another pair, it tells nothing of this one.
  write_canned_study(folder / "other", folder / "large.off", folder / "cube.off");
  load("other");
  EXPECT_TRUE(wait_until([&] { return said().isEmpty(); })) << said().toStdString();
}

/// What the window does at its end is not needed: the first one is still there when the next opens
/// the scene, as after a kill.
TEST_F(StiffnessTest, typed_gains_are_there_again_after_a_kill_for_their_scene_and_device) {
  const auto hold_by = [](MainWindow& by, const char* what) {
    auto* sources = by.findChild<QComboBox*>("holder");
    emit sources->activated(sources->findText(what));
  };
  type("k_value", "800");
  QTest::mouseClick(find<QPushButton>("gains_b"), Qt::LeftButton);
  type("k_value", "650");
  ASSERT_EQ(k(), 650);
  hold_by(*window, "omega.7 (simulated)");
  EXPECT_EQ(k(), 650) << "nothing was kept for that one yet";
  type("k_value", "90");
  hold_by(*window, "Mouse");
  EXPECT_EQ(k(), 650);
  hold_by(*window, "omega.7 (simulated)");
  EXPECT_EQ(k(), 90);
  wait(600);

  MainWindow next;
  int opened_there = 0;
  QObject::connect(&next, &MainWindow::opened, [&] { ++opened_there; });
  next.prompts().report_error = [this](const QString& text) { complaints.push_back(text); };
  next.open({QString::fromStdString(scene.string())});
  ASSERT_TRUE(wait_until([&] { return opened_there > 0; }));
  const auto k_there = [&] { return next.session()->coupling().k; };
  EXPECT_EQ(k_there(), 650);
  EXPECT_EQ(next.stiffness().sets().active(), 1u);
  EXPECT_EQ(next.stiffness().sets().gains(0).k, 800);
  hold_by(next, "omega.7 (simulated)");
  EXPECT_EQ(k_there(), 90);
  next.findChild<QPushButton*>("gains_as_opened")->click();
  EXPECT_EQ(k_there(), 500) << "the scene's own are one click away";
  // A scene that somebody has changed counts. (These two may see the change before they end.)
  for (MainWindow* open : {window.get(), &next})
    open->prompts().ask_reload = [](const QString&) { return false; };
  hold_by(next, "Mouse");
  folder.write("cubes.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "cube.off", "pose": [0.09, 0.02, 0.013, 1, 0, 0, 0]},
      "fixed": {"mesh": "cube.off"}, "coupling": {"mode": "object", "k": 300}})");
  MainWindow after;
  opened_there = 0;
  QObject::connect(&after, &MainWindow::opened, [&] { ++opened_there; });
  after.open({QString::fromStdString(scene.string())});
  ASSERT_TRUE(wait_until([&] { return opened_there > 0; }));
  EXPECT_EQ(after.session()->coupling().k, 300);
  EXPECT_TRUE(complaints.empty()) << complaints[0].toStdString();
}

}  // namespace
}  // namespace sonde::ui::test
