// SPDX-License-Identifier: GPL-3.0-or-later
// The desktop program's window for an hour, every minute the same: three scenes, a SpaceMouse that
// umockdev plays and that is unplugged and plugged in again, a recording, and a scene that is
// saved. Its memory must not grow. Times are printed, not asserted.

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <QLabel>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

#include "engine/recording/recording_header.hpp"
#include "engine/scene/scene.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/mock_hid.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/base/freed_memory.hpp"
#include "ui/devices/device_control.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::joint_descriptor;
using sonde::test::MockHid;
using sonde::test::MockSystem;
using sonde::test::words;

constexpr const char* scenes[] = {"spoon-in-cup", "torus-knots", "linked-tori"};

double resident_mib() {
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return double(pages) * double(sysconf(_SC_PAGESIZE)) / 1048576;
}

/// What malloc has handed out and not got back.
double allocated_mib() {
  const struct mallinfo2 heap = mallinfo2();
  return double(heap.uordblks + heap.hblkhd) / 1048576;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

class Endurance : public WindowTest {
 protected:
  struct Minute {
    double resident = 0, allocated = 0;  ///< MiB at its end
    std::uint64_t ticks = 0, late = 0, dropped = 0;
    double ahead = 0;   ///< ticks more than the clock asks for, the most of a scene
    double gained = 0;  ///< the same of all its scenes together: a wrong rate adds up
    int in_contact = 0;
  };

  void SetUp() override {
    puck.descriptor = joint_descriptor();
    return_freed_memory();  // as the program does
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    plug();
    window->devices().choose(find_source("auto", {}));
    window->prompts().ask_save = [this](const QString&) { return path("saved.sonde.json"); };
  }
  void TearDown() override { window.reset(); }

  /// Under the next number each time, as the test bed wants it.
  void plug() {
    ++puck.number;
    system.plug(puck);
  }
  std::string status() const {
    return window->findChild<QLabel*>("device_status")->text().toStdString();
  }
  /// Open, though it may have said nothing for a while.
  bool there() {
    const DeviceState state = window->devices().report().device.state;
    return state == DeviceState::ready || state == DeviceState::silent;
  }

  /// The hand pushes the puck round, about 62 times a second, and ends where it began.
  void push_round(double seconds, Minute& minute) {
    QElapsedTimer clock;
    clock.start();
    for (double now = 0; now < seconds; now = 1e-3 * double(clock.elapsed())) {
      const double round = 2 * M_PI * now / seconds;
      const auto part = [](double x) { return static_cast<int>(150 * x); };
      system.send(puck.number, words(1, {part(std::sin(round)), part(std::cos(round)),
                                         part(std::sin(2 * round)), 0, 0, part(std::cos(round))}));
      wait(16);
      minute.in_contact += shown().separation.status == Status::penetrating;
    }
  }

  void one_scene(const char* name, double seconds, Minute& minute) {
    const std::string file = std::string(SONDE_RESOURCES "/scenes/") + name + ".sonde.json";
    open({QString::fromStdString(file)});
    ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
    ASSERT_TRUE(wait_until([this] { return there(); })) << status();
    const QString recording = path("run.sonderec");
    window->history().record(recording);
    const std::uint64_t first = window->session()->timing().ticks;
    QElapsedTimer clock;
    clock.start();

    push_round(seconds / 2, minute);
    system.unplug(puck.number);
    ASSERT_TRUE(wait_until([this] { return !there(); })) << status();
    plug();
    ASSERT_TRUE(wait_until([this] { return there(); })) << status();
    push_round(seconds / 2, minute);

    const ServoTiming timing = window->session()->timing();
    const double elapsed = 1e-3 * double(clock.elapsed());
    const double rate = window->devices().servo().rate_hz;
    const double ahead = double(timing.ticks - first) - rate * elapsed;
    if (std::abs(ahead) > std::abs(minute.ahead)) minute.ahead = ahead;
    minute.gained += ahead;
    minute.ticks += timing.ticks;
    minute.late += timing.late;
    minute.dropped += window->session()->ticks_dropped();

    ASSERT_TRUE(window->documents().save_as());
    EXPECT_EQ(std::filesystem::weakly_canonical(read_scene(folder / "saved.sonde.json").probe.mesh),
              std::filesystem::weakly_canonical(read_scene(file).probe.mesh));
    window->history().set_recording(false);
    EXPECT_TRUE(wait_until([&] { return !window->history().recorder().ending(); }));
    EXPECT_TRUE(is_recording(recording.toStdString()));
    std::filesystem::remove(recording.toStdString());
  }

  Minute one_minute(double seconds) {
    Minute minute;
    for (const char* name : scenes) {
      one_scene(name, seconds / std::size(scenes), minute);
      if (HasFatalFailure()) break;
    }
    minute.resident = resident_mib();
    minute.allocated = allocated_mib();
    return minute;
  }

  static void print(std::size_t number, const Minute& m) {
    const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf(
        "minute %2zu: resident %7.1f MiB, allocated %7.1f MiB, ticks %llu, late %llu (%.2f %%), "
        "dropped %llu, ahead of the clock by %+.0f ticks at most\n",
        number, m.resident, m.allocated, count(m.ticks), count(m.late),
        100.0 * double(m.late) / double(std::max<std::uint64_t>(m.ticks, 1)), count(m.dropped),
        m.ahead);
    std::fflush(stdout);
  }

  MockSystem system;
  MockHid puck;
};

TEST_F(Endurance, scenes_change_devices_come_and_go_and_all_is_saved) {
  for (std::size_t i = 1; i <= 2 && !HasFatalFailure(); ++i) print(i, one_minute(3));
}

/// SONDE_SOAK_MINUTES asks for another number of minutes than 60.
TEST_F(Endurance, Soak_an_hour_in_flat_memory) {
  const char* asked = std::getenv("SONDE_SOAK_MINUTES");
  const auto minutes = static_cast<std::size_t>(asked ? std::max(std::atoi(asked), 1) : 60);
  constexpr std::size_t settled = 5, compared = 5;
  // Work of others may hold up the end of a scene of 20 s by some 10 ms.
  constexpr double most_drift = 0.001;
  std::vector<double> resident;
  double gained = 0, ticks = 0;
  for (std::size_t i = 1; i <= minutes && !HasFatalFailure(); ++i) {
    const Minute minute = one_minute(60);
    print(i, minute);
    EXPECT_GT(minute.in_contact, 0) << "a whole minute of pushing meets nothing";
    EXPECT_EQ(minute.dropped, 0U) << "ticks that no recording has";
    // Work of others holds ticks up by a hundred or two in a scene.
    EXPECT_LE(std::abs(minute.ahead), 0.02 * double(minute.ticks) / std::size(scenes));
    gained += minute.gained;
    ticks += double(minute.ticks);
    resident.push_back(minute.resident);
  }
  ASSERT_FALSE(HasFatalFailure());
  std::printf("against the clock %+.0f of %.0f ticks in all: %+.3f %%\n", gained, ticks,
              100 * gained / ticks);
  EXPECT_LE(std::abs(gained), most_drift * ticks);
  if (minutes < settled + 2 * compared) return;  // too few to compare
  const auto first = resident.begin() + settled;
  const double before = median({first, first + compared});
  const double after = median({resident.end() - compared, resident.end()});
  std::printf("resident after five minutes %.1f MiB, at the end %.1f MiB: %+.2f %%\n", before,
              after, 100 * (after / before - 1));
  EXPECT_LE(after, 1.01 * before);
}

}  // namespace
}  // namespace sonde::ui::test
