// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact_rows.hpp"

#include <algorithm>
#include <utility>

#include "engine/penetration/overlay.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

constexpr std::size_t most_rows = 128;
/// A list of so many pairs, up to twice as many, is made for its cost to be spread over many steps.
constexpr std::size_t good_list = 1000;
constexpr int work_to_take = 16;  // a pair, in the units of Effort

}  // namespace

ContactRows::ContactRows(const Body& probe, const Body& fixed, Method method,
                         const Finding& finding)
    : probe_(probe),
      fixed_(fixed),
      method_(method),
      list_(probe, fixed, finding.most_listed),
      pairs_(finding.most_pairs),
      contacts_(most_rows),
      rows_(most_rows),
      at_(most_rows),
      crowded_(probe.mass.radius),
      list_limit_(probe.mass.radius),
      list_reach_(probe.mass.radius) {}

void ContactRows::forget() noexcept {
  list_.clear();
  usual_ = {};
  gathered_ = false;
  count_ = 0;
  crowded_ = list_limit_ = list_reach_ = probe_.mass.radius;
}

void ContactRows::accept(const Contact& contact) noexcept {
  if (count_ < most_rows) contacts_[count_++] = contact;
}

bool ContactRows::is_news(const Contact& contact) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const Contact& row = contacts_[i];
    if (row.normal.dot(contact.normal) < 1 - 1e-12) continue;
    // A turn of the size to be expected brings it no nearer than the row.
    const double apart = (contact.on_probe - row.on_probe).norm();
    if (contact.gap - row.gap >= turn_ * apart) return false;
  }
  return true;
}

void ContactRows::take(const NearPair& pair, const Transform& X, double flat) noexcept {
  const Corners ta = place(X, corners(surface(probe_), pair.triangle_a));
  const Corners tb = corners(surface(fixed_), pair.triangle_b);
  Contact own{pair.on_a, pair.on_b, pair.normal, pair.gap, 0};
  for (std::size_t i = 0; i < count_; ++i) {
    const Contact& row = contacts_[i];
    if (gap_along(row.normal, ta, tb) < row.gap * (1 - 1e-9)) continue;
    own.normal = row.normal;
    own.gap = row.normal.dot(own.on_probe - own.on_fixed);
    break;
  }
  if (is_news(own)) accept(own);
  if (pair.gap > flat) return;
  for (const Contact& corner : overlay(ta, tb, own.normal))
    if (is_news(corner)) accept(corner);
}

Vec3 ContactRows::middle() const noexcept {
  if (count_ == 0) return probe_.mass.com;
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < count_; ++i) sum += contacts_[i].on_probe;
  return X_.R.transpose() * (sum / static_cast<double>(count_) - X_.p);
}

void ContactRows::list_pairs(const Transform& X, double reach, const Vec3& centre,
                             const PairList::Displacement& ahead, Effort& effort) noexcept {
  const double radius = probe_.mass.radius, wanted = reach + ahead.of(radius);
  // A list pays where the steps are short beside its reach; long steps walk the trees.
  if (list_.capacity() == 0 || wanted >= 0.02 * radius) return;
  usual_ = {std::max(0.9 * usual_.linear, ahead.linear), std::max(0.9 * usual_.turn, ahead.turn)};
  const double ample = std::max(1.5 * wanted, std::min({32 * wanted, list_limit_, list_reach_}));
  const double share = usual_.linear > 0 ? usual_.linear / usual_.of(radius) : 0.5;
  const PairList::Displacement room{std::max(share * ample, 1.5 * (reach + ahead.linear)),
                                    std::max((1 - share) * ample / radius, 1.5 * ahead.turn)};
  const bool fits = list_.build(X, centre, room, effort);
  // Where surfaces lie close over a wide area the list overflows: the next one reaches less far.
  list_limit_ = fits ? std::min(1.5 * list_limit_, radius) : 2 * wanted;
  const bool few = list_.size() < good_list;
  const bool many = list_.size() > 2 * good_list;
  list_reach_ = ample * (!fits ? 0.5 : few ? 1.5 : many ? 0.7 : 1.0);
}

