// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/coherent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/base/phase_timer.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/falls.hpp"
#include "engine/penetration/search/free_region.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/penetration/search/touching.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

namespace {

/// Beyond this many times the bodies' size, rounding of coordinates exceeds the geometry.
constexpr double farthest = 1e9;

/// R: if the device moves further than this in one tick, the motion counts as a jump.
constexpr double jump_of_device = 0.25;
/// Units of Effort, some 10 ns each: limit of a tick after such a jump, if the caller sets none.
/// The long path that is then swept can pass all of the bodies. The tick says that it has not
/// converged and that a limit acted; the next ones continue, with the same limit.
constexpr std::int64_t work_after_jump = 3'000'000;
/// Factor on the device's motion: a probe that is further from the device is held by its contacts,
/// and does not just follow.
constexpr double held_off = 4;
/// The same, some 5 ms, of a tick that is a fall: the separated probe itself has moved as far, or
/// is held and has a path that takes too much to sweep. It is the contact's doing, and a hand that
/// waits for it is lost.
/// (The longest ticks of crumpled-soup, terrain, peg-in-hole and four jammed nuts took 32, 15, 26
/// and 36 to 83 ms with a limit of 3 million for what came far alone, and take 7, 9, 14 and 7 to 8
/// ms; 22, 1, 2 and 9 to 19 ticks do not converge where it was 9, 0, 0 and 0 to 7.)
constexpr std::int64_t work_of_fall = 450'000;
/// The same, about a second: the limit is doubled after a tick that changes nothing while the
/// device rests, and begins anew as soon as it moves.
constexpr std::int64_t most_work_of_fall = 100'000'000;
/// R: the device rests if it moves by no more in one tick.
constexpr double resting = 1e-6;

}  // namespace

struct CoherentSolver::State {
  Pair pair;
  const Body& probe = pair.probe();
  const Body& fixed = pair.fixed();
  Method method;
  Descent descent;
  ClusterIds ids;
  FreeRegion free_region{probe, fixed};
  PhaseTimes times;  ///< of this tick, if timing is on
  bool timed = false;
  Separation last;
  Pose device;       ///< the last device pose that was not refused
  Pose separated;    ///< the last separated pose: free
  double depth = 0;  ///< m: of that pose, whatever was refused since
  /// Where the first tick in which the device moves begins, if `separated` touches within rounding.
  std::optional<Pose> lifted;
  bool started = false;
  /// Units of Effort: limit of a tick without one, while the probe has not yet reached its optimum
  /// after a jump of the device or a fall; 0: none.
  std::int64_t limit_while_behind = 0;
  /// Units of Effort: limit of a tick that becomes a fall; larger while nothing moves.
  std::int64_t limit_of_fall = work_of_fall;
  Falls falls;

  State(const Pair& bodies, Method m)
      : pair(bodies), method(m), descent(probe, fixed, m, {}, Descent::gap_of_follower), falls(m) {
    last.reason = "not started";
  }

  /// If a rotation about an axis has zero inertia, the probe may come back to O with another angle
  /// about that axis than the device. If O itself is then not free, the answer is the pose reached,
  /// at depth 0.
  void keep_spin(const Chart& chart) noexcept {
    if (probe.mass.inertia.minCoeff() > 0 || last.status != Status::separated) return;
    if (!triangles_meet(probe, fixed, Transform(last.device), Doubt::contact)) return;
    last.status = Status::penetrating;
    last.separated = chart.pose(Vec6::Zero());
  }

  /// Also after a tick that was refused, which says nothing of the pose.
  bool was_free() const noexcept {
    return separated.p == device.p && separated.q.coeffs() == device.q.coeffs();
  }

  /// The device's motion, m, which limits by how much the depth may fall without a jump: √σ; with
  /// translation only, the largest motion of any point of the probe.
  double device_motion(const Pose& to) const noexcept {
    const Chart from(probe.mass, device);
    const Vec6 y = from.coordinates(to);
    if (method == Method::pdg) return y.norm();
    return y.tail<3>().norm() + 2 * from.v(y).norm() * probe.mass.radius;
  }

