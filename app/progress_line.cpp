// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_line.hpp"

#include <unistd.h>

#include <iostream>

namespace sonde::app {

ProgressLine::ProgressLine(bool quiet)
    : on_(!quiet && ::isatty(STDERR_FILENO) == 1), last_(std::chrono::steady_clock::now()) {}

void ProgressLine::show(const std::string& what, std::size_t done, std::size_t total) {
  if (on_) draw(what + ": " + std::to_string(done) + " of " + std::to_string(total));
}

Progress ProgressLine::percent(const std::string& what) {
  return [this, what](double fraction) {
    if (on_) draw(what + ": " + std::to_string(static_cast<int>(100 * fraction)) + " %");
    return true;
  };
}

void ProgressLine::draw(const std::string& text) {
  using namespace std::chrono_literals;
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < 100ms) return;
  last_ = now;
  drawn_ = true;
  std::cerr << "\r\033[K" << text << std::flush;
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (drawn_) std::cerr << "\r\033[K" << std::flush;
  drawn_ = false;
}

}  // namespace sonde::app
