// SPDX-License-Identifier: GPL-3.0-or-later
// References: the profile that a device is simulated from.
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/settings/device_profile.hpp"
#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Identify : public AppTest {
 protected:
  DeviceProfile profile(const std::string& file) { return read_device_profile(folder / file); }
};

TEST_F(Identify, a_simulated_device_is_recovered_and_written_as_a_profile) {
  const Outcome run =
      expect_done("identify --simulated sigma.7 --out mine.json --record answer.csv");
  EXPECT_THAT(run.out, HasSubstr("rotational_friction"));
  EXPECT_THAT(run.out, HasSubstr("force along z: 16 pulses of up to 2 N"));
  const DeviceProfile mine = profile("mine.json");
  EXPECT_NEAR(mine.mass.value, 0.3, 0.05 * 0.3);
  EXPECT_NEAR(mine.damping.value, 2, 0.05 * 2);
  EXPECT_NEAR(mine.friction.value, 0.4, 0.05 * 0.4);
  EXPECT_NEAR(mine.delay.value, 1e-3, 0.05 * 1e-3);
  EXPECT_NEAR(mine.resolution.value, 2e-6, 0.05 * 2e-6);
  EXPECT_NEAR(mine.inertia.value, 2e-4, 0.05 * 2e-4);
  ASSERT_TRUE(mine.mass.interval);
  EXPECT_LT(mine.mass.interval->low, mine.mass.interval->high);
  EXPECT_THAT(assumed_keys(mine), testing::IsEmpty());
  EXPECT_THAT(mine.mass.origin, HasSubstr("96 pulses of the simulated device sigma.7"));
  EXPECT_EQ(mine.max_force.value, 12);
  EXPECT_THAT(mine.max_force.origin, HasSubstr("CHAI3D"));
}

/// The share of ticks of 1 ms at which this machine wakes a thread over half a millisecond late.
double late_ticks() {
  constexpr int ticks = 4000;
  int late = 0;
  auto due = std::chrono::steady_clock::now();
  for (int i = 0; i < ticks; ++i) {
    due += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(due);
    late += std::chrono::steady_clock::now() - due > std::chrono::microseconds(500);
  }
  return double(late) / ticks;
}

/// With the stand-in for the maker's library.
class IdentifyConnected : public Identify {
 protected:
  IdentifyConnected() {
    ::setenv("SONDE_LIBDHD", STANDIN_DHD, 1);
    ::setenv("STANDIN_FREE_MASS", "0.3", 1);
  }
  ~IdentifyConnected() override {
    ::unsetenv("STANDIN_FREE_MASS");
    ::unsetenv("SONDE_LIBDHD");
  }
  // Reference: the mass and the damping that the stand-in moves with. A busy machine makes the
  // times of the samples uncertain, which widens the intervals.
  void expect_measured(const Outcome& run) {
    const DeviceProfile mine = profile("mine.json");
    EXPECT_NEAR(mine.mass.value, 0.3, 0.1 * 0.3);
    EXPECT_NEAR(mine.damping.value, 2, 0.25 * 2);
    // Ticks that come late cost pulses, of which there are 48. An axis takes 8, and may be left
    // out: the profile counts those of the axes that the report counts.
    const auto before_count = mine.mass.origin.find(", ");
    ASSERT_NE(before_count, std::string::npos) << mine.mass.origin;
    int reported = 0;
    for (std::size_t at = 0; (at = run.out.find(" pulses of up to", at)) != std::string::npos; ++at)
      reported += std::stoi(run.out.substr(run.out.rfind(' ', at - 1) + 1));
    EXPECT_EQ(std::stoi(mine.mass.origin.substr(before_count + 2)), reported) << run.out;
    EXPECT_THAT(mine.mass.origin, HasSubstr(" pulses of the connected device libdhd/0"));
    EXPECT_EQ(mine.max_force.origin, "the connected device's own word");
    EXPECT_GT(text_of(folder / "answer.csv").size(), 100'000u);
  }
  const std::string flags = "identify --connected libdhd/0 --device omega.7 --out mine.json ";
  const std::string consent = "--hands-off --record answer.csv";
};

TEST_F(IdentifyConnected, it_takes_consent_and_a_device_that_is_there) {
  const Outcome asked = sonde(flags);
  EXPECT_EQ(asked.exit_code, 2);
  EXPECT_THAT(asked.err, HasSubstr("up to 2 N and 0.05 N·m: let go of it"));
  ::unsetenv("SONDE_LIBDHD");
  const Outcome gone = sonde(flags + consent);
  EXPECT_EQ(gone.exit_code, 3);
  EXPECT_THAT(gone.err, HasSubstr("libdhd/0: no 6-DoF device is connected at libdhd/0"));
}

// A machine that wakes so late that few pulses are whole is refused, and that it is such a one is
// shown by a clock of its own.
TEST_F(IdentifyConnected, a_device_is_measured_or_the_machine_is_too_late_to) {
  const Outcome run = sonde(flags + consent);
  if (run.exit_code == 0) return expect_measured(run);
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("samples are missing in"));
  EXPECT_FALSE(std::filesystem::exists(folder / "mine.json"));
  // Of a pulse of some 130 ticks, less than two in three are then whole.
  EXPECT_GT(late_ticks(), 0.003) << "refused on a machine that keeps time: " << run.err;
}

