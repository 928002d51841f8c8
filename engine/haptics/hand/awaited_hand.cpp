// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/awaited_hand.hpp"

#include <algorithm>
#include <utility>

namespace sonde {
namespace {

bool all_ended(const std::vector<LoopEnded>& loops) noexcept {
  return std::ranges::all_of(
      loops, [](const LoopEnded& ended) { return ended->load(std::memory_order_acquire); });
}

}  // namespace

Hand awaited(Hand hand, std::vector<LoopEnded> before, const Pose& X_FM) {
  if (all_ended(before)) return hand;
  struct Shared {
    Hand hand;
    std::vector<LoopEnded> before;
    Pose X_FM;
    bool asked = false;  ///< the hand is rendered to only once it was sampled
  };
  const auto s = std::make_shared<Shared>(Shared{std::move(hand), std::move(before), X_FM, false});
  return {.sample =
              [s](double dt) {
                const bool first = !s->asked;
                s->asked = s->asked || all_ended(s->before);
                if (!s->asked) return HandSample{.X_FM = s->X_FM, .changed = true};
                HandSample sample = s->hand.sample(first ? 0 : dt);
                sample.changed = sample.changed || first;
                return sample;
              },
          .render =
              [s](const Wrench& wrench) {
                if (s->asked && s->hand.render) s->hand.render(wrench);
              },
          .follow =
              [s](double behind) {
                if (s->asked && s->hand.follow) s->hand.follow(behind);
              }};
}

}  // namespace sonde
