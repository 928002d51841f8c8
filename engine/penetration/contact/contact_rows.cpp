// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/contact_rows.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/base/phase_timer.hpp"
#include "engine/penetration/contact/face_overlap.hpp"
#include "engine/penetration/contact/separating_axes.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

ContactRows::ContactRows(const Body& probe, const Body& fixed, Method method,
                         const Finding& finding)
    : probe_(probe),
      fixed_(fixed),
      method_(method),
      lists_(probe, fixed, finding.keeps_lists ? NeighbourList::enough(probe, fixed) : 0),
      most_near_(finding.most_pairs),
      pairs_(finding.most_pairs + contact_tuning.most_kept),
      contacts_(capacity),
      rows_(capacity + 1),  // one more for the rim of the chart
      at_(capacity),
      violations_(contact_tuning.most_cut),
      pair_of_(capacity),
      kept_(probe, fixed),
      reach_limit_(probe.mass.radius) {}

void ContactRows::forget() noexcept {
  lists_.forget();
  gathered_ = rim_ = false;
  kept_.forget();
  count_ = 0;
  reach_limit_ = probe_.mass.radius;
}

void ContactRows::accept(const Contact& contact, const TrianglePair& of) noexcept {
  if (count_ == capacity) return;
  pair_of_[count_] = of;
  contacts_[count_++] = contact;
}

bool ContactRows::is_news(const Contact& contact) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const Contact& row = contacts_[i];
    if (row.normal.dot(contact.normal) < contact_tuning.same_normal) continue;
    // Even the largest expected turn brings the contact no nearer than the row.
    const double apart = (contact.on_probe - row.on_probe).norm();
    if (contact.gap - row.gap >= turn_ * apart) return false;
  }
  return true;
}

void ContactRows::add_rows_of(const NearPair& pair, const Transform& X, double flat,
                              const Transform* end) noexcept {
  const Corners ta = place(X, corners(surface(probe_), pair.triangle_a));
  const Corners tb = corners(surface(fixed_), pair.triangle_b);
  // Fraction of the path at which the gap along n closes; infinite if it does not.
  const auto free_until = [&](const Vec3& n) {
    const Corners then_a = place(*end, corners(surface(probe_), pair.triangle_a));
    const double now = gap_along(n, ta, tb), then = gap_along(n, then_a, tb);
    return now <= 0 ? 0 : then < now ? now / (now - then) : infinity;
  };
  Contact own{pair.on_a, pair.on_b, pair.normal, pair.gap, 0};
  for (std::size_t i = 0; i < count_; ++i) {
    const Contact& row = contacts_[i];
    if (gap_along(row.normal, ta, tb) < contact_tuning.same_gap * row.gap) continue;
    if (end && free_until(pair.normal) > free_until(row.normal)) break;
    own.normal = row.normal;
    own.gap = row.normal.dot(own.on_probe - own.on_fixed);
    break;
  }
  if (is_news(own)) accept(own, {pair.triangle_a, pair.triangle_b});
  if (pair.gap > flat) return;
  for (const Contact& corner : face_overlap(ta, tb, own.normal))
    if (is_news(corner)) accept(corner, {pair.triangle_a, pair.triangle_b});
}

Vec3 ContactRows::least_moving_point(const Transform& X) const noexcept {
  const Vec3& com = probe_.mass.com;
  if (count_ == 0) return com;
  const auto local = [&](std::size_t i) {
    return Vec3(X_.R.transpose() * (contacts_[i].on_probe - X_.p));
  };
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < count_; ++i) sum += local(i);
  const Vec3 middle = sum / static_cast<double>(count_);
  const DisplacementBound about_com = lists_.recent_course(X, com).size(),
                          about_middle = lists_.recent_course(X, middle).size();
  double by_com = 0, by_middle = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    by_com += about_com.of((local(i) - com).norm());
    by_middle += about_middle.of((local(i) - middle).norm());
  }
  return by_middle < by_com ? middle : com;
}

