// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/free_region.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// Room is searched for this many moves: twice as many after a success, half as many after a
/// failure. A call of look() costs as much as several ticks without one.
constexpr double least_asked = 16, most_asked = 512;
/// R: the motion assumed for a probe that stands still.
constexpr double least_move = 1e-4;
/// In moves: less room than this does not repay a call of look().
constexpr double fewest_moves = 8;
/// R: limit of the room. Within half of it, the probe turns by less than a step of a descent may.
constexpr double most_room = 0.5;
/// Share of the room that is used. In the other half, ticks examine the bodies and learn which
/// contacts to expect.
constexpr double used = 0.5;
constexpr std::int64_t work_of_look = 500;  // units of Effort: a longer look does not pay
constexpr int longest_wait = 64;            // ticks

}  // namespace

double farthest_move(const MassProperties& mass, const Pose& from, const Pose& to) {
  return (to * mass.com - from * mass.com).norm() +
         2 * mass.radius * (from.q.conjugate() * to.q).vec().norm();
}

bool FreeRegion::covers(const Pose& X_FM) const noexcept {
  return used_up_at_ > 0 && farthest_move(probe_.mass, centre_, X_FM) <= used_up_at_;
}

void FreeRegion::look(const Pose& X_FM, double last_move, Effort& effort) noexcept {
  used_up_at_ = 0;
  if (wait_ > 0) {
    --wait_;
    return;
  }
  const double moved = std::max(last_move, least_move * probe_.mass.radius);
  const double asked = std::min(asked_ * moved, most_room * probe_.mass.radius);
  std::array<NearPair, 2> nearest;
  const NearPairs near = effort.at_most(work_of_look, [&](Effort& part) {
    return near_pairs(probe_, fixed_, Transform(X_FM), asked, nearest, part);
  });
  double room = near.reach;
  for (std::size_t i = 0; i < near.count; ++i) room = std::min(room, nearest[i].gap);
  room -= rounding_guard(extent(probe_), extent(fixed_), X_FM.p);
  if (!(room > fewest_moves * moved)) {
    wait_ = next_wait_;
    next_wait_ = std::min(2 * next_wait_, longest_wait);
    asked_ = std::max(0.5 * asked_, least_asked);
    return;
  }
  asked_ =
      room < 0.5 * asked ? std::max(0.5 * asked_, least_asked) : std::min(2 * asked_, most_asked);
  next_wait_ = 1;
  centre_ = X_FM;
  used_up_at_ = used * room;
}

}  // namespace sonde
