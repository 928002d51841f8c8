// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/separating_directions.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/base/numbers.hpp"
#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/penetration/contact/separating_axes.hpp"

namespace sonde {
namespace {

/// The gaps of a pair along n and along −n.
struct Gaps {
  double along, against;
};
Gaps gaps(const Vec3& n, const TouchingPair& pair) {
  const std::array<double, 3> a{n.dot(pair.a[0]), n.dot(pair.a[1]), n.dot(pair.a[2])};
  const std::array<double, 3> b{n.dot(pair.b[0]), n.dot(pair.b[1]), n.dot(pair.b[2])};
  const auto [a_low, a_high] = std::minmax({a[0], a[1], a[2]});
  const auto [b_low, b_high] = std::minmax({b[0], b[1], b[2]});
  return {a_low - b_high, b_low - a_high};
}

template <class Visit>
bool any_in_plane(const TouchingPair& pair, const Visit& visit) {
  for (std::size_t i = 0; i < 3; ++i)
    if (visit(Vec3(edge_of(pair.a, i).cross(pair.face_a))) ||
        visit(Vec3(edge_of(pair.b, i).cross(pair.face_b))))
      return true;
  return false;
}

/// A direction, and the gap of each pair along it, m; minus infinity if the pair may not use it.
struct Candidate {
  Vec3 n;
  std::vector<double> gap;
};

class Cover {
 public:
  Cover(std::span<const TouchingPair> pairs, bool solid_a, bool solid_b, double slack)
      : pairs_(pairs),
        solid_a_(solid_a),
        solid_b_(solid_b),
        slack_(slack),
        direction_(pairs.size(), Vec3::Zero()),
        left_(pairs.size(), 1),
        count_left_(pairs.size()) {}

  std::optional<std::vector<Vec3>> find() {
    for (const TouchingPair& p : pairs_) add(p.face_b), add(p.face_a);
    if (!serves_all(best()))
      for (const TouchingPair& p : pairs_)
        any_edges(p.a, p.b, [&](const Vec3& n, auto, auto) { return !add(n); });
    take_best();
    if (count_left_ > 0) {
      for (std::size_t i = 0; i < pairs_.size(); ++i)
        if (left_[i]) any_in_plane(pairs_[i], [&](const Vec3& n) { return !add(n); });
      take_best();
    }
    if (count_left_ > 0) return std::nullopt;
    return direction_;
  }

 private:
  struct Choice {
    const Candidate* of = nullptr;
    std::size_t count = 0;  ///< pairs without a direction yet that it separates
    double least = 0;       ///< m: their least gap
  };

  bool serves_all(const Choice& choice) const { return choice.count == count_left_; }

  /// If the pair lies in a plane across n, then n must lead out of the solids.
  bool may_serve(const Vec3& n, const TouchingPair& p, double gap, double against) const {
    if (gap < -slack_) return false;
    if (against < -slack_) return true;
    return !(solid_a_ && n.dot(p.face_a) > contact_tuning.edge_on) &&
           !(solid_b_ && n.dot(p.face_b) < -contact_tuning.edge_on);
  }

  /// Adds both senses of an axis; returns false if there is no room for more.
  bool add(const Vec3& axis) {
    const double length = axis.norm();
    if (!(length > 0)) return true;
    const Vec3 n = axis / length;
    const bool known = std::any_of(pool_.begin(), pool_.end(), [&](const Candidate& c) {
      return (c.n - n).norm() < contact_tuning.same_direction ||
             (c.n + n).norm() < contact_tuning.same_direction;
    });
    if (known) return true;
    if (pool_.size() >= contact_tuning.most_directions) return false;
    Candidate one{n, std::vector<double>(pairs_.size(), -infinity)}, other{-n, one.gap};
    bool one_serves = false, other_serves = false;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Gaps g = gaps(n, pairs_[i]);
      if (may_serve(n, pairs_[i], g.along, g.against)) one.gap[i] = g.along, one_serves = true;
      if (may_serve(-n, pairs_[i], g.against, g.along))
        other.gap[i] = g.against, other_serves = true;
    }
    if (one_serves || !other_serves) pool_.push_back(std::move(one));
    if (other_serves) pool_.push_back(std::move(other));
    return true;
  }

  /// The candidate that separates the most pairs without a direction, and among equals the one that
  /// needs the least displacement.
  Choice best() const {
    Choice out;
    for (const Candidate& c : pool_) {
      Choice here{&c, 0, infinity};
      for (std::size_t i = 0; i < pairs_.size(); ++i)
        if (left_[i] && c.gap[i] > -infinity)
          ++here.count, here.least = std::min(here.least, c.gap[i]);
      if (here.count > out.count || (here.count == out.count && here.least > out.least)) out = here;
    }
    return out;
  }

  void take_best() {
    while (count_left_ > 0) {
      const Choice choice = best();
      if (choice.count == 0) return;
      for (std::size_t i = 0; i < pairs_.size(); ++i)
        if (left_[i] && choice.of->gap[i] > -infinity)
          direction_[i] = choice.of->n, left_[i] = 0, --count_left_;
    }
  }

  std::span<const TouchingPair> pairs_;
  bool solid_a_, solid_b_;
  double slack_;
  std::vector<Candidate> pool_;
  std::vector<Vec3> direction_;
  std::vector<std::uint8_t> left_;  // 1 for a pair without a direction
  std::size_t count_left_;
};

}  // namespace

TouchingPair touching_pair(const Corners& a, const Corners& b) {
  return {a, b, area_normal(a).stableNormalized(), area_normal(b).stableNormalized()};
}

double overlap_of(const TouchingPair& pair, double enough) {
  double overlap = infinity;
  const auto look = [&](const Vec3& axis) {
    const double length = axis.norm();
    if (!(length > 0)) return false;
    const Gaps g = gaps(axis / length, pair);
    overlap = std::min(overlap, -std::max(g.along, g.against));
    return overlap <= enough;
  };
  if (!look(pair.face_b) && !look(pair.face_a) &&
      !any_edges(pair.a, pair.b, [&](const Vec3& n, auto, auto) { return look(n); }))
    any_in_plane(pair, look);
  return overlap;
}

std::optional<std::vector<Vec3>> separating_directions(std::span<const TouchingPair> pairs,
                                                       bool solid_a, bool solid_b, double slack) {
  return Cover(pairs, solid_a, solid_b, slack).find();
}

}  // namespace sonde