NearPairs ContactRows::find_pairs(const Transform& X, double reach, double least,
                                  Effort& effort) noexcept {
  const double will_do = std::max(least, contact_tuning.least_share_of_reach * reach);
  const auto take_what_is_listed = [&] {
    const double listed = lists_.serving().reach_at(X);
    if (listed >= will_do) reach = std::min(reach, listed);
    return listed >= reach;
  };
  if (!take_what_is_listed()) {
    const Vec3 centre = least_moving_point(X);
    lists_.renew(X, {reach, near_of(reach), will_do, centre, {lists_.recent_course(X, centre), {}}},
                 effort);
    // If the list has no room for that reach, shorter paths are expected from now on.
    if (!take_what_is_listed()) lists_.expect_shorter_paths();
  }
  NeighbourList& list = lists_.serving();
  const NearPairs near =
      list.reach_at(X) >= reach
          ? list.near(X, reach, {pairs_.data(), most_near_}, effort)
          : near_pairs(probe_, fixed_, X, reach, {pairs_.data(), most_near_}, effort);
  if (near.reach < 0) return near;
  reach_limit_ = near.reach < reach
                     ? near.reach
                     : std::min(contact_tuning.crowded_growth * reach_limit_, probe_.mass.radius);
  return near;
}

void ContactRows::prepare_next_list(double moved, Effort& effort) noexcept {
  if (!gathered_) return;
  const PhaseTimer timer(times_, Phase::look);
  const double reach = std::max(least_asked_, contact_tuning.least_share_of_reach * asked_);
  const Vec3 centre = least_moving_point(X_);
  const Course recent = lists_.recent_course(X_, centre);
  const double size = recent.size().of(probe_.mass.radius);
  const Course course = size > moved ? moved / size * recent : recent;
  lists_.prepare_next_list(X_, {reach, near_of(reach), reach, centre, {course, {}}}, effort);
}

bool ContactRows::gather(const Chart& chart, const Vec6& y, double reach, double flat,
                         Effort& effort) noexcept {
  const PhaseTimer timer(times_, Phase::look);
  const Transform X(chart.pose(y));
  asked_ = std::min(reach, reach_limit_);
  least_asked_ = contact_tuning.least_reach_of_flat * flat;
  const NearPairs near = find_pairs(X, asked_, least_asked_, effort);
  gathered_ = near.reach >= 0 && !effort.is_spent();
  if (gathered_) make_rows(near, reach, chart, y, flat, effort);
  return gathered_;
}

bool ContactRows::gather_from(NeighbourList& list, const Chart& chart, const Vec6& y, double reach,
                              double flat) noexcept {
  const PhaseTimer timer(times_, Phase::look);
  const Transform X(chart.pose(y));
  const double listed = list.reach_at(X);
  if (!(listed > 0)) return false;
  asked_ = std::min(reach, listed);
  Effort unlimited;
  const NearPairs near = list.near(X, asked_, {pairs_.data(), most_near_}, unlimited);
  make_rows(near, asked_, chart, y, flat, unlimited);
  return gathered_ = true;
}

void ContactRows::make_rows(const NearPairs& near, double reach, const Chart& chart, const Vec6& y,
                            double flat, Effort& effort) noexcept {
  const Transform X(chart.pose(y));
  count_ = 0;
  has_other_axes_ = false;
  smallest_gap_ = reach_ = near.reach;
  X_ = X;
  turn_ = std::max(contact_tuning.turn_per_reach * reach_ / probe_.mass.radius,
                   2 * lists_.recent_turn());
  const std::span<NearPair> pairs(pairs_.data(),
                                  kept_.add_to(pairs_, near.count, X, std::max(asked_, reach)));
  ordering::sort(pairs.begin(), pairs.end(), [](const NearPair& p, const NearPair& q) {
    if (p.gap != q.gap) return p.gap < q.gap;
    return std::pair(p.triangle_a, p.triangle_b) < std::pair(q.triangle_a, q.triangle_b);
  });
  if (!pairs.empty()) smallest_gap_ = pairs.front().gap;
  for (const NearPair& p : pairs) {
    effort.spend(contact_tuning.work_of_pair);
    add_rows_of(p, X, flat);
  }
  linearise(chart, y);
}

bool ContactRows::reuse_rows(const Chart& chart, const Vec6& y) noexcept {
  if (!gathered_ || has_other_axes_) return false;
  const Transform X(chart.pose(y));
  const Vec3& com = probe_.mass.com;
  const double moved = (X * com - X_ * com).norm() + (X.R - X_.R).norm() * probe_.mass.radius;
  if (moved > rounding_guard(extent(probe_), extent(fixed_), X.p)) return false;
  linearise(chart, y);
  return true;
}

void ContactRows::move_rows_with_probe(const Chart& chart, const Vec6& y) noexcept {
  const Transform X(chart.pose(y));
  for (std::size_t i = 0; i < count_; ++i) {
    Contact& c = contacts_[i];
    c.on_probe = X * (X_.R.transpose() * (c.on_probe - X_.p));
    c.gap = c.normal.dot(c.on_probe - c.on_fixed);
  }
  X_ = X;
  gathered_ = false;
  linearise(chart, y);
}