// Requires a machine that keeps a rate of 1 kHz.
TEST_F(IdentifyConnected, Full_a_device_is_measured) {
  const Outcome run = sonde(flags + consent);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expect_measured(run);
}

TEST_F(Identify, a_recording_says_the_same_as_the_device_that_it_is_of) {
  const Outcome first = expect_done("identify --simulated touch --out a.json --record answer.csv");
  const Outcome again = expect_done("identify answer.csv --device touch --out b.json");
  EXPECT_EQ(again.out, first.out);
  EXPECT_THAT(text_of(folder / "b.json"), HasSubstr("48 pulses of answer.csv"));
  EXPECT_EQ(profile("b.json").mass.value, profile("a.json").mass.value);
  // No motors for torque: what was assumed of rotations stays so.
  EXPECT_THAT(assumed_keys(profile("b.json")),
              testing::ElementsAre("inertia", "rotational_damping", "rotational_friction",
                                   "rotational_resolution"));
}

TEST_F(Identify, all_rows_is_said_of_a_recording_alone) {
  const Outcome refused = sonde("identify --simulated touch --all-rows");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--all-rows is of a RECORDING"));
  expect_done("identify --simulated touch --record answer.csv");
  const Outcome plain = expect_done("identify answer.csv --device touch");
  EXPECT_EQ(expect_done("identify answer.csv --device touch --all-rows").out, plain.out);
}

TEST_F(Identify, tune_takes_the_profile_and_varies_nothing_that_was_measured) {
  expect_done("identify --simulated sigma.7 --out mine.json");
  expect_done(
      "tune boxes.sonde.json --device mine.json --trajectory path.csv --ratio 2 --out tuned");
  EXPECT_THAT(text_of(folder / "tuned/coupling.json"), HasSubstr("\"k\""));
  for (const auto& part : std::filesystem::directory_iterator(folder / "tuned/parts"))
    EXPECT_LE(std::ranges::count(part.path().filename().string(), '.'), 3)
        << part.path() << ": SITUATION.HAND.AXIS.json has no varied value";
}

TEST_F(Identify, json_holds_every_axis_and_pulses_stay_within_the_limit) {
  const Outcome run = expect_done("identify --simulated omega.7 --force 1.5 --json");
  const json result = json::parse(run.out);
  ASSERT_EQ(result["axes"].size(), 3u);
  EXPECT_EQ(result["axes"][1]["axis"], "force along y");
  EXPECT_EQ(result["axes"][1]["largest_command"], 1.5);
  EXPECT_NEAR(result["values"]["mass"]["value"], 0.25, 0.05 * 0.25);
  EXPECT_EQ(result["values"]["mass"]["profile"], 0.25);
  EXPECT_EQ(result["values"]["mass"]["unit"], "kg");
}

TEST_F(Identify, where_one_file_cannot_be_written_neither_is) {
  EXPECT_EQ(sonde("identify --simulated omega.7 --record a.csv --out /proc/none.json").exit_code,
            3);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST_F(Identify, a_recording_that_tells_nothing_is_refused_with_its_reason) {
  folder.write("still.csv",
               "t,fx,fy,fz,tx,ty,tz,px,py,pz,qw,qx,qy,qz\n"
               "0,0,0,0,0,0,0,0,0,0,1,0,0,0\n0.001,0,0,0,0,0,0,0,0,0,1,0,0,0\n");
  folder.write("bad.csv", "t,fx,fy,fz,tx,ty,tz,px,py,pz,qw,qx,qy,qz\n0,0,0,0,0,0,0,0,0,0,1,0,0\n");
  expect_refused("identify still.csv --device touch --out p.json", 3,
                 "still.csv: no pulse in the recording");
  expect_refused("identify bad.csv --device touch --out p.json", 3, "bad.csv:2: 13 columns");
  expect_refused("identify none.csv --device touch", 3, "none.csv");
  expect_refused("identify --simulated touch --force 0.1 --out p.json", 3,
                 "touch: no axis can be identified: force along x: the handle did not move");
}

TEST_F(Identify, flags_that_contradict_each_other_are_wrong_usage) {
  folder.write("a.csv", "");
  expect_refused("identify", 2, "either a RECORDING, --simulated or --connected");
  expect_refused("identify a.csv --simulated touch", 2,
                 "either a RECORDING, --simulated or --connected");
  expect_refused("identify a.csv", 2, "--device is missing");
  expect_refused("identify a.csv --device touch --record b.csv", 2, "--record needs --simulated");
  expect_refused("identify a.csv --device touch --out a.csv", 2, "is one of the inputs");
  expect_refused("identify --simulated touch --record b --out b", 2, "name the same file");
  expect_refused("identify --simulated touch --record ./b --out b", 2, "name the same file");
  expect_refused("identify a.csv --device touch --force 1", 2, "a recording has its own pulses");
  expect_refused("identify --simulated touch --force 0", 2, "above zero");
  expect_refused("identify --simulated tuch", 2, "\"touch\"");
}

}  // namespace
}  // namespace sonde::test
