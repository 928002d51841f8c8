// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/hand_switch.hpp"

#include <algorithm>
#include <utility>

namespace sonde {

HandSwitch::HandSwitch(std::shared_ptr<const Hand> first)
    : kept_{std::move(first)}, wanted_(kept_.front().get()), used_(kept_.front().get()) {}

HandSample HandSwitch::sample(double dt) noexcept {
  const Hand* next = wanted_.load(std::memory_order_acquire);
  const bool first = next != held_;
  const bool handed_over = first && held_ != nullptr;
  if (first) {
    if (held_ && held_->render) held_->render({});
    held_ = next;
    used_.store(next, std::memory_order_release);
  }
  const bool resumed = std::exchange(resting_, paused_.load(std::memory_order_relaxed));
  if (first || !resting_) last_ = held_->sample(first || resumed ? 0 : dt);
  last_.changed = last_.changed || handed_over;
  return last_;
}

Hand HandSwitch::hand() {
  return {.sample = [this](double dt) { return sample(dt); },
          .render =
              [this](const Wrench& wrench) {
                // A servo that is stopped before its first tick still renders the final zero
                // wrench.
                if (held_ && held_->render) held_->render(wrench);
              },
          .follow =
              [this](double behind) {
                if (held_ && held_->follow) held_->follow(behind);
              }};
}

void HandSwitch::set(std::shared_ptr<const Hand> next) {
  kept_.push_back(std::move(next));
  wanted_.store(kept_.back().get(), std::memory_order_release);
  sweep();
}

/// Hands set before the one in use are never used again.
void HandSwitch::sweep() {
  const Hand* used = used_.load(std::memory_order_acquire);
  const auto first = std::ranges::find_if(kept_, [&](const auto& h) { return h.get() == used; });
  kept_.erase(kept_.begin(), first);
}

}  // namespace sonde
