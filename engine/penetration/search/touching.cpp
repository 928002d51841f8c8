// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/touching.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/separating_directions.hpp"
#include "engine/penetration/contact/touching_points.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/touching_tuning.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/violation.hpp"

namespace sonde {
namespace {

class Touch {
 public:
  Touch(const Body& probe, const Body& fixed, const Pose& device)
      : probe_(probe),
        fixed_(fixed),
        chart_(probe.mass, device),
        X_(device),
        rounding_(rounding_guard(extent(probe), extent(fixed), device.p)),
        level_(std::max(allowed_clearance(probe.mass.radius, 0),
                        touching_tuning.level_in_roundings * rounding_)) {}

  /// Finds the contacts of all touching pairs. Returns false if something overlaps, or if the
  /// contacts contradict each other.
  bool find_contacts() {
    if (!find_pairs()) return false;
    const auto directions =
        separating_directions(pairs_, probe_.solid, fixed_.solid, touching_tuning.reach * level_);
    if (!directions) return false;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (const Contact& c : touching_points(pairs_[i].a, pairs_[i].b, (*directions)[i],
                                              touching_tuning.reach * level_))
        contacts_.push_back(c);
    return !contacts_.empty();
  }

  /// Whether the contacts leave as much room as a descent does.
  bool has_room() const {
    return std::ranges::all_of(contacts_, [this](const Contact& c) {
      return c.gap >= touching_tuning.gaps[1] * rounding_;
    });
  }

  /// By the first of these gaps, in rounding errors, at which the probe is free.
  std::optional<Separation> come_free(Method method, std::span<const double> gaps) const {
    std::vector<HalfSpace> rows;
    for (const Contact& c : contacts_) {
      rows.push_back({chart_.row(Vec6::Zero(), c.on_probe, c.normal), 0});
      if (method == Method::pdt) rows.back().normal.head<3>().setZero();
    }
    for (const double gap : gaps) {
      for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].bound = gap * rounding_ - contacts_[i].gap;
      const LeastDistance nearest =
          least_distance(rows, contact_tuning.solved_to * gap * rounding_);
      if (!nearest.feasible || !(nearest.y.norm() <= level_)) return std::nullopt;
      Separation out = make_separation(chart_, outcome(nearest));
      if (!overlap(probe_, fixed_, Transform(out.separated), Doubt::exact)) return out;
    }
    return std::nullopt;
  }

 private:
  bool find_pairs() {
    std::vector<Violation> found(touching_tuning.first_pairs);
    if (!look(found)) return false;
    if (found.size() < touching_tuning.first_pairs) return !found.empty();
    found.resize(touching_tuning.most_pairs);
    return look(found) && found.size() < touching_tuning.most_pairs;
  }

  /// Collects as many pairs as there is room for. Returns false if one of them overlaps by more
  /// than a touch.
  bool look(std::vector<Violation>& found) {
    Effort unlimited;
    found.resize(
        find_violations(probe_, fixed_, X_, touching_tuning.reach * level_, found, unlimited));
    pairs_.clear();
    for (const Violation& v : found) {
      pairs_.push_back(touching_pair(place(X_, corners(surface(probe_), v.triangle_a)),
                                     corners(surface(fixed_), v.triangle_b)));
      if (v.gap <= 0 && overlap_of(pairs_.back(), level_) > level_) return false;
    }
    return true;
  }

  Descent::Outcome outcome(const LeastDistance& nearest) const {
    const Transform X(chart_.pose(nearest.y));
    Descent::Outcome out;
    for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.active_count); ++i) {
      Contact c = contacts_[static_cast<std::size_t>(nearest.active[i])];
      c.on_probe = X * (X_.R.transpose() * (c.on_probe - X_.p));
      c.gap = std::max(0.0, c.normal.dot(c.on_probe - c.on_fixed));
      c.multiplier = nearest.multiplier[i];
      if (c.multiplier > 0) out.contacts.push(c);
    }
    out.held = nearest.y;
    out.move_to(nearest.y);
    out.iterations = 1;
    out.converged = true;
    return out;
  }

  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  Transform X_;
  double rounding_;  // m: rounding error of coordinates when the probe is placed
  double level_;     // m: an overlap below this is a touch
  std::vector<TouchingPair> pairs_;
  std::vector<Contact> contacts_;
};

}  // namespace

std::optional<Separation> touching_separation(const Body& probe, const Body& fixed,
                                              const Pose& X_FM, Method method) {
  Touch touch(probe, fixed, X_FM);
  if (!touch.find_contacts()) return std::nullopt;
  std::optional<Separation> out = touch.come_free(method, touching_tuning.gaps);
  if (!out) return out;
  if (method == Method::pdt) {
    out->pdt = out->depth;
  } else if (const auto translated = touch.come_free(Method::pdt, touching_tuning.gaps)) {
    out->pdt = std::max(out->depth, translated->depth);
  }
  return out;
}

std::optional<Pose> lifted_off(const Body& probe, const Body& fixed, const Pose& X_FM,
                               Method method) {
  Touch touch(probe, fixed, X_FM);
  if (!touch.find_contacts() || touch.has_room()) return std::nullopt;
  const auto lifted = touch.come_free(method, std::span(touching_tuning.gaps).last(1));
  if (!lifted) return std::nullopt;
  return lifted->separated;
}

}  // namespace sonde
