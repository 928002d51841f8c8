// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <thread>

#include "tests/app/app_test.hpp"

namespace sonde::test {

/// Runs of a study: what they leave, and what a signal on their way does.
class StudyTest : public AppTest {
 protected:
  /// Every file below a folder, with what it holds.
  std::map<std::string, std::string> files(const std::string& name) const {
    std::map<std::string, std::string> out;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / name))
      if (entry.is_regular_file())
        out[std::filesystem::relative(entry.path(), folder / name).string()] =
            text_of(entry.path());
    return out;
  }
  /// A path of so many ticks to and fro in contact.
  void write_long_path(int ticks) const {
    std::string path = "t,px,py,pz,qw,qx,qy,qz\n";
    for (int i = 0; i < ticks; ++i)
      path += std::to_string(0.001 * i) + "," + std::to_string(0.14 + 1e-5 * (i % 700)) + "," +
              std::to_string(1e-5 * (i % 1100)) + ",0,1,0,0,0\n";
    folder.write("long.csv", path);
  }
  /// Starts the program in the folder; its id.
  pid_t start(const std::vector<std::string>& arguments) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    std::vector<char*> pointers{const_cast<char*>(SONDE_PROGRAM)};
    for (const std::string& argument : arguments)
      pointers.push_back(const_cast<char*>(argument.c_str()));
    pointers.push_back(nullptr);
    if (::chdir(folder.path().c_str()) == 0 && std::freopen("/dev/null", "w", stdout))
      ::execv(SONDE_PROGRAM, pointers.data());
    ::_exit(99);
  }
  /// Waits until a study has begun, and signals it.
  int signal_once_begun(pid_t child, const std::string& out, int signal) const {
    while (!std::filesystem::exists(folder / out / "study.json"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// `sonde ARGUMENTS --shard {}/N --out part{}` under GNU parallel, as the manual shows it.
  int in_parallel(const std::string& arguments, int shards) const {
    std::string command = "cd '" + folder.path().string();
    command.append("' && parallel --will-cite -j2 '").append(SONDE_PROGRAM).append("' ");
    command.append(arguments).append(" --shard {}/").append(std::to_string(shards));
    command.append(" --out part{} --quiet :::");
    for (int i = 1; i <= shards; ++i) command.append(" ").append(std::to_string(i));
    return std::system(command.c_str());
  }
};

}  // namespace sonde::test
