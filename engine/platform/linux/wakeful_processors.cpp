// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/wakeful_processors.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace sonde {
namespace {

const char* refusal(int error) {
  switch (error) {
    case ENOENT:
      return "processors may sleep deeply: this system has no /dev/cpu_dma_latency";
    case EACCES:
    case EPERM:
      return "processors may sleep deeply: not permitted (70-sonde-devices.rules in "
             "/etc/udev/rules.d allows it to the user at the screen)";
    default:
      return "processors may sleep deeply: the system refused";
  }
}

}  // namespace

WakefulProcessors::WakefulProcessors(bool wanted, const char* file) noexcept {
  if (!wanted) return;
  file_ = open(file, O_WRONLY | O_CLOEXEC);
  constexpr std::int32_t latency = 0;  // µs
  if (file_ < 0) {
    words_ = refusal(errno);
  } else if (write(file_, &latency, sizeof latency) != sizeof latency) {
    words_ = refusal(errno);
    close(file_);
    file_ = -1;
  } else {
    words_ = "processors stay awake";
  }
}

WakefulProcessors::~WakefulProcessors() {
  if (file_ >= 0) close(file_);
}

}  // namespace sonde
