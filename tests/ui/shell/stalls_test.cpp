// SPDX-License-Identifier: GPL-3.0-or-later
// The window's thread while a person works: no event waits long. Reference: the watchdog's own
// clock, with the kernel's count of what the thread waited for a processor.

#include <gtest/gtest.h>

#include <QSlider>
#include <cstdio>

#include "tests/ui/torus_text.hpp"
#include "tests/ui/watchdog.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/export_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/actions/seeing_control.hpp"

namespace sonde::ui::test {
namespace {

constexpr double most_ms = 50;

class Stalls : public WindowTest {
 protected:
  void place(const Vec3& by) {
    Pose X_FM = window->session()->device_pose();
    X_FM.p += by;
    window->documents().place(X_FM, QStringLiteral("Place the probe"));
    ASSERT_TRUE(wait_until(
        [&] { return window->shown() && (shown().separation.device.p - X_FM.p).norm() < 1e-12; }));
  }
  void run(Watchdog& dog, const char* what, const std::function<void()>& act) {
    wait(100);
    dog.during(what);
    act();
    wait(100);
  }
  void exporter_answers() {
    window->exporter().ask_file = [this](const QString&, const QString&, const QString&) {
      return target;
    };
    window->exporter().ask_picture = [](ExportDialog::Of) {
      PictureWanted wanted;
      wanted.options.size = {640, 480};
      wanted.frames = 3;
      wanted.span = {0, 1, 3};
      return std::optional(wanted);
    };
  }
  void expect_alive(const Watchdog& dog) {
    for (const Watchdog::Stall& stall : dog.longest()) {
      std::printf("%6.1f ms, %6.1f drawing, %6.1f without a processor: %s\n", stall.ms,
                  stall.drawing, stall.elsewhere, stall.during.c_str());
      EXPECT_LE(stall.ms, most_ms) << stall.during;
    }
    std::printf("longest picture: %.1f ms\n", dog.longest_picture());
    std::fflush(stdout);
  }
  QString target;
};

TEST_F(Stalls, Full_no_event_waits_for_more_than_50_ms) {
  folder.write("tori.sonde.json",
               R"({"probe": {"mesh": "torus.off", "pose": [0.1, 0, 0, 0.8, 0.6, 0, 0]},
      "fixed": {"mesh": "torus.off"}, "coupling": {"mode": "object", "k": 500}})");
  folder.write("torus.off", torus(300));  // 180 000 triangles a side
  exporter_answers();
  Watchdog dog;
  run(dog, "open a scene", [this] { open({path("tori.sonde.json")}); });
  run(dog, "place", [this] { place({-0.02, 0.005, 0}); });
  run(dog, "undo and redo", [this] {
    for (const char* name : {"undo", "redo", "undo"}) {
      act(name);
      wait(300);
    }
  });
  run(dog, "reset", [this] { act("reset"), wait(500); });
  run(dog, "drag", [this] { drag(Qt::LeftButton, {500, 400}, {40, -25}); });
  run(dog, "cut", [this] { act("cut"), wait(300), act("cut_flip_now"), wait(300), act("cut"); });
  run(dog, "x-ray", [this] { act("xray_fixed"), wait(300), act("xray_fixed"); });
  run(dog, "wireframe", [this] { act("wire_fixed"), wait(300), act("wire_fixed"); });
  run(dog, "defects", [this] { act("show_defects"), wait(500), act("show_defects"); });
  run(dog, "colours of the gap", [this] { act("gap_colours"), wait(2500), act("gap_colours"); });
  run(dog, "measure", [this] {
    act("measure");
    drag(Qt::LeftButton, {640, 400}, {0, 0});
    wait(200);
    act("measure");
  });
  run(dog, "orbit", [this] { drag(Qt::RightButton, {500, 400}, {90, 30}); });
  HistoryControl& history = window->history();
  run(dog, "record", [&] { history.record(path("a.sonderec")), wait(2500); });
  run(dog, "stop recording", [&] { history.set_recording(false), wait(200); });
  run(dog, "plots", [&] { history.plots().show(), history.plots().raise(), wait(2000); });
  run(dog, "scrub", [&] {
    auto* track = window->findChild<QSlider*>("timeline");
    track->setSliderDown(true);
    for (int i = 0; i < 20; ++i) track->setValue(track->maximum() * i / 20), wait(40);
    track->setSliderDown(false);
  });
  run(dog, "play", [&] { history.play(true), wait(1000), history.go_live(); });
  run(dog, "run again", [&] {
    bool ran = false;
    const auto hears = QObject::connect(&history, &HistoryControl::replayed, [&] { ran = true; });
    history.run_again(Method::pdg, {});
    EXPECT_TRUE(wait_until([&] { return ran; }));
    QObject::disconnect(hears);
    history.go_live();
    history.plots().hide();
  });
  for (const char* name : {"export_picture", "export_tables", "export_vtk", "export_series",
                           "export_gltf", "export_animation", "export_recording_pictures",
                           "export_recording_tables", "export_recording_series"})
    run(dog, name, [&] {
      target = path(name);
      act(name);
      EXPECT_TRUE(wait_until([this] { return !window->exporter().busy(); }));
    });
  run(dog, "swap", [this] {
    act("swap_bodies");
    wait_until([this] { return opened == 2; });
  });
  run(dog, "undo the swap", [this] {
    act("undo");
    wait_until([this] { return opened == 3; });
  });
  run(dog, "save", [this] { act("save"); });
  run(dog, "open a recording", [this] { open({path("a.sonderec")}), wait(500); });
  run(dog, "open two meshes", [this] {
    open({path("torus.off"), path("torus.off")}, 1.0), wait(500);
  });
  run(dog, "new", [this] { act("new"), wait(500); });
  EXPECT_TRUE(complaints.empty()) << complaints[0].toStdString();
  expect_alive(dog);
}

/// Each dock as it is opened for the first time, and a person at work after that. A dock folds the
/// one that was open at its side.
TEST_F(Stalls, Full_nor_while_each_dock_opens) {
  folder.write("torus.off", torus(100));
  folder.write("tori.sonde.json", R"({"fixed": {"mesh": "torus.off"},
      "probe": {"mesh": "torus.off", "pose": [0.1, 0, 0, 0.8, 0.6, 0, 0]}})");
  open({path("tori.sonde.json")});
  wait(1000);
  const QList<QDockWidget*> docks = window->findChildren<QDockWidget*>();
  for (QDockWidget* dock : docks) dock->hide();
  wait(200);
  Watchdog dog;
  for (QDockWidget* dock : docks)
    run(dog, qPrintable(dock->objectName()), [dock] {
      dock->show();
      dock->raise();
      wait(500);
      EXPECT_TRUE(dock->isVisible()) << "one at a side gives way to the next";
    });
  run(dog, "place, docks open", [this] { place({-0.02, 0.005, 0}); });
  run(dog, "undo and redo, docks open", [this] {
    for (const char* name : {"undo", "redo", "undo"}) act(name), wait(100);
  });
  run(dog, "scrub, docks open", [this] {
    auto* track = find<QSlider>("timeline");
    track->setSliderDown(true);
    for (int i = 0; i < 20; ++i) track->setValue(track->maximum() * i / 20), wait(40);
    track->setSliderDown(false);
  });
  expect_alive(dog);
}

}  // namespace
}  // namespace sonde::ui::test