  /// m²: the part of σ that the tick released: twice the work of the force, per stiffness, over the
  /// separated probe's motion from y = `from` to `to`. On a path of optima it is 0, since the
  /// contacts do no work. With translation only: what the depth lost from `depth_before`.
  double let_go(const Chart& chart, const Vec6& from, const Vec6& to,
                double depth_before) const noexcept {
    if (method == Method::pdt) return depth_before * depth_before - last.sigma;
    const Vec6 before = from - chart.coordinates(device);
    return (from - to).dot(before + to);
  }

  bool within_reach(const Pose& X) const {
    return X.p.cwiseAbs().maxCoeff() <= farthest * (extent(probe) + extent(fixed));
  }

  /// Whether the device rests: in coordinates of its own pose, a motion is not 0 to the bit.
  bool rests(double moved) const noexcept { return moved <= resting * probe.mass.radius; }

  /// The effort of a tick. After a jump or a fall it is limited even if no limit was asked for, and
  /// so are the next ticks until the probe has caught up.
  Effort effort_of(const Budget& budget, double moved) noexcept {
    if (last.converged) limit_while_behind = 0, limit_of_fall = work_of_fall;
    if (moved > jump_of_device * probe.mass.radius) limit_while_behind = work_after_jump;
    if (!rests(moved)) limit_of_fall = work_of_fall;
    const double until = budget.microseconds > 0 ? now_us() + budget.microseconds : 0;
    const bool unlimited = budget.work == 0 && until == 0;
    const std::int64_t own =
        limit_while_behind > 0 ? std::max(limit_while_behind, limit_of_fall) : 0;
    return {unlimited ? own : budget.work, until};
  }

  /// After a tick that its own limit stopped. `same`: its work ran out, the device rests, and |y|
  /// has not fallen by more than the clearance. The next tick would be the same, and so on for
  /// ever: it gets twice as much.
  void learn_limit(bool same) noexcept {
    limit_while_behind = std::max(limit_while_behind, work_of_fall);
    if (same) limit_of_fall = std::min(2 * limit_of_fall, most_work_of_fall);
  }

  /// If the probe was free and cannot have reached any contact since, sets the result that a
  /// descent would find (in its one step, or in none if there is nothing to do) and returns true.
  bool stays_free(const Pose& to) noexcept {
    if (last.status != Status::separated || !free_region.covers(to)) return false;
    const bool turns = device.q.coeffs() != to.q.coeffs();
    const bool follows_in_step =
        method == Method::pdg ? turns || device.p != to.p : !turns && device.p != to.p;
    last = separated_at(to);
    last.iterations = follows_in_step;
    device = separated = to;
    depth = 0;
    return true;
  }

  /// Near a half turn, w = √(1 − v²) is lost to rounding, which limits the accuracy of a pose and
  /// of a motion from there. Returns true if the probe has room for that error; else it must stay.
  bool has_room_for_rounding(const Chart& chart, const Vec6& y, Effort& effort) noexcept {
    const double v2 = chart.v(y).squaredNorm();
    if (v2 <= Chart::largest_v * Chart::largest_v) return true;
    if (!(1 - v2 > Motion::least_w2)) return false;
    const double lost = 4 * std::numeric_limits<double>::epsilon() / std::sqrt(1 - v2);
    const double off =
        farthest_move(probe.mass, separated, chart.pose(y)) + lost * 2 * probe.mass.radius;
    if (off <= rounding_guard(extent(probe), extent(fixed), separated.p)) return true;
    const Transform X(separated);
    if (triangles_meet(probe, fixed, X, Doubt::contact)) return false;
    std::array<NearPair, 2> nearest;
    const NearPairs near = near_pairs(probe, fixed, X, 4 * off, nearest, effort);
    double room = near.reach;
    for (std::size_t i = 0; i < near.count; ++i) room = std::min(room, nearest[i].gap);
    return room > 2 * off;
  }

