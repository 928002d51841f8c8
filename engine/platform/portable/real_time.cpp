// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/real_time.hpp"

namespace sonde {
namespace {

constexpr const char* no_scheduling = "no real-time scheduling: not on this system";

}  // namespace

const char* request_processor(LoopThread) noexcept { return "shares its processor"; }

void name_thread(const char*) noexcept {}

void stand_back() noexcept {}

RealTime request_real_time() noexcept {
  return {.scheduled = false,
          .locked = false,
          .scheduling = no_scheduling,
          .memory = "memory not locked: not on this system",
          .processor = request_processor(LoopThread::servo)};
}

bool request_precedence() noexcept { return false; }

Promptness::Promptness(bool wanted) noexcept : words_(wanted ? no_scheduling : "") {}

Promptness::~Promptness() { static_cast<void>(granted_); }

}  // namespace sonde
