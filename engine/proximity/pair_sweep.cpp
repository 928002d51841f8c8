// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/pair_sweep.hpp"

#include "engine/proximity/placement.hpp"

namespace sonde {

double safe_advance(double slack, double speed, double acceleration) {
  if (slack <= 0) return 0;
  if (acceleration <= 0)
    return speed >= 0 ? std::numeric_limits<double>::infinity() : slack / -speed;
  // The positive root of slack + speed x − ½ acceleration x², in the form that does not cancel.
  const double root = std::sqrt(speed * speed + 2 * acceleration * slack);
  return speed >= 0 ? (speed + root) / acceleration : 2 * slack / (root - speed);
}

PairSweep::PairSweep(const Body& a, const Body& b, const Motion& motion, double clearance)
    : a_(a), b_(b), motion_(motion), clearance_(clearance), start_(motion, 0), kept_(start_) {
  const Vec3 farthest = start_.X.p.cwiseAbs().cwiseMax(motion.at(1).p.cwiseAbs());
  guard_ = rounding_guard(extent(a), extent(b), farthest);
  result_.free_until = 1;
}

const Moment& PairSweep::at(double s) {
  if (s <= 0) return start_;
  if (s != kept_s_) kept_ = Moment(motion_, s), kept_s_ = s;
  return kept_;
}

void PairSweep::advance(std::uint32_t i, std::uint32_t j, double s, Vec3& normal) {
  const Corners local = corners(a_.soup, i);
  const Corners tb = corners(b_.soup, j);
  double radius2 = 0;
  for (const Vec3& x : local) radius2 = std::max(radius2, (x - motion_.com()).squaredNorm());
  const double acceleration = motion_.acceleration_per_radius() * std::sqrt(radius2);
  double stop = clearance_;
  // Along n the triangle is as far as its corners are: each is given the time that its own height
  // over B and its own speed allow.
  bool closing = false;
  const auto step_along = [&](const Vec3& n, const Moment& now, const Corners& ta, double floor) {
    const Vec3 com = now.X * motion_.com();
    const double top = std::max({n.dot(tb[0]), n.dot(tb[1]), n.dot(tb[2])});
    const double sliding = n.dot(now.velocity.linear);
    const Vec3 turning = n.cross(now.velocity.angular);  // n·(ω×r) = (n×ω)·r
    double step = std::numeric_limits<double>::infinity();
    for (const Vec3& x : ta) {
      const double speed = sliding + turning.dot(x - com);
      const double mine = safe_advance(n.dot(x) - top - floor, speed, acceleration);
      if (mine < step) step = mine, closing = speed < 0;
    }
    return step;
  };
  if (normal.squaredNorm() > 0) {
    const Moment& now = at(s);
    const Corners ta = place(now.X, local);
    const double gap = gap_along(normal, ta, tb);
    if (gap > 2 * stop) s += step_along(normal, now, ta, stop + guard_);
  }
  for (int tries = 0; s < result_.free_until; ++tries) {
    const Moment& now = at(s);
    const Corners ta = place(now.X, local);
    const ClosestPoints c = closest_points(ta, tb);
    normal = c.normal;
    const double gap = c.gap;
    // Nearer than asked from the start: let it slide, or move away, on half of what it has.
    if (s <= 0 && gap < 2 * stop) stop = 0.5 * gap;
    const double slack = gap - stop - guard_;
    const double step = step_along(normal, now, ta, stop + guard_);
    // Stopped, or closing in on the stop in ever smaller steps: here is where the freedom ends.
    if (slack <= 0 || tries == 50 || (closing && slack < 0.05 * stop)) {
      result_ = {s, true, i, j};
      return;
    }
    s += step;
  }
}

}  // namespace sonde