Vec6 ContactRows::allowed(Vec6 row) const noexcept {
  if (method_ == Method::pdt) row.head<3>().setZero();
  if (onto_) row = (*onto_ * row).eval();
  return row;
}

LeastDistance ContactRows::without_row(const LeastDistance& nearest, std::size_t k,
                                       double margin) noexcept {
  std::array<int, 6> others{};
  std::size_t count = 0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(nearest.active_count); ++j)
    if (j != k) others[count++] = nearest.active[j];
  double& bound = rows_[static_cast<std::size_t>(nearest.active[k])].bound;
  const double own = std::exchange(bound, std::numeric_limits<double>::lowest());
  LeastDistance out =
      least_distance({rows_.data(), count_ + rim_}, contact_tuning.solved_to * margin,
                     std::span(others).first(count));
  bound = own;
  return out;
}

bool ContactRows::replace_blocking_row(const Chart& chart, const Vec6& y,
                                       const LeastDistance& nearest, double margin,
                                       double enough) noexcept {
  const double depth = nearest.y.norm();
  for (std::size_t k = 0; k < static_cast<std::size_t>(nearest.active_count); ++k) {
    const auto i = static_cast<std::size_t>(nearest.active[k]);
    // Without this row, |y| can fall no more steeply than in proportion to the row's share of the
    // force.
    const double share = i < count_ ? nearest.multiplier[k] * rows_[i].normal.norm() : 0;
    if (!(share > contact_tuning.least_slope * depth)) continue;
    const auto [a, b] = pair_of_[i];
    const OtherAxes others = other_axes(
        place(X_, corners(surface(probe_), a)), corners(surface(fixed_), b), contacts_[i].normal,
        contact_tuning.other_gap * std::min(contacts_[i].gap, margin));
    if (others.size == 0) continue;
    const Vec6 way = without_row(nearest, k, margin).y - y;
    if (!((y + way).norm() < depth - enough)) continue;
    const auto along = [&](const Contact& contact) {
      return allowed(chart.row(y, contact.on_probe, contact.normal)).dot(way);
    };
    const Contact& best =
        *std::ranges::max_element(std::span(others.items).first(others.size), {}, along);
    if (!(along(best) > rows_[i].normal.dot(way))) continue;
    const Contact own = std::exchange(contacts_[i], best);
    const double bound = rows_[i].bound;
    linearise(chart, y, i, i + 1);
    const Vec6 step = solve(margin, SmallGaps::keep).y - y;
    const bool is_steep = -y.dot(step) > contact_tuning.least_slope * y.norm() * step.norm();
    if (is_steep && (y + step).norm() < depth - enough) return has_other_axes_ = true;
    contacts_[i] = own;
    linearise(chart, y, i, i + 1);
    rows_[i].bound = bound;
  }
  return false;
}

bool ContactRows::replace_far_rows(const Chart& chart, const Vec6& y, const LeastDistance& nearest,
                                   double margin) noexcept {
  bool any = false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(nearest.active_count); ++k) {
    const auto i = static_cast<std::size_t>(nearest.active[k]);
    if (i >= count_ || !(nearest.multiplier[k] > 0)) continue;
    const auto [a, b] = pair_of_[i];
    const ClosestPoints p =
        closest_points(place(X_, corners(surface(probe_), a)), corners(surface(fixed_), b));
    if (!(p.gap > contact_tuning.far_from_row * std::max(contacts_[i].gap, margin))) continue;
    contacts_[i] = {p.a, p.b, p.normal, p.gap, 0};
    linearise(chart, y, i, i + 1);
    any = true;
  }
  return any;
}

