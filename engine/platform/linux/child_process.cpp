// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>

#include "engine/base/progress.hpp"

namespace sonde {
namespace {

constexpr int poll_ms = 50;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Ended and waited for, at the latest with the object.
class Child {
 public:
  Child(pid_t pid, int pipe) : pid_(pid), pipe_(pipe) {}
  ~Child() {
    close(pipe_);
    if (pid_ == 0) return;
    kill(pid_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int wait() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) continue;
    pid_ = 0;
    return status;
  }
  int pipe() const { return pipe_; }

 private:
  pid_t pid_;
  int pipe_;
};

bool send_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(to, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

[[noreturn]] void be_child(const std::function<std::string()>& work, int to, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // gone before it could be told
  constexpr rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  // The handlers are the parent's: of a fault, of the end by the user.
  for (const int one : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGPIPE})
    std::signal(one, SIG_DFL);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  bool done = false;
  try {
    done = send_all(to, work());
  } catch (...) {
    done = false;
  }
  _exit(done ? 0 : 1);
}

}  // namespace

ChildEnd in_child_process(const std::function<std::string()>& work, const Progress& progress) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe");
  const pid_t parent = getpid(), pid = fork();
  if (pid == 0) be_child(work, ends[1], parent);
  const int why = errno;
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    errno = why;
    fail("no process");
  }
  Child child(pid, ends[0]);
  ChildEnd out;
  std::string piece(1 << 20, '\0');
  for (;;) {
    report(progress, 0);
    pollfd ready{child.pipe(), POLLIN, 0};
    if (poll(&ready, 1, poll_ms) <= 0) continue;
    const ssize_t n = read(child.pipe(), piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    out.output.append(piece, 0, static_cast<std::size_t>(n));
  }
  const int status = child.wait();
  if (WIFSIGNALED(status)) out.signal = WTERMSIG(status);
  out.threw = WIFEXITED(status) && WEXITSTATUS(status) != 0;
  return out;
}

}  // namespace sonde
