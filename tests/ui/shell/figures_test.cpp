// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the window is, and what it takes. Times are printed, not asserted: they are the
// machine's, and others' work on it is in them.
// Memory is the kernel's count. A case that runs after another in one process takes less than it
// does alone: it is given what the other has freed.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QThread>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "tests/ui/torus_text.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/way_in_control.hpp"
#include "ui/base/freed_memory.hpp"
#include "ui/base/progress_dialog.hpp"
#include "ui/base/theme.hpp"
#include "ui/document/instant.hpp"
#include "ui/panels/way_in_panel.hpp"

namespace sonde::ui::test {
namespace {

double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Bytes of memory that the process has in use, but for the pages of programs and libraries.
double resident() {
  std::ifstream in("/proc/self/statm");
  double all = 0, here = 0, of_files = 0;
  in >> all >> here >> of_files;
  return (here - of_files) * double(sysconf(_SC_PAGESIZE));
}

/// A new count of the most memory in use begins.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

/// The most bytes in use since then. What is read of the pages of files is as of now.
double peak() {
  std::ifstream in("/proc/self/status");
  double kilobytes = 0, of_files = 0;
  for (std::string word; in >> word;) {
    if (word == "VmHWM:") in >> kilobytes;
    if (word == "RssFile:") in >> of_files;
  }
  return 1024 * (kilobytes - of_files);
}

class Figures : public WindowTest {
 protected:
  static void SetUpTestSuite() { return_freed_memory(); }  // as the program does
  struct Rate {
    double frames = 0, processor = 0;  ///< a second; s of processor a second
  };
  /// The camera turns, as it does while a person looks round, and the probe moves.
  Rate rate_while_moving(double seconds) {
    const Pose start = window->session()->device_pose();
    const double radius = window->session()->probe().mass.radius;
    const std::size_t before = window->frames();
    const double processor = processor_seconds();
    QElapsedTimer clock;
    clock.start();
    for (double now = 0; now < seconds; now = 1e-3 * double(clock.elapsed())) {
      Pose pose = start;
      pose.p.x() += 0.1 * radius * std::sin(5 * now);
      window->set_device_pose(pose);
      window->viewport().camera().orbit(0.01, 0);
      window->viewport().invalidate();
      QApplication::processEvents(QEventLoop::AllEvents, 4);
      QThread::usleep(500);
    }
    const double passed = 1e-3 * double(clock.elapsed());
    return {double(window->frames() - before) / passed, (processor_seconds() - processor) / passed};
  }
  /// What a session takes with any bodies, and what OpenGL does, is there before: 12 triangles are
  /// open, their servo paused.
  void open_tori(int n) {
    open_cubes();
    window->set_paused(true);
    picture();
    folder.write("torus.off", torus(n));
    folder.write("tori.sonde.json", R"({"fixed": {"mesh": "torus.off"},
        "probe": {"mesh": "torus.off", "pose": [0.1, 0, 0, 0.8, 0.6, 0, 0]}})");
    const double before = resident(), processor = processor_seconds();
    forget_peak();
    bool progress = false;
    QElapsedTimer clock;
    clock.start();
    const int had = opened;
    window->open({path("tori.sonde.json")});
    ASSERT_TRUE(wait_until([&] {
      const auto* dialog = window->findChild<ProgressDialog*>();
      progress = progress || (dialog && dialog->isVisible());
      return opened > had;
    }));
    const double seconds = 1e-3 * double(clock.elapsed());
    const double at_most_opening = peak() - before;
    forget_peak();
    picture();
    ASSERT_TRUE(wait_until([this] { return window->viewport().simplified_made(); }));
    const double at_most_open = peak() - before;
    const double triangles = 4.0 * n * n;
    std::printf("%.0f triangles a side: open in %.2f s, %.2f s of processor, progress %s; ",
                triangles / 2, seconds, processor_seconds() - processor,
                progress ? "shown" : "none");
    std::printf("%.0f bytes a triangle, %.0f at most while copies are made, %.0f while it opens\n",
                (resident() - before) / triangles, at_most_open / triangles,
                at_most_opening / triangles);
    const Rate rate = rate_while_moving(4);
    std::printf("    %.1f frames a second while moving, %.2f processors\n", rate.frames,
                rate.processor);
    std::fflush(stdout);
  }
};

TEST_F(Figures, Full_a_million_triangles_a_side) { open_tori(707); }
TEST_F(Figures, Full_three_hundred_thousand_a_side) { open_tori(387); }

/// Two tori of a million triangles, one over the other with room between: while the probe and the
/// picture move, how often there is the clearance of the pose that the probe has just then.
TEST_F(Figures, Full_clearance_of_a_million_triangles_a_side) {
  folder.write("torus.off", torus(707));
  folder.write("apart.sonde.json", R"({"fixed": {"mesh": "torus.off"},
      "probe": {"mesh": "torus.off", "pose": [0.02, 0, 0.09, 1, 0, 0, 0]}})");
  open({path("apart.sonde.json")});
  ASSERT_TRUE(wait_until([this] { return window->viewport().simplified_made(); }));
  const Pose start = window->session()->device_pose();
  find<QDockWidget>("readout_panel")->hide();
  for (const bool measured : {false, true, false, true}) {
    window->viewport().set_shown(Layer::clearance, measured);
    const std::size_t before = window->frames();
    const double processor = processor_seconds();
    int asked = 0, here = 0;
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 5000) {
      Pose pose = start;
      pose.p.x() += 0.01 * std::sin(5e-3 * double(clock.elapsed()));
      window->set_device_pose(pose);
      window->viewport().camera().orbit(0.01, 0);
      window->viewport().invalidate();
      const std::size_t frames = window->frames();
      while (window->frames() == frames) QApplication::processEvents(QEventLoop::AllEvents, 2);
      if (!measured) continue;
      const auto found = window->session()->clearance(pose);
      ++asked;
      here += found && same_pose(found->device, pose);
    }
    const double seconds = 1e-3 * double(clock.elapsed());
    const double frames = double(window->frames() - before);
    std::printf("clearance %-3s: %.1f frames a second, %.1f ms of processor each",
                measured ? "on" : "off", frames / seconds,
                1e3 * (processor_seconds() - processor) / frames);
    if (measured) std::printf(", %d of %d with the clearance of their own pose", here, asked);
    std::printf("\n");
    std::fflush(stdout);
  }
}

