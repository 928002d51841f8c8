// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/path_hand.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

constexpr double way_to_path = 1;  // s

}  // namespace

Pose pose_at(std::span<const TimedPose> path, double t) noexcept {
  const auto after = std::upper_bound(path.begin(), path.end(), t,
                                      [](double a, const TimedPose& b) { return a < b.t; });
  if (after == path.begin()) return path.front().pose;
  if (after == path.end()) return path.back().pose;
  const TimedPose& b = *after;
  const TimedPose& a = *(after - 1);
  const double part = (t - a.t) / (b.t - a.t);
  return {rotation_between(a.pose.q, b.pose.q, part), a.pose.p + part * (b.pose.p - a.pose.p)};
}

PathHand::PathHand(std::vector<TimedPose> path, const Pose& X_FM) : path_(std::move(path)) {
  if (path_.empty()) throw std::invalid_argument("a path without poses holds nothing");
  t_ = path_.front().t - way_to_path;
  path_.insert(path_.begin(), {t_, X_FM});
}

Hand PathHand::hand() {
  return {.sample =
              [this](double dt) {
                t_ = std::min(t_ + dt, path_.back().t);
                return HandSample{.X_FM = pose_at(path_, t_)};
              },
          .render = {}};
}

}  // namespace sonde