  /// Translation only: before the descent, the separated probe turns with the device in one swept
  /// motion. It tries the position at which the rows of the last tick let the probe rest; then
  /// positions lifted off the contacts by multiples of the distance that the turn can move a point
  /// of the probe (the descent lowers it again). Returns false if all of these are blocked; y is
  /// then turned as far as possible.
  bool follow_turn(const Chart& chart, Effort& effort, Vec6& y) noexcept {
    if (!(y.head<3>().norm() > 0)) return true;
    const double depth = y.tail<3>().norm();
    const double reach = 2 * chart.v(y).norm() * probe.mass.radius;
    Vec6 furthest = y;
    const auto turns_to = [&](const Vec6& turned) {
      const Sweep swept = descent.sweep_to(chart, y, turned, effort);
      const Vec6 reached = swept.hit ? Vec6(y + 0.9 * swept.free_until * (turned - y)) : turned;
      if (reached.head<3>().norm() < furthest.head<3>().norm()) furthest = reached;
      return !swept.hit;
    };
    const std::optional<Vec6> rest = descent.turned_by_rows(chart, y);
    bool followed = rest && turns_to(*rest);
    for (const double lift : {0, 1, 2, 4}) {
      if (followed) break;
      Vec6 turned = Vec6::Zero();
      turned.tail<3>() = y.tail<3>() * (depth > 0 ? 1 + lift * reach / depth : 1);
      followed = turns_to(turned);
    }
    y = furthest;
    return followed;
  }
};

CoherentSolver::CoherentSolver(const Pair& pair, Method method)
    : state_(std::make_unique<State>(pair, method)) {}
CoherentSolver::~CoherentSolver() = default;
CoherentSolver::CoherentSolver(CoherentSolver&&) noexcept = default;
CoherentSolver& CoherentSolver::operator=(CoherentSolver&&) noexcept = default;

CoherentSolver::CoherentSolver(const CoherentSolver& other)
    : state_(std::make_unique<State>(*other.state_)) {
  // The descent adds its phase times to its own copy of the state.
  if (state_->timed) state_->descent.time_into(&state_->times);
}
CoherentSolver& CoherentSolver::operator=(const CoherentSolver& other) {
  if (this != &other) *this = CoherentSolver(other);
  return *this;
}

const Separation& CoherentSolver::last() const { return state_->last; }

NeighbourList& CoherentSolver::near_list() noexcept { return state_->descent.near_list(); }

void CoherentSolver::time_phases(bool on) noexcept {
  state_->timed = on;
  state_->times = {};
  state_->descent.time_into(on ? &state_->times : nullptr);
}

const Separation& CoherentSolver::reset(const Pose& X_FM, const StaticOptions& options,
                                        const Progress& progress) {
  State& s = *state_;
  StaticOptions search = options;
  search.method = s.method;
  search.want_lower_bound = false;
  s.last = separate_static(s.pair, X_FM, search, progress);
  s.last.jumped = s.last.status == Status::penetrating;
  s.started = s.last.status != Status::failed;
  s.limit_while_behind = 0;
  s.limit_of_fall = work_of_fall;
  s.falls.forget();
  s.device = s.last.device;
  s.separated = s.last.separated;
  s.depth = s.last.status == Status::failed ? 0 : s.last.depth;
  s.descent.forget();
  s.lifted = s.started ? lifted_off(s.probe, s.fixed, s.separated, s.method) : std::nullopt;
  s.free_region.forget();
  s.ids.forget();
  s.ids.follow(s.last.separated, s.probe.mass.radius, s.last.clusters);
  return s.last;
}