/// One mesh in rows, many times.
struct Rows {
  std::string parts;  ///< as a list of a scene's parts, of torus.off
  std::string all;    ///< as OFF text
};

Rows in_rows(const std::string& one, int count, int across) {
  Rows out;
  std::string corners, faces;
  std::size_t points = 0, polygons = 0;
  for (int k = 0; k < count; ++k) {
    const double x = 0.3 * (k % across), y = 0.3 * double(k / across);
    std::istringstream in(one);
    std::string word;
    std::size_t vertices = 0, triangles = 0, none = 0;
    in >> word >> vertices >> triangles >> none;
    for (std::size_t i = 0; i < vertices; ++i) {
      double p[3];
      in >> p[0] >> p[1] >> p[2];
      corners += std::to_string(p[0] + x) + ' ' + std::to_string(p[1] + y) + ' ' +
                 std::to_string(p[2]) + '\n';
    }
    for (std::size_t i = 0; i < triangles; ++i) {
      std::size_t t[4];
      in >> t[0] >> t[1] >> t[2] >> t[3];
      faces += "3 " + std::to_string(t[1] + points) + ' ' + std::to_string(t[2] + points) + ' ' +
               std::to_string(t[3] + points) + '\n';
    }
    points += vertices, polygons += triangles;
    out.parts += (k == 0 ? "[" : ", ");
    out.parts += R"({"name": ")" + std::to_string(k) + R"(", "mesh": "torus.off", "pose": [)" +
                 std::to_string(x) + ", " + std::to_string(y) + ", 0, 1, 0, 0, 0]}";
  }
  out.parts += "]";
  out.all =
      "OFF\n" + std::to_string(points) + ' ' + std::to_string(polygons) + " 0\n" + corners + faces;
  return out;
}

constexpr const char* beside =
    R"({"probe": {"mesh": "cube.off", "pose": [1.3, 0.6, 0.03, 1, 0, 0, 0]}, "fixed": )";

/// Fifty tori of 20 000 triangles as parts, and as one mesh.
TEST_F(Figures, Full_frames_of_fifty_parts_and_of_one_mesh) {
  folder.write("torus.off", torus(100));
  const Rows rows = in_rows(torus(100), 50, 10);
  folder.write("all.off", rows.all);
  folder.write("parts.sonde.json", beside + rows.parts + "}");
  folder.write("one.sonde.json", std::string(beside) + R"({"mesh": "all.off"}})");
  for (int times = 0; times < 4; ++times)
    for (const char* name : {"one.sonde.json", "parts.sonde.json"}) {
      open({path(name)});
      ASSERT_TRUE(wait_until([this] { return window->viewport().simplified_made(); }));
      const Rate rate = rate_while_moving(4);
      std::printf(
          "%-16s %5.1f frames a second while moving, %.1f ms of processor each, %zu triangles\n",
          name, rate.frames, 1e3 * rate.processor / rate.frames,
          window->session()->fixed().soup.triangles.size());
      std::fflush(stdout);
    }
}

