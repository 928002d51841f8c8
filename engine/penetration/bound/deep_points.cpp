// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/deep_points.hpp"

#include <algorithm>

#include "engine/base/ordering.hpp"
#include "engine/penetration/bound/bound_tuning.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// Searches for the deepest points. Each of the two depths has Lipschitz constant 1, so the depth
/// at one point of a box bounds the depths in the whole box.
class DeepPoints {
 public:
  DeepPoints(const CommonDepth& depth, int work, const Deadline& deadline)
      : depth_(depth),
        deadline_(deadline),
        corners_(static_cast<int>(bound_tuning.share_for_corners * work /
                                  bound_tuning.work_of_evaluation)) {}

  std::vector<CommonPoint> run() {
    const Body &probe = depth_.probe(), &fixed = depth_.fixed();
    where_triangles_meet();
    if (fixed.solid) corners(probe, depth_.X_MW());
    if (probe.solid) corners(fixed, depth_.X_FW());
    if (probe.solid && fixed.solid) between();
    const std::vector<CommonPoint> before = points_;
    for (const CommonPoint& p : before) {
      points_.push_back(
          depth_.ascend(still_, p, bound_tuning.last_stride * p.depth(), bound_tuning.last_ascent));
      inwards(points_.back());
    }
    return points_;
  }

 private:
  /// Keeps the deepest points, no two of them close together.
  void offer(const CommonPoint& s) {
    if (s.depth() <= 0) return;
    for (CommonPoint& t : points_)
      if ((t.x - s.x).norm() < bound_tuning.apart * std::max(s.depth(), t.depth())) {
        if (t.depth() < s.depth()) t = s;
        return;
      }
    points_.push_back(s);
    std::stable_sort(points_.begin(), points_.end(),
                     [](const auto& p, const auto& q) { return p.depth() > q.depth(); });
    if (points_.size() > bound_tuning.most_points) points_.pop_back();
  }

  /// Adds points that are as deep but nearer to the centre of mass, which a turn displaces less.
  void inwards(const CommonPoint& from) {
    const CommonPoint start = from;
    for (const double left : bound_tuning.inwards) {
      const CommonPoint next = depth_.at(still_, left * start.x);
      if (next.depth() < bound_tuning.as_deep * start.depth()) return;
      points_.push_back(next);
    }
  }

  CommonPoint look(const Transform& X, const Vec3& x) {
    CommonPoint s = depth_.at(still_, X.R.transpose() * (x - X.p));
    offer(s);
    return s;
  }

  /// Evaluates points at which triangles intersect. In a shallow contact these may be the only
  /// points that lie in both bodies.
  void where_triangles_meet() {
    const Body &a = depth_.probe(), &b = depth_.fixed();
    const Placement at(a, b, depth_.X_FM());
    const double stride = bound_tuning.meeting_stride * std::min(a.mass.radius, b.mass.radius);
    PairStack<SlotPair> stack;
    SlotPairs found;
    stack.push(at.roots());
    for (int opened = 0, meetings = 0; !stack.empty() && opened < bound_tuning.most_opened &&
                                       meetings < bound_tuning.most_meetings;) {
      const SlotPair p = stack.pop();
      if (at.is_leaf(p)) {
        const ClosestPoints c =
            closest_points(at.corners_a(at.triangle_a(p)), at.corners_b(at.triangle_b(p)));
        if (c.distance > 0) continue;
        ++meetings;
        offer(depth_.ascend(still_, look(depth_.X_FW(), c.b), stride, bound_tuning.meeting_ascent));
        continue;
      }
      ++opened;
      at.open_overlapping(p, Opening::larger, found);
      ordering::sort(found.begin(), found.end(),
                     [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
      for (const SlotPair& child : found) stack.push(child);
    }
  }

  struct Slot {
    std::uint32_t slot;
    double most;  // m: upper bound of the depth on its triangles
    bool operator<(const Slot& o) const { return most < o.most; }
  };
  /// Evaluates corners of a body, those with the largest upper bound first.
  void corners(const Body& body, const Transform& X) {
    const Tree& tree = body.tree;
    ordering::Queue<Slot> queue;
    const auto look_at = [&](std::uint32_t slot) {
      const Vec3 x = surface(body).vertices[surface(body).triangles[tree.first_triangle(slot)][0]];
      queue.push({slot, look(X, x).depth() + 2 * tree.half_diagonal(slot)});
    };
    look_at(0);
    const int until = depth_.evaluations() + corners_;
    while (!queue.empty() && depth_.evaluations() < until && !deadline_.passed()) {
      const Slot s = queue.top();
      queue.pop();
      if (s.most <= 0) break;
      const std::uint32_t child = tree.child(s.slot);
      if (child & Tree::triangle_bit) {
        if (tree.half_diagonal(s.slot) > bound_tuning.large_triangle * body.mass.radius)
          spread(corners_of(body, child & ~Tree::triangle_bit), X);
        continue;
      }
      for (std::uint32_t k = 0; k < Tree::width && tree.nodes[child].child[k] != Tree::none; ++k)
        look_at(child * Tree::width + k);
    }
  }

  static Corners corners_of(const Body& body, std::uint32_t triangle) {
    return sonde::corners(surface(body), triangle);
  }
  /// Samples points inside a large triangle: its corners may be far from its deepest point.
  void spread(const Corners& t, const Transform& X) {
    look(X, (t[0] + t[1] + t[2]) / 3);
    for (std::size_t k = 0; k < 3; ++k) {
      look(X, t[k]);
      look(X, (t[k] + t[(k + 1) % 3]) / 2);
    }
  }

  struct Box {
    Vec3 low, high;  // fixed frame
    double most;     // m: upper bound of the depth in the box
    bool operator<(const Box& o) const { return most < o.most; }
  };
  /// Bisects the box in which two solids may overlap, the part with the largest upper bound first.
  void between() {
    const Tree& tree = depth_.fixed().tree;
    const Vec3 com = depth_.X_FW().p, reach = Vec3::Constant(depth_.probe().mass.radius);
    const Box all{tree.low.cwiseMax(com - reach), tree.high.cwiseMin(com + reach), 0};
    if (!((all.high - all.low).minCoeff() > 0)) return;
    ordering::Queue<Box> queue;
    const auto look_at = [&](const Box& b) {
      const CommonPoint s = look(depth_.X_FW(), (b.low + b.high) / 2);
      queue.push({b.low, b.high, s.depth() + (b.high - b.low).norm()});
    };
    look_at(all);
    for (int n = 0; n < bound_tuning.most_boxes && !deadline_.passed(); n += 2) {
      const Box b = queue.top();
      queue.pop();
      if (b.most <= 0) break;
      Eigen::Index axis = 0;
      (b.high - b.low).maxCoeff(&axis);
      Box low = b, high = b;
      low.high[axis] = high.low[axis] = (b.low[axis] + b.high[axis]) / 2;
      look_at(low), look_at(high);
    }
  }

  const CommonDepth& depth_;
  const Deadline& deadline_;
  int corners_;  // evaluations at those of each body
  const Mat3 still_ = Mat3::Identity();
  std::vector<CommonPoint> points_;
};

}  // namespace

std::vector<CommonPoint> deep_points(const CommonDepth& depth, int work, const Deadline& deadline) {
  return DeepPoints(depth, work, deadline).run();
}

}  // namespace sonde