const Separation& CoherentSolver::tick(const Pose& X_FM, const Budget& budget) noexcept {
  State& s = *state_;
  const char* refusal = !s.started              ? "not started"
                        : !is_finite(X_FM)      ? fault_of(X_FM)
                        : !s.within_reach(X_FM) ? "the device pose is too far away to compute with"
                        : !is_valid(budget)     ? "the budget is negative or NaN"
                                                : nullptr;
  if (refusal) {
    s.last = failed(X_FM, refusal);
    s.last.separated = s.separated;
    return s.last;
  }
  const Pose device{X_FM.q.normalized(), X_FM.p};
  if (s.stays_free(device)) return s.last;
  s.times = {};
  const double moved = s.device_motion(device);
  const bool was_free = s.was_free();
  if (s.lifted && moved > 0) s.separated = *std::exchange(s.lifted, std::nullopt);
  Effort effort = s.effort_of(budget, moved);
  Chart chart(s.probe.mass, device);
  chart.absorb_free_spin(s.separated);
  const Vec6 from = chart.coordinates(s.separated);
  Vec6 y = from;
  Descent::Outcome found;
  bool followed = s.has_room_for_rounding(chart, from, effort);
  if (followed) {
    followed = s.method == Method::pdg || s.follow_turn(chart, effort, y);
    DescentGoal goal;
    if (budget.steps > 0) goal.steps = budget.steps;
    goal.held_slope = s.falls.held_slope(moved);
    goal.straight_first = was_free;
    goal.far = jump_of_device * s.probe.mass.radius;
    goal.work_of_fall = s.limit_of_fall;
    goal.held_off = held_off * moved;
    found = s.descent.run(chart, y, goal, std::max(moved, 1e-9 * s.probe.mass.radius), effort);
    const bool by_own_limit = budget.work == 0 && !(budget.microseconds > 0);
    const bool stopped = by_own_limit && effort.is_limited() && !found.converged;
    const double fall = from.norm() - found.y.norm();
    const bool fell = fall > allowed_clearance(s.probe.mass.radius, from.norm());
    if (stopped) s.learn_limit(effort.is_spent() && s.rests(moved) && !fell);
    const bool out_of_steps = budget.steps == 0 && found.iterations >= goal.steps;
    found.limited += stopped || (out_of_steps && !found.converged);
    s.descent.prepare_next_list(farthest_move(s.probe.mass, s.device, device), effort);
  } else {
    found.move_to(from);
    found.limited = 1;
  }
  const double before = s.depth;
  s.last = make_separation(chart, found);
  // A probe that could not move keeps its pose to the bit. A conversion to coordinates and back
  // would change it by rounding, the more the nearer the turn is to a half turn, and no sweep has
  // proved that change free.
  if (s.last.status == Status::penetrating && found.y == from) s.last.separated = s.separated;
  s.keep_spin(chart);
  s.last.converged = s.last.converged && followed;
  const std::optional<Falls::Release> released =
      s.falls.released({.moved = moved,
                        .way = (from - found.y).norm(),
                        .before = before,
                        .depth = s.last.depth,
                        .clearance = allowed_clearance(s.probe.mass.radius, before),
                        .let_go = s.let_go(chart, from, found.y, before),
                        .fallen = found.fallen,
                        .converged = s.last.converged});
  s.last.jumped = released.has_value();
  s.last.lagged = released && released->lagged;
  s.last.released = released ? released->energy : 0;
  // With zero inertia about an axis, the probe may not be at the device pose.
  if (s.last.status == Status::separated && s.probe.mass.inertia.minCoeff() > 0) {
    const PhaseTimer timer(s.timed ? &s.times : nullptr, Phase::look);
    s.free_region.look(device, farthest_move(s.probe.mass, s.device, device), effort);
  }
  s.last.phases = s.times;
  s.device = device;
  s.separated = s.last.separated;
  s.depth = s.last.depth;
  s.ids.follow(s.separated, s.probe.mass.radius, s.last.clusters);
  return s.last;
}

}  // namespace sonde