/// As many parts as there may be, of 50 triangles: all alike, and each a component of one file.
TEST_F(Figures, Full_ten_thousand_parts) {
  folder.write("torus.off", torus(5));
  const Rows rows = in_rows(torus(5), 10'000, 100);
  folder.write("all.off", rows.all);
  folder.write("alike.sonde.json", beside + rows.parts + "}");
  folder.write("components.sonde.json",
               std::string(beside) + R"({"mesh": "all.off", "components": true}})");
  for (const char* name : {"alike.sonde.json", "components.sonde.json"}) {
    const double processor = processor_seconds();
    QElapsedTimer clock;
    clock.start();
    open({path(name)});
    std::printf("%-22s open in %.2f s, %.2f s of processor\n", name, 1e-3 * double(clock.elapsed()),
                processor_seconds() - processor);
    std::fflush(stdout);
  }
}

/// The longest turn of the event loop, all drawing in it, while each dock is opened for the first
/// time, and while the first ways in are shown.
TEST_F(Figures, Full_first_pictures_of_the_docks) {
  const auto longest_turn = [](const char* what, const std::function<bool()>& done) {
    double longest = 0;
    QElapsedTimer all, turn;
    all.start();
    bool ended = false;
    for (double rest = 0; rest < 400;) {  // ms after the end
      turn.start();
      QApplication::processEvents(QEventLoop::AllEvents, 0);
      longest = std::max(longest, 1e-6 * double(turn.nsecsElapsed()));
      QThread::usleep(500);
      if (!ended && done()) ended = true, all.restart();
      rest = ended ? double(all.elapsed()) : 0;
    }
    std::printf("%-22s %6.1f ms\n", what, longest);
    std::fflush(stdout);
  };
  open({QStringLiteral(SONDE_RESOURCES "/scenes/peg-in-hole.sonde.json")});
  settle();
  const auto now = [] { return true; };
  longest_turn("nothing", now);
  for (QDockWidget* dock : window->docks_of_sides()) {
    dock->show();
    longest_turn(qPrintable(dock->objectName()), now);
  }
  window->way_in().panel().show();
  for (const char* time : {"first", "second"}) {
    find<QPushButton>("way_compute")->click();
    longest_turn((std::string(time) + " way in").c_str(),
                 [this] { return !find<QLabel>("way_summary")->text().isEmpty(); });
    type("map_across", "5");
    find<QPushButton>("map_compute")->click();
    longest_turn((std::string(time) + " map").c_str(),
                 [this] { return !window->way_in().map().free.empty(); });
  }
}

TEST_F(Figures, Full_frames_of_the_bundled_scenes) {
  for (const char* name : {"crumpled-soup", "linked-tori", "nut-on-bolt", "peg-in-hole",
                           "spoon-in-cup", "terrain", "torus-knots"}) {
    open({QStringLiteral(SONDE_RESOURCES "/scenes/%1.sonde.json").arg(name)});
    const Rate rate = rate_while_moving(3);
    std::printf("%-14s %5.1f frames a second while moving, %.2f processors\n", name, rate.frames,
                rate.processor);
    std::fflush(stdout);
  }
}

/// From the start of the program until the fixed body is seen on the screen.
TEST_F(Figures, Full_start_to_the_first_picture) {
  window->hide();
  for (int run = 0; run < 5; ++run) {
    QProcess program;
    QElapsedTimer clock;
    clock.start();
    program.start(QStringLiteral(SONDE_VIEW_PROGRAM),
                  {QStringLiteral(SONDE_RESOURCES "/scenes/spoon-in-cup.sonde.json")});
    const auto bodies_seen = [] {
      const QImage screen = QApplication::primaryScreen()->grabWindow(0).toImage();
      int count = 0;
      for (int y = 0; y < screen.height(); y += 4)
        for (int x = 0; x < screen.width(); x += 4) {
          const QColor at = screen.pixelColor(x, y);
          const bool orange = std::abs(at.hsvHue() - colour::probe.hsvHue()) < 8;
          count += orange && at.hsvSaturation() > 150 && at.value() > 60;
        }
      return count > 200;
    };
    EXPECT_TRUE(wait_until(bodies_seen));
    std::printf("first picture after %.2f s\n", 1e-3 * double(clock.elapsed()));
    std::fflush(stdout);
    program.terminate();
    program.waitForFinished();
  }
}

}  // namespace
}  // namespace sonde::ui::test
