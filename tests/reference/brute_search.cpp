// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/base/numbers.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

const DescentGoal coarse{.residual = 5e-3, .steps = 40};

/// A spiral over the sphere, turned at random: every seed comes in from elsewhere.
std::vector<Vec3> directions(int count, std::mt19937_64& random) {
  const Quat turn = test::random_rotation(random);
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    out.push_back(turn * Vec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  return out;
}

struct Found {
  Vec6 y;
  Origin origin;
};

class Search {
 public:
  Search(const Body& probe, const Body& fixed, const Pose& device, const BruteOptions& options)
      : probe_(probe),
        fixed_(fixed),
        chart_(probe.mass, device),
        options_(options),
        random_(options.seed),
        rotate_(options.method == Method::pdg),
        descent_(probe, fixed, options.method),
        shift_(probe, fixed, Method::pdt) {}

  BruteResult run() {
    from_outside();
    from_random_poses();
    hop();
    BruteResult out = polish();
    out.reached = std::move(reached_);
    return out;
  }

 private:
  bool is_free(const Vec6& y, Doubt doubt) const {
    return !overlap(probe_, fixed_, Transform(chart_.pose(y)), doubt);
  }
  Vec6 descend(Descent& by, const Vec6& from, Origin origin) {
    Vec6 y = by.run(chart_, from, coarse, 0, {}).y;
    found_.push_back({y, origin});
    if (y.norm() < depth()) best_ = y;
    return y;
  }
  double depth() const { return best_ ? best_->norm() : infinity; }

  /// In to contact by translation alone, and on from there with all unknowns.
  void from_outside() {
    const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
    const double half = (fixed_.tree.high - center).norm();
    const double away = 1.01 * ((chart_.com() - center).norm() + half + probe_.mass.radius);
    for (const Vec3& d : directions(options_.directions, random_)) {
      Vec6 y = Vec6::Zero();
      y.tail<3>() = away * d;
      y = descend(shift_, y, Origin::outside);
      if (rotate_) descend(descent_, y, Origin::outside);
    }
  }

  void from_random_poses() {
    for (int i = 0; i < options_.starts; ++i)
      if (const auto y = i % 4 == 3 ? free_pose_near() : free_pose())
        reached_.push_back(descend(descent_, *y, Origin::random).norm());
  }

  /// On from the best: where the contact space is rugged the next basin is often a better one.
  void hop() {
    for (int i = 0; i < options_.hops; ++i)
      for (int tries = 0; tries < 100; ++tries) {
        const double away = depth() * std::pow(10, test::uniform(random_, -1.5, -0.3));
        const Vec6 y = *best_ + in_ball(away);
        if (!may_begin(y)) continue;
        descend(descent_, y, Origin::hop);
        break;
      }
  }

  bool may_begin(const Vec6& y) const {
    return chart_.v(y).norm() < 0.95 && is_free(y, Doubt::contact);
  }

  Vec6 in_ball(double radius) {
    for (;;) {
      Vec6 y;
      for (int i = 0; i < 6; ++i) y[i] = test::uniform(random_, -1, 1);
      if (!rotate_) y.head<3>().setZero();
      if (y.squaredNorm() > 1) continue;
      for (int i = 0; i < 3; ++i)
        if (!(probe_.mass.inertia[i] > 0)) y[i] = 0;
      return radius * y;
    }
  }

  /// In balls from a thirtieth of the best depth so far up to it; where all of them are full, as
  /// everywhere else.
  std::optional<Vec6> free_pose_near() {
    for (int tries = 0; tries < 500; ++tries) {
      Vec6 y = in_ball(depth() * std::pow(10, test::uniform(random_, -1.5, 0)));
      if (may_begin(y)) return y;
    }
    return free_pose();
  }

  /// In a ball of 1.4 to 3 times the best depth so far; wider from then on where fewer than one
  /// pose in a thousand is free.
  std::optional<Vec6> free_pose() {
    for (int widened = 0; widened < 40; ++widened) {
      const double radius = widening_ * depth() * test::uniform(random_, 1.4, 3);
      for (int tries = 0; tries < 1000; ++tries) {
        Vec6 y = in_ball(radius);
        if (may_begin(y)) return y;
      }
      widening_ *= 1.1;
    }
    return std::nullopt;
  }

  /// True where the pose is all but one of those.
  static bool is_among(const std::vector<Vec6>& those, const Vec6& y) {
    return std::any_of(those.begin(), those.end(),
                       [&](const Vec6& other) { return (y - other).norm() < 0.02 * other.norm(); });
  }

  BruteResult polish() {
    sort(found_);
    std::vector<Vec6> tried;
    std::vector<Found> finer;
    for (const Found& found : found_) {
      if (static_cast<int>(tried.size()) >= options_.polished) break;
      if (is_among(tried, found.y)) continue;
      tried.push_back(found.y);
      finer.push_back({descend_on(found.y, 0.1, 60), found.origin});
    }
    sort(finer);
    BruteResult out;
    out.depth = infinity;
    for (std::size_t i = 0; i < finer.size(); ++i) {
      keep_better(out, finer[i]);
      // A descent that stalled, or had no end, goes on with a fresh idea of its pace.
      if (i < 3) keep_better(out, {descend_on(finer[i].y, 0.02, 200), finer[i].origin});
    }
    return out;
  }

  Vec6 descend_on(const Vec6& from, double expected, int steps) {
    const DescentGoal goal{.residual = 1e-4, .steps = steps};
    return descent_.run(chart_, from, goal, expected * from.norm(), {}).y;
  }

  static void sort(std::vector<Found>& found) {
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.y.norm() < b.y.norm(); });
  }

  void keep_better(BruteResult& out, const Found& found) const {
    const double depth = found.y.norm();
    if (depth >= out.depth || !is_free(found.y, Doubt::exact)) return;
    out.depth = depth;
    out.separated = chart_.pose(found.y);
    out.origin = found.origin;
  }

  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  BruteOptions options_;
  std::mt19937_64 random_;
  bool rotate_;
  Descent descent_, shift_;
  std::vector<Found> found_;
  std::vector<double> reached_;
  std::optional<Vec6> best_;
  double widening_ = 1;
};

}  // namespace

const char* name(Origin origin) {
  constexpr std::array names = {"outside", "random", "hop"};
  return names[static_cast<std::size_t>(origin)];
}

BruteResult brute_search(const Body& probe, const Body& fixed, const Pose& X_FM,
                         const BruteOptions& options) {
  return Search(probe, fixed, {X_FM.q.normalized(), X_FM.p}, options).run();
}

}  // namespace sonde::reference
