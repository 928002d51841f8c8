// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the window is, and what it takes. Times are printed, not asserted: they are the
// machine's, and others' work on it is in them.
// Memory is the kernel's count. A case that runs after another in one process takes less than it
// does alone: it is given what the other has freed.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QProcess>
#include <QScreen>
#include <QThread>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/ui/torus_text.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/freed_memory.hpp"
#include "ui/base/progress_dialog.hpp"
#include "ui/base/theme.hpp"

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
