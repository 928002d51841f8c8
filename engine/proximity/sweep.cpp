// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep.hpp"

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"
#include "engine/proximity/sweep_lanes.hpp"

namespace sonde {
namespace {

void copy(const Vec3& x, float (&out)[3]) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(x[i]);
}

class Sweeper {
 public:
  Sweeper(const Body& a, const Body& b, const Motion& motion, double clearance)
      : a_(a), b_(b), motion_(motion), pairs_(a, b, motion, clearance), kernels_(sweep_kernels()) {
    const Vec3 shift = pairs_.start().X * a.tree.origin - b.tree.origin;
    const double arm = (a.tree.origin - motion.com()).norm();
    const double size = (a.tree.high - a.tree.low).maxCoeff() +
                        (b.tree.high - b.tree.low).maxCoeff() + shift.cwiseAbs().maxCoeff() +
                        motion.farthest(arm);
    per_unit_ = std::exp2(-std::ilogb(size));
    scale_ = static_cast<float>(per_unit_);
    copy((motion.com() - a.tree.origin) * per_unit_, com_a_);
    constexpr double up = 1 + 1e-6;
    bounds_.acceleration = static_cast<float>(motion.acceleration_per_radius() * up);
    bounds_.clearance =
        static_cast<float>((clearance + box_rounding * size + pairs_.guard()) * per_unit_ * up);
    bounds_.speed_rounding = static_cast<float>(
        box_rounding * (motion.linear_distance() + motion.turn_bound() * size) * per_unit_ * up);
  }

  Sweep run() {
    stack_.push(roots(a_.tree, b_.tree));
    while (!stack_.empty() && pairs_.free_until() > 0) visit(stack_.pop());
    return pairs_.result();
  }

 private:
  /// One moment as the comparisons of boxes need it.
  struct Placed {
    int number = -1;
    FrameChange a_to_b, b_to_a;
    PlacedVelocity in_b, in_a;
    float com_b[3];  // in the frame of B's boxes
  };

  // Of an entry, `bound` is how far along the path the pair is known to be free.
  void visit(const SlotPair& p) {
    const double from = static_cast<double>(p.bound);
    if (from >= pairs_.free_until()) return;
    if (is_leaf(a_.tree, b_.tree, p)) {
      Vec3 normal = Vec3::Zero();
      pairs_.advance(a_.tree.child(p.a) & ~Tree::triangle_bit,
                     b_.tree.child(p.b) & ~Tree::triangle_bit, from, normal);
      return;
    }
    const bool opening_a = opens_a(a_.tree, b_.tree, p);
    const std::uint32_t child = opening_a ? a_.tree.child(p.a) : b_.tree.child(p.b);
    const Tree::Node& node = opening_a ? a_.tree.nodes[child] : b_.tree.nodes[child];
    const Placed& now = placed_before(from);
    Lanes steps;
    if (opening_a)
      kernels_.node_moves(placed(b_.tree, p.b, now.b_to_a, scale_), now.in_a, path(com_a_), node,
                          scale_, steps);
    else
      kernels_.box_moves(placed(a_.tree, p.a, now.a_to_b, scale_), now.in_b, path(now.com_b), node,
                         scale_, steps);
    const float start = static_cast<float>(now.number) / moments;
    SlotPairs found;
    for (std::uint32_t k = 0; k < Tree::width && node.child[k] != Tree::none; ++k) {
      const float until = std::max(p.bound, (start + steps.value[k]) * (1 - 0x1p-22f));
      if (static_cast<double>(until) >= pairs_.free_until()) continue;
      found.pair[static_cast<std::size_t>(found.count++)] =
          opening_a ? down_a(p, a_.tree, child, k, until) : down_b(p, b_.tree, child, k, until);
    }
    // The pair that may stop it first is looked at first: what it says rules out others.
    std::sort(found.pair.begin(), found.pair.begin() + found.count,
              [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
    for (const SlotPair& next : found) stack_.push(next);
  }

  /// The last of the moments before s. Most visits are at the same few: they are kept.
  const Placed& placed_before(double s) {
    const int number = std::min(moments - 1, static_cast<int>(s * moments));
    Placed& kept = kept_[static_cast<std::size_t>(number) % kept_.size()];
    if (kept.number == number) return kept;
    kept.number = number;
    const Moment now(motion_, static_cast<double>(number) / moments);
    kept.a_to_b = a_to_b(a_.tree, b_.tree, now.X, per_unit_);
    kept.b_to_a = b_to_a(a_.tree, b_.tree, now.X, per_unit_);
    const Vec3 com_b = now.X * motion_.com() - b_.tree.origin;
    const Mat3 back = now.X.R.transpose();
    set_velocity(now.velocity.linear, now.velocity.angular, com_b, kept.in_b);
    set_velocity(back * now.velocity.linear, back * now.velocity.angular,
                 motion_.com() - a_.tree.origin, kept.in_a);
    copy(com_b * per_unit_, kept.com_b);
    return kept;
  }

  void set_velocity(const Vec3& linear, const Vec3& angular, const Vec3& com,
                    PlacedVelocity& out) const {
    copy((linear - angular.cross(com)) * per_unit_, out.at_origin);
    copy(angular, out.angular);
  }

  PathBounds path(const float (&com)[3]) const {
    PathBounds bounds = bounds_;
    for (int i = 0; i < 3; ++i) bounds.com[i] = com[i];
    return bounds;
  }

  static constexpr int moments = 4096;  // a power of two: number / moments is exact
  const Body& a_;
  const Body& b_;
  const Motion& motion_;
  PairSweep pairs_;
  const SweepKernels& kernels_;
  double per_unit_;
  float scale_;
  PathBounds bounds_{};
  float com_a_[3];  // in the frame of A's boxes
  std::array<Placed, 64> kept_;
  PairStack<SlotPair> stack_;
};

}  // namespace

Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance) {
  return Sweeper(probe, fixed, motion, clearance).run();
}

}  // namespace sonde
