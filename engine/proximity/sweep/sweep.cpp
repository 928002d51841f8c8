// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/sweep.hpp"

#include <bit>

#include "engine/base/ordering.hpp"
#include "engine/proximity/boxes/sweep_lanes.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/pair_sweep.hpp"
#include "engine/proximity/triangles/triangle_lanes.hpp"

namespace sonde {
namespace {

void copy(const Vec3& x, float (&out)[3]) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(x[i]);
}

class Sweeper {
 public:
  Sweeper(const Body& a, const Body& b, const Motion& motion, double clearance, PairsKeep keep,
          Effort& effort)
      : a_(a),
        b_(b),
        motion_(motion),
        pairs_(a, b, motion, clearance, keep),
        kernels_(sweep_kernels()),
        effort_(effort) {
    const Vec3 shift = pairs_.start().X * a.tree.origin - b.tree.origin;
    const double arm = (a.tree.origin - motion.com()).norm();
    const double size_a = (a.tree.high - a.tree.low).maxCoeff();
    const double size = size_a + (b.tree.high - b.tree.low).maxCoeff() +
                        shift.cwiseAbs().maxCoeff() + motion.farthest(arm);
    per_unit_ = std::ldexp(1.0, -std::ilogb(size));
    scale_ = static_cast<float>(per_unit_);
    const double longest = motion.farthest(a.mass.radius) * per_unit_;
    per_path_ = static_cast<float>(0.5 / std::max(longest, 1e-30));
    constexpr double up = 1 + 1e-6;
    bounds_.acceleration = static_cast<float>(motion.acceleration_per_radius() * up);
    bounds_.clearance =
        static_cast<float>((clearance + placing_guard(a.tree, b.tree) + pairs_.guard()) *
                           per_unit_ * up) +
        underflow_guard;
    // Velocities are computed at the middle of the smaller body, which may be far from the moving
    // one.
    const bool about_b = placing_guard(a.tree, b.tree) < box_rounding * size_a;
    const double reach = about_b ? size : size_a + arm;
    bounds_.speed_rounding = static_cast<float>(
        box_rounding * (motion.linear_distance() + motion.turn_bound() * reach) * per_unit_ * up);
  }

  Sweep run() {
    dive();
    stack_.push(roots(a_.tree, b_.tree));
    while (pairs_.free_until() > 0) {
      if (effort_.is_spent()) return give_up();
      if (!stack_.empty())
        visit(stack_.pop());
      else if (waiting_ > 0)
        look_at_waiting();
      else if (open_ > 0)
        advance_open();
      else
        break;
    }
    return pairs_.result();
  }

 private:
  /// One moment of the motion, with the data for the comparison of boxes.
  struct Placed {
    int number = -1;
    Moment moment;
    Frames frames;
    PlacedVelocity in_b, in_a;
    float com_b[3], com_a[3];  // relative to the middles
  };

  /// Descends through the pairs that may meet first, a few at a time: the triangles at the end
  /// bound the free path, so that less of it must be examined.
  void dive() {
    constexpr std::uint32_t all = 0xffff;
    const auto sooner = [](const SlotPair& x, const SlotPair& y) { return x.bound < y.bound; };
    std::array<SlotPair, abreast> level{roots(a_.tree, b_.tree)};
    SlotPairs next;
    for (std::size_t count = 1; count > 0;) {
      next.count = 0;
      for (std::size_t k = 0; k < count; ++k)
        opens_a(a_.tree, b_.tree, level[k]) ? open_a(level[k], all, next)
                                            : open_b(level[k], all, next);
      if (!effort_.spend(work_to_open(next.count))) return;
      const auto kept = std::min<std::ptrdiff_t>(next.count, abreast);
      ordering::partial_sort(next.begin(), next.begin() + kept, next.end(), sooner);
      count = 0;
      for (const SlotPair& p : std::span(next.begin(), next.begin() + kept)) {
        if (is_leaf(a_.tree, b_.tree, p))
          wait(a_.tree.child(p.a) & ~Tree::triangle_bit, b_.tree.child(p.b) & ~Tree::triangle_bit,
               p);
        else
          level[count++] = p;
      }
    }
    if (waiting_ > 0) look_at_waiting();
    if (open_ > 0) advance_open();
  }

  /// Ends the sweep at the point up to which all pairs not yet examined are known to be free.
  Sweep give_up() {
    double known = 1;
    while (!stack_.empty()) known = std::min(known, static_cast<double>(stack_.pop().bound));
    for (int k = 0; k < waiting_; ++k)
      known = std::min(known, queue_[static_cast<std::size_t>(k)].from);
    for (int k = 0; k < open_; ++k)
      known = std::min(known, open_queue_[static_cast<std::size_t>(k)].from);
    pairs_.give_up(known);
    return pairs_.result();
  }

