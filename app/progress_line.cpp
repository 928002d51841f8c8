// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_line.hpp"

#include <cmath>
#include <iostream>

#include "engine/platform/terminal.hpp"

namespace sonde::app {

ProgressLine::ProgressLine(bool quiet)
    : on_(!quiet && error_stream_is_terminal()), last_(std::chrono::steady_clock::now()) {}

void ProgressLine::show(const std::string& what, std::size_t done, std::size_t total) {
  if (!on_) return;
  const std::string left = time_left(what, done, total);
  draw(what + ": " + std::to_string(done) + " of " + std::to_string(total) + left);
}

std::string ProgressLine::time_left(const std::string& what, std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (what != what_ || done < done_then_) what_ = what, since_ = now, done_then_ = done;
  const double passed = std::chrono::duration<double>(now - since_).count();
  if (passed < 1 || done <= done_then_ || done >= total) return {};
  const double seconds =
      passed * static_cast<double>(total - done) / static_cast<double>(done - done_then_);
  if (seconds < 100) return ", " + std::to_string(static_cast<int>(std::ceil(seconds))) + " s left";
  return ", " + std::to_string(static_cast<int>(std::ceil(seconds / 60))) + " min left";
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
