// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/pair_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// Units of Effort to compare two triangles at one moment.
constexpr int work_to_look_at_triangles = 50;

/// Share of the clearance: a pair that approaches it and has less than so much more has stopped.
double arrived(PairsKeep keep) { return keep == PairsKeep::all ? 1e-4 : 0.05; }

}  // namespace

double safe_advance(double slack, double speed, double acceleration) {
  if (slack <= 0) return 0;
  if (acceleration <= 0) return speed >= 0 ? infinity : slack / -speed;
  // The positive root of slack + speed x − ½ acceleration x², in the form without cancellation.
  const double root = std::sqrt(speed * speed + 2 * acceleration * slack);
  return speed >= 0 ? (speed + root) / acceleration : 2 * slack / (root - speed);
}

bool stays_above(double from, double to, double sag) {
  if (!(from >= 0 && to >= 0)) return false;
  return std::min(from, to) >= sag || 0.5 * (from + to) + std::sqrt(from * to) >= 2 * sag;
}

PairSweep::PairSweep(const Body& a, const Body& b, const Motion& motion, double clearance,
                     PairsKeep keep)
    : a_(a),
      b_(b),
      motion_(motion),
      clearance_(clearance),
      keep_(keep),
      start_(motion, 0),
      kept_(start_),
      end_(motion.at(1)) {
  const Vec3 farthest = start_.X.p.cwiseAbs().cwiseMax(end_.p.cwiseAbs());
  // Poses are computed about the centre of mass, which may lie far outside the mesh.
  guard_ = rounding_guard(extent(a) + motion.com().norm(), extent(b), farthest);
  result_.free_until = 1;
}

const Moment& PairSweep::at(double s) {
  if (s <= 0) return start_;
  if (s != kept_s_) kept_ = Moment(motion_, s), kept_s_ = s;
  return kept_;
}

PairSweep::Step PairSweep::step_along(const Vec3& n, const Moment& now, const Corners& local,
                                      const Corners& ta, const Corners& tb, double radius,
                                      double floor) const {
  const Vec3 com = now.X * motion_.com();
  const double top = std::max({n.dot(tb[0]), n.dot(tb[1]), n.dot(tb[2])});
  const double sliding = n.dot(now.velocity.linear);
  const Vec3 turning = n.cross(now.velocity.angular);  // n·(ω×r) = (n×ω)·r
  const Vec3 bending = motion_.bend().transpose() * n;
  const double most = motion_.acceleration_per_radius() * radius;
  const double unknown = motion_.bend_error() * radius;
  Step step{infinity, infinity, false};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& x = ta[k];
    const double height = n.dot(x) - top, speed = sliding + turning.dot(x - com);
    step.gap = std::min(step.gap, height);
    const double acceleration =
        std::clamp(unknown - bending.dot(local[k] - motion_.com()), 0.0, most);
    // Most corners are free on the whole path: this test avoids the root.
    if (height - floor + std::min(0.0, speed) > 0.5 * acceleration) continue;
    const double mine = safe_advance(height - floor, speed, acceleration);
    if (mine < step.length) step.length = mine, step.closing = speed < 0;
  }
  return step;
}

double PairSweep::radius(const Corners& local) const {
  double radius2 = 0;
  for (const Vec3& x : local) radius2 = std::max(radius2, (x - motion_.com()).squaredNorm());
  return std::sqrt(radius2);
}

PairSweep::Step PairSweep::step_along(std::uint32_t i, std::uint32_t j, const Vec3& normal,
                                      const Moment& now) const {
  const Corners local = corners(surface(a_), i);
  return step_along(normal, now, local, place(now.X, local), corners(surface(b_), j), radius(local),
                    clearance_ + guard_);
}

bool PairSweep::is_clear_along(std::uint32_t i, std::uint32_t j, const Vec3& n) {
  const double until = free_until();
  const Transform& end = until < 1 ? at(until).X : end_;
  const Corners local = corners(surface(a_), i), tb = corners(surface(b_), j);
  const double from = gap_along(n, place(start_.X, local), tb);
  const double to = gap_along(n, place(end, local), tb), floor = floor_of(from);
  if (!(from >= floor && to >= floor)) return false;
  const Vec3 bending = motion_.bend().transpose() * n;
  double bend = -infinity;
  for (const Vec3& x : local) bend = std::max(bend, bending.dot(x - motion_.com()));
  return stays_above(from - floor, to - floor, until * until * hangs_by(bend));
}

