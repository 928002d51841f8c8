// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <cstddef>

namespace sonde::ui {

/// Frames a second, over windows of at least half a second. Times are in ms.
class FrameRate {
 public:
  void frame() { ++frames_; }
  /// As of the last window that is over.
  double at(qint64 now) {
    if (now - since_ >= window) {
      rate_ = static_cast<double>(frames_) * 1000 / static_cast<double>(now - since_);
      since_ = now;
      frames_ = 0;
    }
    return rate_;
  }
  double last() const { return rate_; }

 private:
  static constexpr qint64 window = 500;
  qint64 since_ = 0;
  std::size_t frames_ = 0;
  double rate_ = 0;
};

}  // namespace sonde::ui
