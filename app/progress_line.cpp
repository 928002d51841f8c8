// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress_line.hpp"

#include <cmath>
#include <iostream>
#include <utility>

#include "engine/platform/terminal.hpp"

namespace sonde::app {
namespace {

constexpr double longest_silence = 10;  // s without a word of the time

std::string percent_text(double fraction) {
  return std::to_string(static_cast<int>(100 * fraction)) + " %";
}

}  // namespace

ProgressLine::ProgressLine(bool quiet, Elsewhere elsewhere, std::chrono::milliseconds every)
    : on_(!quiet && (error_stream_is_terminal() || elsewhere == Elsewhere::lines)),
      last_(std::chrono::steady_clock::now()) {
  if (on_ && !error_stream_is_terminal())
    writer_ = std::thread([this, every] { write_lines(every); });
}

ProgressLine::~ProgressLine() {
  clear();
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  writer_.join();
}

/// A part of a study may take longer than that: so the clock decides, not the news.
void ProgressLine::write_lines(std::chrono::milliseconds every) {
  const auto begun = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, every, [this] { return end_; })) {
    if (text_.empty()) continue;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
    const auto seconds = static_cast<long>(passed.count());
    std::cerr << "sonde: " + text_ + " (after " + std::to_string(seconds) + " s)\n" << std::flush;
  }
}

void ProgressLine::show(const std::string& what, std::size_t done, std::size_t total,
                        double under_way) {
  if (!on_) return;
  const double all = static_cast<double>(total), so_far = static_cast<double>(done) + under_way;
  const std::string part = under_way > 0 && total > 0 ? ", " + percent_text(so_far / all) : "";
  draw(what + ": " + std::to_string(done) + " of " + std::to_string(total) + part +
       time_left(what, so_far, all));
}

std::string ProgressLine::time_left(const std::string& what, double done, double total) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (what != what_ || done < done_then_) what_ = what, since_ = now, done_then_ = done;
  const double passed = std::chrono::duration<double>(now - since_).count();
  if (done <= done_then_ && passed >= longest_silence)
    return ", " + std::to_string(static_cast<long>(passed)) +
           " s so far, how long is not known yet";
  if (passed < 1 || done <= done_then_ || done >= total) return {};
  const double seconds = passed * (total - done) / (done - done_then_);
  if (seconds < 100) return ", " + std::to_string(static_cast<int>(std::ceil(seconds))) + " s left";
  return ", " + std::to_string(static_cast<long>(std::ceil(seconds / 60))) + " min left";
}

Progress ProgressLine::percent(const std::string& what, Stop stop) {
  return [this, what, stop = std::move(stop)](double fraction) {
    if (on_) draw(what + ": " + percent_text(fraction) + time_left(what, fraction, 1));
    return !(stop && stop());
  };
}

void ProgressLine::draw(const std::string& text) {
  using namespace std::chrono_literals;
  const std::lock_guard lock(mutex_);
  if (writer_.joinable()) {
    text_ = text;
    return;
  }
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
  text_.clear();
}

}  // namespace sonde::app