  // The `bound` of an entry is how far along the path the pair is known to be free.
  void visit(const SlotPair& p) {
    const double from = static_cast<double>(p.bound);
    if (from >= pairs_.free_until()) return;
    if (is_leaf(a_.tree, b_.tree, p)) {
      wait(a_.tree.child(p.a) & ~Tree::triangle_bit, b_.tree.child(p.b) & ~Tree::triangle_bit, p);
      return;
    }
    SlotPairs found;
    open(p, found);
    effort_.spend(2 * work_to_open(found.count));
    // The pair that may stop the path first is examined first: its result excludes others.
    ordering::sort(found.begin(), found.end(),
                   [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
    for (const SlotPair& next : found) stack_.push(next);
  }

  /// The lanes of B's node (or of A's) whose boxes the box of A (of B) may meet before the current
  /// stop.
  std::uint32_t compare(const SlotPair& p, const Placed& now, const Tree::Node& node_b,
                        Lanes& steps) const {
    kernels_.box_moves(placed(a_.tree, p.a, now.frames.a_to_b, scale_), now.in_b, path(now.com_b),
                       node_b, scale_, steps);
    return at_most(steps, within(now), node_b);
  }
  std::uint32_t compare(const Tree::Node& node_a, const Placed& now, const SlotPair& p,
                        Lanes& steps) const {
    kernels_.node_moves(placed(b_.tree, p.b, now.frames.b_to_a, scale_), now.in_a, path(now.com_a),
                        node_a, scale_, steps);
    return at_most(steps, within(now), node_a);
  }
  /// The rest of the path from that moment on, rounded up: pairs slightly beyond are rejected when
  /// they are visited.
  float within(const Placed& now) const {
    return static_cast<float>(pairs_.free_until()) * (1 + 0x1p-20f) - start(now) + 0x1p-20f;
  }
  static float start(const Placed& now) { return static_cast<float>(now.number) / moments; }
  static float until(const SlotPair& p, float start, float step) {
    return std::max(p.bound, (start + step) * (1 - 0x1p-22f));
  }

  void open_a(const SlotPair& p, std::uint32_t lanes, SlotPairs& out) {
    const Placed& now = placed_before(p);
    const std::uint32_t child = a_.tree.child(p.a);
    Lanes steps;
    for (lanes &= compare(a_.tree.nodes[child], now, p, steps); lanes != 0; lanes &= lanes - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(lanes));
      out.push(down_a(p, a_.tree, child, k, until(p, start(now), steps.value[k])));
    }
  }
  void open_b(const SlotPair& p, std::uint32_t lanes, SlotPairs& out) {
    const Placed& now = placed_before(p);
    const std::uint32_t child = b_.tree.child(p.b);
    Lanes steps;
    for (lanes &= compare(p, now, b_.tree.nodes[child], steps); lanes != 0; lanes &= lanes - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(lanes));
      out.push(down_b(p, b_.tree, child, k, until(p, start(now), steps.value[k])));
    }
  }
  /// As Placement::open_both.
  void open(const SlotPair& p, SlotPairs& out) {
    constexpr std::uint32_t all = 0xffff;
    const std::uint32_t child_a = a_.tree.child(p.a), child_b = b_.tree.child(p.b);
    if (child_b & Tree::triangle_bit) return open_a(p, all, out);
    if (child_a & Tree::triangle_bit) return open_b(p, all, out);
    Lanes steps_a, steps_b;
    const Placed& now = placed_before(p);
    const std::uint32_t near_b = compare(p, now, b_.tree.nodes[child_b], steps_b);
    if (near_b == 0) return;
    const std::uint32_t near_a = compare(a_.tree.nodes[child_a], now, p, steps_a);
    const bool by_a = std::popcount(near_a) <= std::popcount(near_b);
    const float from = start(now);  // opening below may overwrite `now`
    for (std::uint32_t each = by_a ? near_a : near_b; each != 0; each &= each - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(each));
      const float step = by_a ? steps_a.value[k] : steps_b.value[k];
      const float known = until(p, from, step);
      if (by_a)
        open_b(down_a(p, a_.tree, child_a, k, known), near_b, out);
      else
        open_a(down_b(p, b_.tree, child_b, k, known), near_a, out);
    }
  }

  struct Waiting {
    std::uint32_t i, j;
    double from;  // known to be free up to here
    double s;     // of the moment at which the triangles are compared
    Moment moment;
    Vec3 normal = Vec3::Zero();  // separates them at that moment
    bool leads = false;          // the normal proves them free up to `from`
  };