bool PairSweep::is_clear_between(std::uint32_t i, std::uint32_t j, double s, const Moment& now,
                                 const Vec3& from, const Vec3& to) {
  const Corners local = corners(surface(a_), i), tb = corners(surface(b_), j);
  const double gap = gap_along(from, place(now.X, local), tb);
  const double floor = s > 0 ? clearance_ + guard_ : floor_of(gap);
  return gap > 0 && slides({s, now, from}, {1, at(1), to}, local, tb, radius(local), floor);
}

bool PairSweep::slides(const Slide& from, const Slide& to, const Corners& local, const Corners& tb,
                       double radius, double floor) const {
  // Along m(s) = n₀ + s (n₁ − n₀), |m| ≤ 1, a corner x of A has the height h = m·(x − b) above a
  // corner b of B, and h″ = m·x″ + 2 (n₁ − n₀)·x′. Between its ends, h lies below the chord by at
  // most an eighth of that.
  const double part = to.s - from.s;
  const Vec3 turned = to.normal - from.normal;
  const Vec3 bend_from = motion_.bend().transpose() * from.normal;
  const Vec3 bend_to = motion_.bend().transpose() * to.normal;
  const double unknown = motion_.bend_error() * radius;
  const double bends = motion_.acceleration_per_radius() * radius;
  const Moment& now = from.moment;
  const Vec3 com = now.X * motion_.com();
  for (const Vec3& x : local) {
    const Vec3 arm = x - motion_.com(), x0 = now.X * x, x1 = to.moment.X * x;
    const double curve = std::min(bends, std::max(bend_from.dot(arm), bend_to.dot(arm)) + unknown);
    const double speed = turned.dot(now.velocity.linear + now.velocity.angular.cross(x0 - com)) +
                         part * turned.norm() * bends;
    const double hangs = 0.125 * (part * part * curve + 2 * part * speed);
    for (const Vec3& b : tb) {
      const double low0 = from.normal.dot(x0 - b) - floor, low1 = to.normal.dot(x1 - b) - floor;
      if (!stays_above(low0, low1, hangs)) return false;
    }
  }
  return true;
}

int PairSweep::advance(std::uint32_t i, std::uint32_t j, double s, Vec3& normal) {
  const Corners local = corners(surface(a_), i);
  const Corners tb = corners(surface(b_), j);
  const double radius = this->radius(local);
  double stop = clearance_;
  if (normal.squaredNorm() > 0) {
    const Moment& now = at(s);
    const Step step =
        step_along(normal, now, local, place(now.X, local), tb, radius, stop + guard_);
    if (step.gap > 2 * stop) s += step.length;
  }
  int looks = 0;
  const auto look = [&](const Moment& now) {
    ++looks;
    return closest_points(place(now.X, local), tb);
  };
  double leap = 1;
  for (int tries = 0; s < result_.free_until; ++tries) {
    const Moment now = at(s);
    const ClosestPoints c = look(now);
    normal = c.normal;
    // A pair nearer than the clearance at the start may slide or move away with half of its gap.
    if (keep_ == PairsKeep::half_of_start && s <= 0 && c.gap < 2 * stop) stop = 0.5 * c.gap;
    const double slack = c.gap - stop - guard_;
    const Step step =
        step_along(normal, now, local, place(now.X, local), tb, radius, stop + guard_);
    // Stopped, or approaching the stop in ever smaller steps: the free part of the path ends here.
    if (slack <= 0 || tries == 50 || (step.closing && slack < arrived(keep_) * stop)) {
      result_ = {.free_until = s, .hit = true, .triangle_a = i, .triangle_b = j};
      break;
    }
    // Where an edge slides over an edge, the separating direction turns with them; a fixed
    // direction separates them only on a short part of the path.
    const double end = std::min(s + leap, result_.free_until);
    if (end > s + 2 * step.length) {
      const Moment then = at(end);
      const ClosestPoints d = look(then);
      if (d.gap > stop + guard_ &&
          slides({s, now, c.normal}, {end, then, d.normal}, local, tb, radius, stop + guard_)) {
        s = end;
        leap *= 2;
        continue;
      }
      leap = 0.25 * (end - s);
    }
    s += step.length;
  }
  return work_to_look_at_triangles * looks;
}

}  // namespace sonde