NearPairs ContactRows::find_pairs(const Transform& X, double reach, Effort& effort) noexcept {
  if (list_.reach_at(X) < reach) list_pairs(X, reach, middle(), {}, effort);
  const NearPairs near = list_.reach_at(X) >= reach
                             ? list_.near(X, reach, pairs_, effort)
                             : near_pairs(probe_, fixed_, X, reach, pairs_, effort);
  if (near.reach < 0) return near;
  crowded_ = near.reach < reach ? near.reach : std::min(1.5 * crowded_, probe_.mass.radius);
  return near;
}

bool ContactRows::gather(const Chart& chart, const Vec6& y, double reach, double flat,
                         Effort& effort) noexcept {
  const Transform X(chart.pose(y));
  asked_ = std::min(reach, crowded_);
  const NearPairs near = find_pairs(X, asked_, effort);
  gathered_ = near.reach >= 0 && !effort.is_spent();
  if (!gathered_) return false;
  count_ = 0;
  smallest_gap_ = reach_ = near.reach;
  X_ = X;
  turn_ = 2 * reach_ / probe_.mass.radius;
  const std::span<NearPair> pairs(pairs_.data(), near.count);
  std::sort(pairs.begin(), pairs.end(), [](const NearPair& p, const NearPair& q) {
    if (p.gap != q.gap) return p.gap < q.gap;
    return std::pair(p.triangle_a, p.triangle_b) < std::pair(q.triangle_a, q.triangle_b);
  });
  if (!pairs.empty()) smallest_gap_ = pairs.front().gap;
  for (const NearPair& p : pairs) {
    effort.spend(work_to_take);
    take(p, X, flat);
  }
  linearise(chart, y);
  return true;
}

bool ContactRows::again(const Chart& chart, const Vec6& y) noexcept {
  if (!gathered_) return false;
  const Transform X(chart.pose(y));
  const Vec3& com = probe_.mass.com;
  const double moved = (X * com - X_ * com).norm() + (X.R - X_.R).norm() * probe_.mass.radius;
  if (moved > rounding_guard(extent(probe_), extent(fixed_), X.p)) return false;
  linearise(chart, y);
  return true;
}

void ContactRows::carry(const Chart& chart, const Vec6& y) noexcept {
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

void ContactRows::linearise(const Chart& chart, const Vec6& y) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    rows_[i].normal = chart.row(y, contacts_[i].on_probe, contacts_[i].normal);
    at_[i] = rows_[i].normal.dot(y);
    if (method_ == Method::pdt) rows_[i].normal.head<3>().setZero();
  }
}

double ContactRows::quick_path(const Chart& chart, const Vec6& y) const noexcept {
  const double far = probe_.mass.radius;
  if (crowded_ >= far && list_limit_ >= far) return std::numeric_limits<double>::infinity();
  return std::max(2 * reach_, list_.reach_at(Transform(chart.pose(y))));
}

Sweep ContactRows::sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept {
  if (!list_.covers(motion, clearance)) {
    const Vec3 centre = middle();
    list_pairs(motion.at(0), clearance, centre, PairList::along(motion, centre), effort);
  }
  if (list_.covers(motion, clearance)) return list_.sweep_along(motion, clearance, effort);
  return sweep(probe_, fixed_, motion, clearance, effort);
}

ContactSet ContactRows::holding(const LeastDistance& nearest) const noexcept {
  ContactSet out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.active_count); ++i) {
    if (!(nearest.multiplier[i] > 0)) continue;
    Contact contact = contacts_[static_cast<std::size_t>(nearest.active[i])];
    contact.multiplier = nearest.multiplier[i];
    out.push(contact);
  }
  return out;
}

LeastDistance ContactRows::solve(double margin, Narrow narrow) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const double room = contacts_[i].gap - margin;
    rows_[i].bound = at_[i] - (narrow == Narrow::open ? room : std::max(0.0, room));
  }
  return least_distance({rows_.data(), count_}, 0.05 * margin);
}

}  // namespace sonde