  /// Most pairs of triangles are decided by one comparison, which handles eight at a time.
  void wait(std::uint32_t i, std::uint32_t j, const SlotPair& p) {
    const Placed& now = placed_before(p);
    set_lane(lanes_, waiting_, place(now.moment.X, corners(surface(a_), i)),
             corners(surface(b_), j));
    queue_[static_cast<std::size_t>(waiting_++)] = {
        i, j, static_cast<double>(p.bound), static_cast<double>(now.number) / moments, now.moment};
    if (waiting_ == static_cast<int>(queue_.size())) look_at_waiting();
  }

  void look_at_waiting() {
    ClosestPoints8 points;
    closest_points(lanes_, waiting_, std::numeric_limits<double>::infinity(), points);
    for (int k = 0; k < waiting_; ++k) {
      Waiting& w = queue_[static_cast<std::size_t>(k)];
      if (points.distance[k] > 0) w.normal = normal(points, k);
      w.leads = points.gap[k] > 2 * pairs_.clearance();
      if (w.leads)
        w.from = std::max(w.from, w.s + pairs_.step_along(w.i, w.j, w.normal, w.moment).length);
      if (w.from >= pairs_.free_until()) continue;
      set_lane(lanes_at_end_, open_, place(pairs_.end(), corners(surface(a_), w.i)),
               corners(surface(b_), w.j));
      open_queue_[static_cast<std::size_t>(open_++)] = w;
      if (open_ == static_cast<int>(open_queue_.size())) advance_open();
    }
    effort_.spend(work_to_advance * waiting_);
    waiting_ = 0;
  }

  /// Most of the remaining pairs only slide past each other. A comparison at the end of the path,
  /// eight pairs at a time, shows this.
  void advance_open() {
    ClosestPoints8 points;
    closest_points(lanes_at_end_, open_, std::numeric_limits<double>::infinity(), points);
    for (int k = 0; k < open_; ++k) {
      const Waiting& w = open_queue_[static_cast<std::size_t>(k)];
      if (w.from >= pairs_.free_until()) continue;
      if (w.normal != Vec3::Zero() && points.distance[k] > 0 &&
          pairs_.is_clear_between(w.i, w.j, w.s, w.moment, w.normal, normal(points, k)))
        continue;
      Vec3 n = w.leads ? w.normal : Vec3::Zero();
      effort_.spend(pairs_.advance(w.i, w.j, w.from, n));
    }
    effort_.spend(work_to_advance * open_);
    open_ = 0;
  }

  /// The last moment before the pair's `bound`, on a grid that suits the size of the boxes. Most
  /// visits use the same few moments, which are cached.
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
    kept.frames = frames(a_.tree, b_.tree, now.X, per_unit_);
    const Vec3 com_b = now.X * motion_.com() - b_.tree.origin - kept.frames.middle_b;
    const Vec3 com_a = motion_.com() - a_.tree.origin - kept.frames.middle_a;
    const Mat3 back = now.X.R.transpose();
    set_velocity(now.velocity.linear, now.velocity.angular, com_b, kept.in_b);
    set_velocity(back * now.velocity.linear, back * now.velocity.angular, com_a, kept.in_a);
    copy(com_b * per_unit_, kept.com_b);
    copy(com_a * per_unit_, kept.com_a);
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

  static constexpr std::size_t abreast = 8;   // the best of 1 to 16, measured
  static constexpr int moments = 4096;        // a power of two: number / moments is exact
  static constexpr int work_to_advance = 10;  // for a pair of triangles, in units of Effort
  const Body& a_;
  const Body& b_;
  const Motion& motion_;
  PairSweep pairs_;
  const SweepKernels& kernels_;
  Effort& effort_;
  double per_unit_;
  float scale_;
  PathBounds bounds_{};
  float per_path_;  // one over twice the longest path of a point of A
  std::array<Placed, 64> kept_;
  TrianglePairs8 lanes_, lanes_at_end_;
  std::array<Waiting, 8> queue_, open_queue_;
  int waiting_ = 0, open_ = 0;
  PairStack<SlotPair> stack_;
};

}  // namespace

Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance,
            Effort& effort) {
  return Sweeper(probe, fixed, motion, clearance, PairsKeep::half_of_start, effort).run();
}

Sweep sweep(const Body& probe, const Body& fixed, const Motion& motion, double clearance) {
  Effort unlimited;
  return sweep(probe, fixed, motion, clearance, unlimited);
}

Sweep sweep_within_room(const Body& probe, const Body& fixed, const Motion& motion,
                        double clearance, Effort& effort) {
  return Sweeper(probe, fixed, motion, clearance, PairsKeep::all, effort).run();
}

}  // namespace sonde
