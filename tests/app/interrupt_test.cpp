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

  void start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), SONDE_PROGRAM);
    child = ::fork();
    ASSERT_GE(child, 0);
    if (child != 0) return;
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const int null = ::open("/dev/null", O_WRONLY);
    if (::chdir(folder.path().c_str()) != 0 || ::dup2(null, STDERR_FILENO) < 0) ::_exit(99);
    if (::dup2(::open("stdout.txt", O_WRONLY | O_CREAT, 0600), STDOUT_FILENO) < 0) ::_exit(99);
    ::execv(SONDE_PROGRAM, pointers.data());
    ::_exit(99);
  }

  /// Gives the program more poses than it could search in an hour, and interrupts it a little
  /// later.
  int interrupt_and_wait() const {
    {
      std::ofstream pipe(folder / "pipe.csv");  // waits until the program has opened the other end
      pipe << "px,py,pz,qw,qx,qy,qz\n";
      for (int i = 0; i < 1000000; ++i) pipe << "0.01,0.02,0.03,1,0,0,0\n";
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ::kill(child, SIGINT);
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

}  // namespace
}  // namespace sonde::test
