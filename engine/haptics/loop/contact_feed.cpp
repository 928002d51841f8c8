// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/contact_feed.hpp"

#include <algorithm>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/loop/loop_tuning.hpp"
#include "engine/penetration/descent/descent.hpp"

namespace sonde {
namespace {

/// The effort for the near rows, in addition to the solver's.
Effort effort_of_rows(const Budget& budget) {
  const double share = loop_tuning.budget_of_rows;
  const auto work = static_cast<std::int64_t>(share * static_cast<double>(budget.work));
  return {work, budget.microseconds > 0 ? now_us() + share * budget.microseconds : 0};
}

}  // namespace

ContactFeed::ContactFeed(const Pair& pair, Method method)
    : pair_(pair),
      method_(method),
      solver_(pair, method),
      near_(pair.probe(), pair.fixed(), method, {.most_pairs = loop_tuning.most_pairs}),
      marked_(ContactRows::capacity) {}

const LocalContacts& ContactFeed::reset(const Pose& X_FM, const StaticOptions& options) {
  StaticOptions own = options;
  own.method = method_;
  contacts_ = LocalContacts{};
  contacts_.separation = begin(X_FM, own);
  last_device_ = contacts_.separation.device;
  near_.forget();
  gathered_ = false;
  failed_looks_ = looks_left_out_ = 0;
  gather({});
  return contacts_;
}

/// If the separated pose is known from before, starts there, since it is free, and takes one tick
/// to the device pose.
const Separation& ContactFeed::begin(const Pose& X_FM, const StaticOptions& options) {
  const bool known = searched_ && searched_->device.p == X_FM.p &&
                     searched_->device.q.coeffs() == X_FM.q.normalized().coeffs();
  if (known && solver_.reset(searched_->separated, options).status == Status::separated)
    return solver_.tick(X_FM);
  const Separation& found = solver_.reset(X_FM, options);
  if (found.status == Status::penetrating) searched_ = found;
  return found;
}

const LocalContacts& ContactFeed::refresh(const Pose& X_FM, std::uint64_t tick, double time,
                                          const Budget& budget, const Budget& of_rows) noexcept {
  const double begin = now_us();
  times_ = {};
  last_device_ = contacts_.separation.device;
  contacts_.separation = solver_.tick(X_FM, budget);
  contacts_.tick = tick;
  contacts_.time = time;
  contacts_.jumps += contacts_.separation.jumped;
  contacts_.falls += contacts_.separation.fell();
  contacts_.released += contacts_.separation.released;
  gather(of_rows);
  contacts_.separation.phases += times_;
  contacts_.refresh_us = now_us() - begin;
  return contacts_;
}

void ContactFeed::time_phases(bool on) noexcept {
  solver_.time_phases(on);
  near_.time_into(on ? &times_ : nullptr);
}

void ContactFeed::gather(const Budget& budget) noexcept {
  const Separation& s = contacts_.separation;
  contacts_.size = 0;
  if (s.status == Status::failed) return;
  Chart chart(pair_.probe().mass, s.device);
  chart.absorb_free_spin(s.separated);
  const double radius = pair_.probe().mass.radius;
  const double margin = loop_tuning.margin_of_clearance * allowed_clearance(radius, s.depth);
  const Pose X_MF = inverse(s.separated);
  const auto add = [&](const Contact& c) {
    if (contacts_.size == LocalContacts::capacity) return false;
    contacts_.rows[static_cast<std::size_t>(contacts_.size++)] = {
        X_MF * c.on_probe, c.on_fixed, c.normal, std::min(c.gap, margin)};
    return true;
  };
  // The rows that hold the probe come first: with them, the answer at the device pose of the solver
  // is the separated pose.
  for (const Contact& c : s.contacts) add(c);
  Effort effort = effort_of_rows(budget);
  contacts_.reach = gather_near(chart, loop_tuning.flat_within * margin, effort);
  const int rows = near_.size();
  std::fill(marked_.begin(), marked_.end(), rows <= LocalContacts::capacity - contacts_.size);
  if (!marked_[0]) mark_support(loop_tuning.support_reach * radius);
  for (int i = 0; i < rows; ++i)
    if (marked_[static_cast<std::size_t>(i)]) add(near_.contact(i));
  for (int i = 0; i < rows; ++i) {
    if (marked_[static_cast<std::size_t>(i)]) continue;
    // The rows come in the order of their gaps, the nearest first. So a row for which there is no
    // room is no nearer than the last one added.
    if (add(near_.contact(i))) continue;
    contacts_.reach = std::min(contacts_.reach, near_.contact(i).gap);
    break;
  }
}

double ContactFeed::gather_near(const Chart& chart, double flat, Effort& effort) noexcept {
  const MassProperties& mass = pair_.probe().mass;
  const Pose& at = contacts_.separation.separated;
  const Vec6 y = chart.coordinates(at);
  const Transform now(at), then(gathered_at_);
  // Upper bound of the displacement of any point of the probe.
  const double moved =
      (now * mass.com - then * mass.com).norm() + (now.R - then.R).norm() * mass.radius;
  const bool move_along = gathered_ && moved < loop_tuning.moved_with_rows * near_.reach();
  // Pairs that may become flat while the rows move with the probe count as flat already.
  const double soon_flat = flat + loop_tuning.moved_with_rows * near_.reach();
  if (!move_along && look_around(chart, y, soon_flat, effort)) {
    gathered_at_ = at;
    gathered_ = true;
    return near_.reach();
  }
  near_.move_rows_with_probe(chart, y);
  return std::max(0.0, near_.reach() - moved);
}

bool ContactFeed::look_around(const Chart& chart, const Vec6& y, double flat,
                              Effort& effort) noexcept {
  const double widest = loop_tuning.widest * pair_.probe().mass.radius;
  if (looks_left_out_ > 0) {
    --looks_left_out_;
  } else if (near_.gather(chart, y, widest, flat, effort)) {
    failed_looks_ = 0;
    return true;
  } else {
    near_.halve_next_reach(flat);
    failed_looks_ = std::min(failed_looks_ + 1, loop_tuning.most_failed_looks);
    looks_left_out_ = (1 << failed_looks_) - 1;
  }
  return near_.gather_from(solver_.near_list(), chart, y, widest, flat);
}

void ContactFeed::mark_holding(const Pose& device) noexcept {
  Chart chart(pair_.probe().mass, device);
  chart.absorb_free_spin(contacts_.separation.separated);
  const Vec6 y = chart.coordinates(contacts_.separation.separated);
  if (!near_.reuse_rows(chart, y)) return;
  const LeastDistance held =
      near_.solve(loop_tuning.margin_of_clearance *
                      allowed_clearance(pair_.probe().mass.radius, contacts_.separation.depth),
                  ContactRows::SmallGaps::keep);
  for (int i = 0; i < held.active_count; ++i)
    if (const int row = held.active[static_cast<std::size_t>(i)]; row < near_.size())
      marked_[static_cast<std::size_t>(row)] = true;
}

void ContactFeed::mark_support(double far) noexcept {
  const MassProperties& mass = pair_.probe().mass;
  const Pose& device = contacts_.separation.device;
  /// The device pose, turned about its centre of mass and shifted.
  const auto moved = [&](const Vec3& shift, const Vec3& turn) {
    const Quat q = rotation_by(turn) * device.q;
    return Pose{q.normalized(), device * mass.com + shift - q * mass.com};
  };
  const Vec3 turn = rotation_vector(device.q * last_device_.q.conjugate());
  const Vec3 shift = device * mass.com - last_device_ * mass.com;
  for (const double ticks : loop_tuning.support_ticks)
    mark_holding(moved(ticks * shift, ticks * turn));
  for (int axis = 0; axis < 3; ++axis)
    for (const double by : {-far, far}) {
      mark_holding(moved(by * Vec3::Unit(axis), Vec3::Zero()));
      mark_holding(moved(Vec3::Zero(), by / mass.radius * Vec3::Unit(axis)));
    }
}

}  // namespace sonde
