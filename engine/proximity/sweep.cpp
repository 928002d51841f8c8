// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep.hpp"

#include <bit>

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"
#include "engine/proximity/sweep_lanes.hpp"
#include "engine/proximity/triangle_lanes.hpp"

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
    const double longest = motion.farthest(a.mass.radius) * per_unit_;
    per_path_ = static_cast<float>(0.5 / std::max(longest, 1e-30));
    constexpr double up = 1 + 1e-6;
    bounds_.acceleration = static_cast<float>(motion.acceleration_per_radius() * up);
    bounds_.clearance =
        static_cast<float>((clearance + box_rounding * size + pairs_.guard()) * per_unit_ * up);
    bounds_.speed_rounding = static_cast<float>(
        box_rounding * (motion.linear_distance() + motion.turn_bound() * size) * per_unit_ * up);
  }

  Sweep run() {
    stack_.push(roots(a_.tree, b_.tree));
    while (pairs_.free_until() > 0) {
      if (!stack_.empty())
        visit(stack_.pop());
      else if (waiting_ > 0)
        advance_waiting();
      else
        break;
    }
    return pairs_.result();
  }

 private:
  /// One moment as the comparisons of boxes need it.
  struct Placed {
    int number = -1;
    Moment moment;
    FrameChange a_to_b, b_to_a;
    PlacedVelocity in_b, in_a;
    float com_b[3];  // in the frame of B's boxes
  };

  // Of an entry, `bound` is how far along the path the pair is known to be free.
  void visit(const SlotPair& p) {
    const double from = static_cast<double>(p.bound);
    if (from >= pairs_.free_until()) return;
    if (is_leaf(a_.tree, b_.tree, p)) {
      wait(a_.tree.child(p.a) & ~Tree::triangle_bit, b_.tree.child(p.b) & ~Tree::triangle_bit, p);
      return;
    }
    const bool opening_a = opens_a(a_.tree, b_.tree, p);
    const std::uint32_t child = opening_a ? a_.tree.child(p.a) : b_.tree.child(p.b);
    const Tree::Node& node = opening_a ? a_.tree.nodes[child] : b_.tree.nodes[child];
    const Placed& now = placed_before(p);
    Lanes steps;
    if (opening_a)
      kernels_.node_moves(placed(b_.tree, p.b, now.b_to_a, scale_), now.in_a, path(com_a_), node,
                          scale_, steps);
    else
      kernels_.box_moves(placed(a_.tree, p.a, now.a_to_b, scale_), now.in_b, path(now.com_b), node,
                         scale_, steps);
    const float start = static_cast<float>(now.number) / moments;
    SlotPairs found;
    // Rounded up: what is just beyond is found to be so when its turn comes.
    const float within =
        static_cast<float>(pairs_.free_until()) * (1 + 0x1p-20f) - start + 0x1p-20f;
    for (std::uint32_t left = at_most(steps, within, node); left != 0; left &= left - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(left));
      const float until = std::max(p.bound, (start + steps.value[k]) * (1 - 0x1p-22f));
      found.pair[static_cast<std::size_t>(found.count++)] =
          opening_a ? down_a(p, a_.tree, child, k, until) : down_b(p, b_.tree, child, k, until);
    }
    // The pair that may stop it first is looked at first: what it says rules out others.
    std::sort(found.pair.begin(), found.pair.begin() + found.count,
              [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
    for (const SlotPair& next : found) stack_.push(next);
  }

  struct Waiting {
    std::uint32_t i, j;
    double from;  // known to be free so far
    double s;     // of the moment at which they are compared
    Moment moment;
  };

  /// Most pairs of triangles are done with after one look, which eight take together.
  void wait(std::uint32_t i, std::uint32_t j, const SlotPair& p) {
    const Placed& now = placed_before(p);
    set_lane(lanes_, waiting_, place(now.moment.X, corners(a_.soup, i)), corners(b_.soup, j));
    queue_[static_cast<std::size_t>(waiting_++)] = {
        i, j, static_cast<double>(p.bound), static_cast<double>(now.number) / moments, now.moment};
    if (waiting_ == static_cast<int>(queue_.size())) advance_waiting();
  }

  void advance_waiting() {
    ClosestPoints8 points;
    closest_points(lanes_, waiting_, std::numeric_limits<double>::infinity(), points);
    for (int k = 0; k < waiting_; ++k) {
      const Waiting& w = queue_[static_cast<std::size_t>(k)];
      Vec3 n = Vec3::Zero();
      double from = w.from;
      if (points.gap[k] > 2 * pairs_.clearance()) {
        n = normal(points, k);
        from = std::max(from, w.s + pairs_.free_along(w.i, w.j, n, w.moment));
      }
      if (from < pairs_.free_until()) pairs_.advance(w.i, w.j, from, n);
    }
    waiting_ = 0;
  }

  /// The last moment, of those that suit the size of the boxes, before the pair's. Most visits are
  /// at the same few: they are kept.
  const Placed& placed_before(const SlotPair& p) {
    const float size = std::max(p.size_a, p.size_b) * scale_;
    const int wanted = static_cast<int>(std::min(1.0f, size * per_path_) * moments);
    const int grain = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(1, wanted))));
    const int reached = std::min(moments - 1, static_cast<int>(p.bound * moments));
    const int number = reached / grain * grain;
    Placed& kept = kept_[static_cast<std::size_t>(number / grain) % kept_.size()];
    if (kept.number == number) return kept;
    kept.number = number;
    kept.moment = Moment(motion_, static_cast<double>(number) / moments);
    const Moment& now = kept.moment;
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
  float per_path_;  // a part of 1 over the longest path of a point of A
  float com_a_[3];  // in the frame of A's boxes
  std::array<Placed, 64> kept_;
  TrianglePairs8 lanes_;
  std::array<Waiting, 8> queue_;
  int waiting_ = 0;
  PairStack<SlotPair> stack_;
};

}  // namespace

Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance) {
  return Sweeper(probe, fixed, motion, clearance).run();
}

}  // namespace sonde
