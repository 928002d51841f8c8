// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/pair_lists.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/penetration/contact/contact_tuning.hpp"

namespace sonde {

PairLists::PairLists(const Body& probe, const Body& fixed, std::size_t capacity)
    : radius_(probe.mass.radius),
      lists_{NeighbourList(probe, fixed, capacity), NeighbourList(probe, fixed, capacity)},
      reach_(probe.mass.radius),
      com_(probe.mass.com) {}

void PairLists::forget() noexcept {
  for (NeighbourList& list : lists_) list.clear();
  sliding_ = turning_ = Vec3::Zero();
  reach_ = NeighbourReach(radius_);
  last_work_ = 0;
  left_over_ = 0;
}

void PairLists::note_path(const Motion& path) noexcept {
  const Motion::Velocity v = path.velocity(0);
  const double last = sliding_.norm() + radius_ * turning_.norm();
  if (v.linear.norm() + radius_ * v.angular.norm() >= contact_tuning.path_kept * last)
    sliding_ = v.linear, turning_ = v.angular;
  else
    sliding_ *= contact_tuning.path_kept, turning_ *= contact_tuning.path_kept;
}

void PairLists::expect_shorter_paths() noexcept {
  sliding_ *= contact_tuning.path_without_room, turning_ *= contact_tuning.path_without_room;
}

Course PairLists::recent_course(const Transform& X, const Vec3& centre) const noexcept {
  const Vec3 arm = X.R * (centre - com_);
  return {sliding_ + turning_.cross(arm), turning_};
}

double PairLists::travel(const Wanted& wanted) const noexcept {
  return wanted.reach_at_end + wanted.path.course.size().of(radius_) + wanted.path.bend.of(radius_);
}

NeighbourList::Coverage PairLists::coverage(const Transform& X, const Wanted& wanted,
                                            double length) const noexcept {
  // The recent course, or that of the path ahead if that is longer.
  Course course = recent_course(X, wanted.centre);
  if (course.size().of(radius_) < wanted.path.course.size().of(radius_))
    course = wanted.path.course;
  const double size = course.size().of(radius_);
  const double around = size > 0 ? contact_tuning.share_beside_course * length : length;
  const Course ahead = size > 0 ? (length - around) / size * course : Course{};
  const DisplacementBound off = deviation(X, ahead, X, wanted.path, wanted.centre, radius_);
  // The deviation from the course is both sliding and turning, whatever the course is.
  const double least = contact_tuning.least_share_of_turn;
  const double linear = std::clamp(size > 0 ? course.size().linear / size : 0.5, least, 1 - least);
  return {{std::max(linear * around,
                    contact_tuning.room_for_path * (wanted.reach_on_path + off.linear)),
           std::max((1 - linear) * around / radius_, contact_tuning.room_for_path * off.turn)},
          ahead};
}

void PairLists::begin(const Transform& X, const Wanted& wanted, double at_least,
                      Effort& effort) noexcept {
  const double travel = this->travel(wanted);
  begun_.travel = travel;
  begun_.ample = std::max(reach_.choose(travel), at_least * travel);
  begun_.least = std::max(NeighbourReach::least(travel),
                          contact_tuning.least_of_next_list * at_least * travel);
  begun_.affordable = static_cast<std::int64_t>(
      std::min(1e18, contact_tuning.affordable_list * static_cast<double>(effort.left())));
  const std::int64_t most =
      at_least > 0 ? std::numeric_limits<std::int64_t>::max() : reach_.most_work();
  end(next().build_by({coverage(X, wanted, begun_.ample), coverage(X, wanted, begun_.least), most},
                      X, wanted.centre, effort));
}

void PairLists::end(bool fits) noexcept {
  const NeighbourList& list = next();
  if (list.is_unfinished()) return;
  const auto& [travel, ample, least, affordable] = begun_;
  last_work_ = list.work_of_build();
  const bool shrunk = list.used_fallback() && ample > least;
  if (shrunk) reach_.learn(travel, ample, false, last_work_, affordable);
  reach_.learn(travel, shrunk ? least : ample, fits, last_work_, affordable);
}

void PairLists::renew(const Transform& X, const Wanted& wanted, Effort& effort) noexcept {
  // A list pays if the steps are short compared with its reach; for long steps, the trees are
  // traversed instead.
  if (serving().capacity() == 0 || reach_.is_too_far(travel(wanted))) return;
  NeighbourList& list = next();
  if (!(list.reach_when_finished(X, wanted.path) > wanted.reach_acceptable))
    effort.within(contact_tuning.share_for_list,
                  [&](Effort& part) { return begin(X, wanted, 0, part), 0; });
  else if (list.is_unfinished())
    effort.within(contact_tuning.share_for_list,
                  [&](Effort& part) { return end(list.go_on(part)), 0; });
  // A list that was too much for the tick's effort is continued in the next ticks.
  if (list.is_unfinished() || !(list.reach_at(X) > 0)) return;
  serving().clear();
  serving_ = 1 - serving_;
}

void PairLists::prepare_next_list(const Transform& X, const Wanted& wanted,
                                  Effort& effort) noexcept {
  NeighbourList& list = next();
  if (!effort.is_limited()) return;
  // A running mean: a tick with much work leaves little, and the next ones more again.
  const double left = contact_tuning.share_for_next_list * static_cast<double>(effort.left());
  left_over_ =
      left_over_ > 0 ? left_over_ + contact_tuning.left_over_learned * (left - left_over_) : left;
  if (effort.is_spent() || !(serving().reach_at(X) > wanted.reach_at_end)) return;
  if (list.is_unfinished()) {
    if (!(list.reach_when_finished(X, wanted.path) > wanted.reach_at_end)) return list.clear();
    effort.within(contact_tuning.share_for_next_list,
                  [&](Effort& part) { return end(list.go_on(part)), 0; });
    return;
  }
  const double ticks = std::ceil(static_cast<double>(last_work_) / std::max(left_over_, 1.0));
  const LinearizedMotion until_then{(ticks + 1) * wanted.path.course, {}};
  if (serving().reach_at(X, until_then) > wanted.reach_at_end ||
      list.reach_at(X, wanted.path) > wanted.reach_at_end)
    return;
  effort.within(contact_tuning.share_for_next_list, [&](Effort& part) {
    return begin(
               X, wanted,
               std::min(ticks + contact_tuning.ticks_of_next_list, contact_tuning.most_ticks_ahead),
               part),
           0;
  });
}

}  // namespace sonde