ContactRows::PathCheck ContactRows::add_cuts(const Chart& chart, const Vec6& y,
                                             const Motion& motion, double margin,
                                             Effort& effort) noexcept {
  const PhaseTimer timer(times_, Phase::look);
  const double least = contact_tuning.kept_share * margin;
  const Transform end = motion.at(1);
  lists_.note_path(motion);
  if (lists_.serving().reach_at(end) <= least) {
    const Vec3 centre = least_moving_point(X_);
    const LinearizedMotion path = linearized(motion, centre);
    // The list should also suffice for the gather that follows the step.
    const double next =
        std::max({least, 2 * least_asked_,
                  contact_tuning.reach_after_step * path.course.size().of(probe_.mass.radius)});
    lists_.renew(X_, {next, near_of(next), least, centre, path}, effort);
  }
  NeighbourList& list = lists_.serving();
  PathCheck out;
  std::size_t found = 0;
  if (list.reach_at(end) > least)
    found = list.violations(end, least, violations_, effort);
  else if (!effort.is_limited())
    found = find_violations(probe_, fixed_, end, least, violations_, effort);
  else
    out.looked = false;
  const std::size_t before = count_;
  turn_ = std::max(turn_, motion.turn_bound());
  for (std::size_t i = 0; i < found; ++i) {
    const auto& [a, b, gap] = violations_[i];
    const Corners ta = place(X_, corners(surface(probe_), a));
    const ClosestPoints p = closest_points(ta, corners(surface(fixed_), b));
    effort.spend(contact_tuning.work_of_pair);
    if (!(p.distance > 0) || gap >= contact_tuning.kept_share * std::min(p.gap, margin)) continue;
    out.clear = false;
    out.lost = std::max(out.lost, std::min(p.gap, margin) - gap);
    smallest_gap_ = std::min(smallest_gap_, p.gap);
    kept_.keep({a, b});
    add_rows_of({p.a, p.b, p.normal, p.gap, a, b}, X_, infinity, &end);
  }
  linearise(chart, y, before);
  out.news = count_ > before;
  if (effort.is_spent()) out.clear = false;
  return out;
}

void ContactRows::linearise(const Chart& chart, const Vec6& y, std::size_t from,
                            std::size_t to) noexcept {
  for (std::size_t i = from; i < std::min(to, count_); ++i) {
    const Vec6 row = chart.row(y, contacts_[i].on_probe, contacts_[i].normal);
    at_[i] = row.dot(y);
    rows_[i].normal = allowed(row);
  }
  // Near its rim, the chart is a constraint like a contact: a step that would leave it slides on
  // it.
  const Vec3 v = chart.v(y);
  const double turn = v.norm();
  rim_ = turn > contact_tuning.rim_from * Chart::largest_v && method_ == Method::pdg;
  if (!rim_) return;
  Vec6 out = Vec6::Zero();
  out.head<3>() = chart.in_v(v / turn);
  // Scaled to metres, as the other rows are.
  rows_[count_] = {-out / out.norm(), -std::max(Chart::largest_v, turn) / out.norm()};
}

Sweep ContactRows::sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept {
  if (!lists_.serving().covers(motion, clearance)) {
    const PhaseTimer timer(times_, Phase::look);
    const Vec3 centre = least_moving_point(X_);
    lists_.renew(motion.at(0),
                 {clearance, near_of(clearance), clearance, centre, linearized(motion, centre)},
                 effort);
  }
  const PhaseTimer timer(times_, Phase::sweep);
  NeighbourList& list = lists_.serving();
  if (list.covers(motion, clearance)) return list.sweep_along(motion, clearance, effort);
  return sweep(probe_, fixed_, motion, clearance, effort);
}

Vec6 ContactRows::held_by_contacts(const LeastDistance& nearest) const noexcept {
  Vec6 y = nearest.y;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.active_count); ++i)
    if (const auto row = static_cast<std::size_t>(nearest.active[i]); row >= count_)
      y -= nearest.multiplier[i] * rows_[row].normal;
  return y;
}

ContactSet ContactRows::holding(const LeastDistance& nearest) const noexcept {
  ContactSet out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.active_count); ++i) {
    const auto row = static_cast<std::size_t>(nearest.active[i]);
    if (!(nearest.multiplier[i] > 0) || row >= count_) continue;
    Contact contact = contacts_[row];
    contact.multiplier = nearest.multiplier[i];
    out.push(contact);
  }
  return out;
}

LeastDistance ContactRows::solve(double margin, SmallGaps small_gaps, double rise) noexcept {
  const PhaseTimer timer(times_, Phase::solve);
  for (std::size_t i = 0; i < count_; ++i) {
    const double room = contacts_[i].gap - margin;
    rows_[i].bound = at_[i] - (small_gaps == SmallGaps::widen ? room : std::max(0.0, room)) + rise;
  }
  LeastDistance nearest =
      least_distance({rows_.data(), count_ + rim_}, contact_tuning.solved_to * margin);
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.active_count); ++i)
    if (const auto row = static_cast<std::size_t>(nearest.active[i]); row < count_)
      kept_.keep(pair_of_[row]);
  return nearest;
}

}  // namespace sonde
