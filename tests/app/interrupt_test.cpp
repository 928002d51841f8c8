// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

/// The program with its poses coming through a pipe: once it opens that, it is well under way.
class Interrupt : public AppTest {
 protected:
  Interrupt() { ::mkfifo((folder / "pipe.csv").c_str(), 0600); }

  /// Its standard output goes to stdout.txt, or to a descriptor.
  void start(std::vector<std::string> arguments, int out = -1) {
    arguments.insert(arguments.begin(), SONDE_PROGRAM);
    child = ::fork();
    ASSERT_GE(child, 0);
    if (child != 0) return;
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const int null = ::open("/dev/null", O_WRONLY);
    if (::chdir(folder.path().c_str()) != 0 || ::dup2(null, STDERR_FILENO) < 0) ::_exit(99);
    if (out < 0) out = ::open("stdout.txt", O_WRONLY | O_CREAT, 0600);
    if (::dup2(out, STDOUT_FILENO) < 0) ::_exit(99);
    ::execv(SONDE_PROGRAM, pointers.data());
    ::_exit(99);
  }

  /// Gives the program more poses than it could search in an hour, and interrupts it a little
  /// later.
  int interrupt_and_wait(int signal = SIGINT) const {
    {
      std::ofstream pipe(folder / "pipe.csv");  // waits until the program has opened the other end
      pipe << "px,py,pz,qw,qx,qy,qz\n";
      for (int i = 0; i < 1000000; ++i) pipe << "0.01,0.02,0.03,1,0,0,0\n";
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ::kill(child, signal);
    return wait();
  }

  int wait() const {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  pid_t child = -1;
};

TEST_F(Interrupt, exit_130_and_nothing_written) {
  start({"query", "boxes.sonde.json", "--poses", "pipe.csv", "--out", "r.csv", "--threads", "2"});
  const std::size_t files = 7;  // five of the fixture, the pipe and the program's standard output
  EXPECT_EQ(interrupt_and_wait(), 130);
  EXPECT_EQ(folder.file_count(), files);
  EXPECT_EQ(text_of(folder / "stdout.txt"), "");
}

TEST_F(Interrupt, an_older_result_stays) {
  folder.write("r.csv", "old");
  start({"query", "boxes.sonde.json", "--poses", "pipe.csv", "--out", "r.csv"});
  EXPECT_EQ(interrupt_and_wait(), 130);
  EXPECT_EQ(text_of(folder / "r.csv"), "old");
}

TEST_F(Interrupt, standard_output_stays_empty) {
  start({"query", "boxes.sonde.json", "--poses", "pipe.csv", "--mode", "coherent"});
  EXPECT_EQ(interrupt_and_wait(), 130);
  EXPECT_EQ(text_of(folder / "stdout.txt"), "");
}

TEST_F(Interrupt, being_told_to_end_is_an_interrupt) {
  start({"query", "boxes.sonde.json", "--poses", "pipe.csv", "--out", "r.csv"});
  EXPECT_EQ(interrupt_and_wait(SIGTERM), 130);
  EXPECT_FALSE(std::filesystem::exists(folder / "r.csv"));
}

/// A pipe whose reader has gone, as behind `| head`.
TEST_F(Interrupt, results_that_nobody_reads_are_an_error_and_nothing_is_left) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const std::size_t files = folder.file_count();
  start({"replay", "boxes.sonde.json", "--record", "r.sonderec"}, ends[1]);
  ::close(ends[1]);
  EXPECT_EQ(wait(), 3);
  EXPECT_EQ(folder.file_count(), files);
}

}  // namespace
}  // namespace sonde::test
