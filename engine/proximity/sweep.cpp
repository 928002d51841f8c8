// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep.hpp"

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

class Sweeper {
 public:
  Sweeper(const Body& a, const Body& b, const Motion& motion, double clearance)
      : a_(a),
        b_(b),
        motion_(motion),
        pairs_(a, b, motion, clearance),
        start_(a, b, pairs_.start().X),
        linear_(motion.linear_distance()),
        turn_(motion.turn_bound()) {}

  Sweep run() {
    stack_.push({0, 0, 0.0});
    while (!stack_.empty() && pairs_.free_until() > 0) visit(stack_.pop());
    return pairs_.result();
  }

 private:
  struct Entry {
    std::uint32_t a, b;
    double from;  // the pair is known to be free on [0, from]
  };

  void visit(const Entry& e) {
    if (e.from >= pairs_.free_until()) return;
    const Tree::Node& na = a_.tree.nodes[e.a];
    const Tree::Node& nb = b_.tree.nodes[e.b];
    const Vec3 arm = center(na) - motion_.com();
    const double radius = (arm.cwiseAbs() + half_size(na)).norm();
    // Further apart than the path is long for any point of the box: the quick way out.
    const double slack = start_.box_distance(na, nb) - pairs_.clearance() - pairs_.guard();
    if (slack > (linear_ + turn_ * radius) * pairs_.free_until()) return;
    const double s = advance_boxes(na, nb, arm, radius, e.from);
    if (s >= pairs_.free_until()) return;
    if (na.is_leaf() && nb.is_leaf()) {
      for (std::uint32_t i = na.first; i < na.first + na.count; ++i)
        for (std::uint32_t j = nb.first; j < nb.first + nb.count; ++j) {
          Vec3 normal = Vec3::Zero();
          pairs_.advance(i, j, s, normal);
        }
    } else if (open_first(na, nb)) {
      stack_.push({na.first + 1, e.b, s});
      stack_.push({na.first, e.b, s});
    } else {
      stack_.push({e.a, nb.first + 1, s});
      stack_.push({e.a, nb.first, s});
    }
  }

  /// The latest s up to which the boxes are known to be apart; not to the last bit, since children
  /// know more than their parents.
  double advance_boxes(const Tree::Node& na, const Tree::Node& nb, const Vec3& arm, double radius,
                       double s) {
    const Vec3 half = half_size(na);
    const double acceleration = motion_.acceleration_per_radius() * radius;
    const double size = std::max(half.maxCoeff(), half_size(nb).maxCoeff());
    for (int tries = 0; tries < 8; ++tries) {
      const Moment& now = pairs_.at(s);
      const Placement::BoxGap g = Placement::box_gap_at(now.X, pairs_.guard(), na, nb);
      const double slack = g.gap - pairs_.clearance();
      if (slack <= 0) return s;
      const Vec3 m = now.X.R.transpose() * g.axis.cross(now.velocity.angular);
      const double speed = g.axis.dot(now.velocity.linear) + m.dot(arm) - m.cwiseAbs().dot(half);
      s += safe_advance(slack, speed, acceleration);
      if (s >= pairs_.free_until() || slack < size) return s;
    }
    return s;
  }

  const Body& a_;
  const Body& b_;
  const Motion& motion_;
  PairSweep pairs_;
  Placement start_;
  double linear_, turn_;
  PairStack<Entry> stack_;
};

}  // namespace

Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance) {
  return Sweeper(probe, fixed, motion, clearance).run();
}

}  // namespace sonde
