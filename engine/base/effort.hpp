// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

namespace sonde {

/// Time of a monotonic clock, µs.
inline double now_us() {
  using namespace std::chrono;
  return duration<double, std::micro>(steady_clock::now().time_since_epoch()).count();
}

/// The remaining effort of a query. The query counts its work itself, in units of about 10 ns, so
/// that a limit on it gives the same bits on every machine; it also reads a clock from time to
/// time. Long queries check it after each small piece of work, and stop with the results so far.
class Effort {
 public:
  Effort() = default;  ///< no limit
  /// `work`: maximum number of units (0: no limit). `until`: a time of now_us() (0: no limit).
  Effort(std::int64_t work, double until)
      : left_(work > 0 ? work : std::numeric_limits<std::int64_t>::max()), until_(until) {}

  /// Spends units of work. Returns false when nothing is left.
  bool spend(int work) noexcept {
    left_ -= work;
    if (until_ > 0 && left_ > 0 && (unwatched_ += work) > between_looks) {
      unwatched_ = 0;
      if (now_us() > until_) left_ = 0;
    }
    return left_ > 0;
  }
  bool is_spent() const noexcept { return left_ <= 0; }
  bool is_limited() const noexcept {
    return until_ > 0 || left_ < std::numeric_limits<std::int64_t>::max() / 2;
  }

  /// The remaining effort in units of work; the clock is assumed to give 100 per microsecond.
  std::int64_t left() const noexcept {
    if (!(until_ > 0)) return left_;
    const double by_clock = 100 * std::max(0.0, until_ - now_us());
    return std::min(left_, static_cast<std::int64_t>(std::min(by_clock, 1e15)));
  }
  /// Runs task(Effort&), which may spend at most `work`.
  template <class Task>
  auto at_most(std::int64_t work, const Task& task) {
    Effort part(*this);
    const std::int64_t most = part.left_ = std::min(work, left_);
    const auto out = task(part);
    left_ -= most - std::max<std::int64_t>(0, part.left_);
    // A part that the clock ended has not used up its own work.
    if (until_ > 0 && part.is_spent() && now_us() > until_) left_ = 0;
    unwatched_ = between_looks;  // the next spend() reads the clock
    return out;
  }
  /// The same, with a share of the remaining effort.
  template <class Task>
  auto within(double share, const Task& task) {
    if (!is_limited()) return task(*this);
    Effort part(*this);
    const auto most = static_cast<std::int64_t>(share * static_cast<double>(left_));
    part.left_ = most;
    if (until_ > 0) part.until_ = now_us() + share * std::max(0.0, until_ - now_us());
    const auto out = task(part);
    const bool counted = left_ < std::numeric_limits<std::int64_t>::max() / 2;
    if (counted) left_ -= most - std::max<std::int64_t>(0, part.left_);
    unwatched_ = between_looks;  // the next spend() reads the clock
    return out;
  }

 private:
  static constexpr int between_looks = 300;
  std::int64_t left_ = std::numeric_limits<std::int64_t>::max();
  double until_ = 0;
  int unwatched_ = between_looks;
};

}  // namespace sonde
