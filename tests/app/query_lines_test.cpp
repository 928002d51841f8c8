// SPDX-License-Identifier: GPL-3.0-or-later
// How a query is interrupted and continued.
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/platform/writable_file.hpp"
#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

/// A run that is told to end, once some rows are in its part.
class Resumed : public AppTest {
 protected:
  Resumed() {
    std::string poses = "px,py,pz,qw,qx,qy,qz\n";
    for (int i = 0; i < 30; ++i)
      poses += std::to_string(0.02 + 1e-4 * i) + ",0.01,0.02,0.8,0.36,0.48,0\n";
    folder.write("long.csv", poses);
  }
  /// The exit code of a run that is interrupted once a part with two rows is there.
  int interrupted(const std::string& arguments) const {
    const pid_t child = ::fork();
    if (child == 0) {
      ::setpgid(0, 0);
      const std::string line = "cd '" + folder.path().string() + "' && exec '" SONDE_PROGRAM "' " +
                               arguments + " 2>/dev/null";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
      ::_exit(99);
    }
    const auto rows = [this] {
      if (!std::filesystem::exists(folder / "r.part")) return std::ptrdiff_t{0};
      const std::string part = text_of(folder / "r.part");
      return std::count(part.begin(), part.end(), '\n') - 1;
    };
    for (int i = 0; i < 600 && rows() < 2; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::kill(child, SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  static std::vector<std::vector<std::string>> untimed(const std::string& text) {
    return Csv(text).without({"time_us"});
  }
  const std::string run =
      "query boxes.sonde.json --poses long.csv --bound --seeds 20 "
      "--budget-steps 60 --contacts c --out r ";
};

// Reference: a run that is not interrupted.
TEST_F(Resumed, a_part_is_kept_and_the_run_goes_on_from_it_to_the_same_bytes) {
  ASSERT_EQ(interrupted(run), 130);
  EXPECT_FALSE(std::filesystem::exists(folder / "r"));
  ASSERT_TRUE(std::filesystem::exists(folder / "r.part")) << "30 poses took less than a second";
  const std::string part = text_of(folder / "r.part");
  const std::size_t rows = split(part, '\n').size() - 2;
  ASSERT_GT(rows, 0u);
  // A line that was cut off does not count, nor do contacts of poses that are not done.
  folder.write("r.part", part.substr(0, part.size() - 20));
  expect_done(run + "--resume");
  EXPECT_FALSE(std::filesystem::exists(folder / "r.part"));
  EXPECT_FALSE(std::filesystem::exists(folder / "c.part"));
  const std::string resumed = text_of(folder / "r"), contacts = text_of(folder / "c");
  expect_done(run);
  EXPECT_EQ(untimed(resumed), untimed(text_of(folder / "r")));
  EXPECT_EQ(contacts, text_of(folder / "c"));
  // The rows that were there were not computed again: their times are the same.
  const Csv there(resumed);
  const std::vector<std::string> lines = split(part, '\n');
  for (std::size_t i = 0; i + 1 < rows; ++i)
    EXPECT_EQ(there.text(i, "time_us"), split(split(lines[i + 1], '\t').at(0), ',').at(15));
}

// Reference: a run that is not interrupted.
TEST_F(Resumed, rows_count_up_to_the_first_that_was_changed) {
  ASSERT_EQ(interrupted(run), 130);
  const std::string rows = text_of(folder / "r.part"), contacts = text_of(folder / "c.part");
  expect_done(run);
  const auto whole = untimed(text_of(folder / "r"));
  const std::string its_contacts = text_of(folder / "c");
  const std::size_t first = rows.find("\n0,") + 1, second = rows.find('\n', first) + 1;
  const std::size_t digit = rows.find("0.0", first);
  ASSERT_LT(digit, second);
  std::string changed = rows, moved = contacts;
  changed[digit + 2] = '7';
  const std::size_t in_contacts = moved.find("0.0", moved.find('\n'));
  ASSERT_NE(in_contacts, std::string::npos);
  moved[in_contacts + 2] = '7';
  const std::string cut = rows.substr(0, digit) + "\n",
                    fewer = contacts.substr(0, contacts.size() / 2);
  for (const auto& [r, c] :
       {std::pair{changed, contacts}, {rows, moved}, {cut, contacts}, {rows, fewer}}) {
    folder.write("r.part", r);
    folder.write("c.part", c);
    expect_done(run + "--resume");
    EXPECT_EQ(untimed(text_of(folder / "r")), whole);
    EXPECT_EQ(text_of(folder / "c"), its_contacts);
  }
}

TEST_F(Resumed, a_run_that_begins_anew_says_what_it_writes_over) {
  const std::string brief = "query boxes.sonde.json --poses poses.csv --out r";
  folder.write("r.part", "");
  EXPECT_EQ(expect_done(brief + " --resume").err, "") << "an empty part is none";
  folder.write("r.part", "rows of an hour\n");
  EXPECT_THAT(expect_done(brief).err, HasSubstr("r.part of an interrupted run is written over"));
  EXPECT_EQ(expect_done(brief).err, "");
}

TEST_F(Resumed, two_runs_do_not_write_one_part) {
  folder.write("r.part", "of another\n");
  WritableFile other(folder / "r.part", WritableFile::Opening::existing);
  ASSERT_TRUE(other.is_open() && other.lock());
  expect_refused(run, 3, "r.part: another run writes it now");
  expect_refused(run + "--resume", 3, "r.part: another run writes it now");
  EXPECT_EQ(text_of(folder / "r.part"), "of another\n");
}

TEST_F(Resumed, a_part_of_another_run_is_refused_and_stays) {
  folder.write("r.part", "sonde query @0123456789abcdef\n0,separated\n");
  expect_refused(run + "--resume", 3, "r.part: is of another run");
  folder.write("r.part", "nothing");
  expect_refused(run + "--resume", 3, "r.part: is no part of a result");
  EXPECT_EQ(text_of(folder / "r.part"), "nothing");
}

TEST_F(Resumed, contacts_of_what_is_done_must_be_there) {
  const std::string without =
      "query boxes.sonde.json --poses long.csv --bound --seeds 20 "
      "--budget-steps 60 --out r ";
  ASSERT_EQ(interrupted(without), 130);
  expect_refused(run + "--resume", 3, "r.part: is of another run");  // that one had none
  std::filesystem::remove(folder / "r.part");
  ASSERT_EQ(interrupted(run), 130);
  std::filesystem::remove(folder / "c.part");
  expect_refused(run + "--resume", 3, "c.part: is missing");
  folder.write("c.part", "");
  expect_refused(run + "--resume", 3, "c.part: is missing or empty");
}

}  // namespace
}  // namespace sonde::test
