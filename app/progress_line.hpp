// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"

namespace sonde::app {

/// One line on stderr with the progress of a command, where stderr is a terminal and --quiet is not
/// set. May be called from any thread.
class ProgressLine {
 public:
  /// What there is in a file or a pipe, which a person may follow while a study takes minutes.
  enum class Elsewhere { nothing, lines };
  /// Lines are written every so many seconds, not before that, and whether or not there is news.
  explicit ProgressLine(bool quiet, Elsewhere elsewhere = Elsewhere::nothing,
                        std::chrono::milliseconds every = std::chrono::seconds(10));
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// "what: done of total", and after a second the time that is left, by what was done since the
  /// first call; drawn ten times a second at most. `under_way`: what is done of the next ones,
  /// which counts; then the part of all that is done is shown too.
  void show(const std::string& what, std::size_t done, std::size_t total, double under_way = 0);
  /// A callback that shows "what: n %" with the time that is left, and cancels where `stop` says
  /// so.
  Progress percent(const std::string& what, Stop stop = {});
  /// As it stands, where nothing can be counted yet.
  void say(const std::string& text) {
    if (on_) draw(text);
  }
  void clear();

 private:
  void draw(const std::string& text);
  /// ", 12 s left"; empty where that is not known yet, but for no longer than ten seconds.
  std::string time_left(const std::string& what, double done, double total);
  void write_lines(std::chrono::milliseconds every);

  bool on_;
  bool drawn_ = false;
  std::string text_;  ///< of the next line elsewhere; empty: none
  std::chrono::steady_clock::time_point last_;
  std::string what_;  // of the last call of show()
  std::chrono::steady_clock::time_point since_;
  double done_then_ = 0;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread writer_;  ///< of lines elsewhere; none for a terminal
};

}  // namespace sonde::app
