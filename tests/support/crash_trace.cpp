// SPDX-License-Identifier: GPL-3.0-or-later
// In every test program: one that crashes names the functions it was in, since what crashes once
// in thousands of runs has to be understood from the log of that run.
#include <execinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

constexpr int depth = 40;
std::array<void*, depth> frames;

/// Inlined functions included, where addr2line is installed and the program is not stripped.
void name_functions(int count) {
  const pid_t child = fork();
  if (child != 0) {
    waitpid(child, nullptr, 0);
    return;
  }
  dup2(STDERR_FILENO, STDOUT_FILENO);
  static std::array<char, 4096> program;
  if (readlink("/proc/self/exe", program.data(), program.size() - 1) < 0) _exit(1);
  // A position-independent program: addresses are from where it was loaded.
  std::FILE* const maps = std::fopen("/proc/self/maps", "r");
  unsigned long base = 0;
  if (!maps || std::fscanf(maps, "%lx", &base) != 1) _exit(1);
  static std::array<std::array<char, 24>, depth> texts;
  std::array<char*, depth + 5> arguments{};
  std::size_t next = 0;
  for (const char* flag : {"addr2line", "-Cfpie"}) arguments[next++] = const_cast<char*>(flag);
  arguments[next++] = program.data();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    std::snprintf(texts[i].data(), texts[i].size(), "%#lx",
                  reinterpret_cast<unsigned long>(frames[i]) - base);
    arguments[next++] = texts[i].data();
  }
  execvp(arguments[0], arguments.data());
  _exit(1);
}

void tell(int signal) {
  constexpr const char* line = "crashed; libraries and addresses, then the program's functions:\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, line, std::strlen(line));
  const int count = backtrace(frames.data(), depth);
  backtrace_symbols_fd(frames.data(), count, STDERR_FILENO);
  name_functions(count);
  raise(signal);  // as it would have ended
}

const bool tells = [] {
  void* first[1];
  backtrace(first, 1);                   // loads what it needs while there is memory to be had
  static std::array<char, 65536> stack;  // where the thread's own has overflowed
  const stack_t other{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = tell;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_ONSTACK | SA_NODEFER;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) sigaction(signal, &action, nullptr);
  return true;
}();

#endif

}  // namespace
