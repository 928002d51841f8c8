// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

#include "engine/base/error.hpp"

namespace sonde::app {

/// One line on stderr with the progress of a command, where stderr is a terminal and --quiet is not
/// set. May be called from any thread.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// "what: done of total", and after a second the time that is left, by what was done since the
  /// first call; drawn ten times a second at most.
  void show(const std::string& what, std::size_t done, std::size_t total);
  /// A callback that shows "what: n %" and never cancels.
  Progress percent(const std::string& what);
  void clear();

 private:
  void draw(const std::string& text);
  /// ", 12 s left"; empty where that is not known yet.
  std::string time_left(const std::string& what, std::size_t done, std::size_t total);
  bool on_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_;
  std::string what_;  // of the last call of show()
  std::chrono::steady_clock::time_point since_;
  std::size_t done_then_ = 0;
  std::mutex mutex_;
};

}  // namespace sonde::app
