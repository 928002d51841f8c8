// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/pair_sweep.hpp"

#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

/// At two triangles, at one moment; in the units of Effort.
constexpr int work_to_look = 50;

}  // namespace

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
  // The poses are made about the centre of mass, which may lie far outside the mesh.
  guard_ = rounding_guard(extent(a) + motion.com().norm(), extent(b), farthest);
  result_.free_until = 1;
}

const Moment& PairSweep::at(double s) {
  if (s <= 0) return start_;
  if (s != kept_s_) kept_ = Moment(motion_, s), kept_s_ = s;
  return kept_;
}

PairSweep::Step PairSweep::step_along(const Vec3& n, const Moment& now, const Corners& ta,
                                      const Corners& tb, double acceleration, double floor) const {
  const Vec3 com = now.X * motion_.com();
  const double top = std::max({n.dot(tb[0]), n.dot(tb[1]), n.dot(tb[2])});
  const double sliding = n.dot(now.velocity.linear);
  const Vec3 turning = n.cross(now.velocity.angular);  // n·(ω×r) = (n×ω)·r
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Step step{infinity, infinity, false};
  for (const Vec3& x : ta) {
    const double height = n.dot(x) - top, speed = sliding + turning.dot(x - com);
    step.gap = std::min(step.gap, height);
    // All of the path, which is what most corners are free for: no root need be taken.
    if (height - floor + std::min(0.0, speed) > 0.5 * acceleration) continue;
    const double mine = safe_advance(height - floor, speed, acceleration);
    if (mine < step.length) step.length = mine, step.closing = speed < 0;
  }
  return step;
}

double PairSweep::acceleration(const Corners& local) const {
  double radius2 = 0;
  for (const Vec3& x : local) radius2 = std::max(radius2, (x - motion_.com()).squaredNorm());
  return motion_.acceleration_per_radius() * std::sqrt(radius2);
}

PairSweep::Step PairSweep::step_along(std::uint32_t i, std::uint32_t j, const Vec3& normal,
                                      const Moment& now) const {
  const Corners local = corners(surface(a_), i);
  return step_along(normal, now, place(now.X, local), corners(surface(b_), j), acceleration(local),
                    clearance_ + guard_);
}

int PairSweep::advance(std::uint32_t i, std::uint32_t j, double s, Vec3& normal) {
  const Corners local = corners(surface(a_), i);
  const Corners tb = corners(surface(b_), j);
  const double acceleration = this->acceleration(local);
  double stop = clearance_;
  if (normal.squaredNorm() > 0) {
    const Moment& now = at(s);
    const Step step = step_along(normal, now, place(now.X, local), tb, acceleration, stop + guard_);
    if (step.gap > 2 * stop) s += step.length;
  }
  int tries = 0;
  for (; s < result_.free_until; ++tries) {
    const Moment& now = at(s);
    const Corners ta = place(now.X, local);
    const ClosestPoints c = closest_points(ta, tb);
    normal = c.normal;
    // Nearer than asked from the start: let it slide, or move away, on half of what it has.
    if (s <= 0 && c.gap < 2 * stop) stop = 0.5 * c.gap;
    const double slack = c.gap - stop - guard_;
    const Step step = step_along(normal, now, ta, tb, acceleration, stop + guard_);
    // Stopped, or closing in on the stop in ever smaller steps: here is where the freedom ends.
    if (slack <= 0 || tries == 50 || (step.closing && slack < 0.05 * stop)) {
      result_ = {.free_until = s, .hit = true, .triangle_a = i, .triangle_b = j};
      return work_to_look * (tries + 1);
    }
    s += step.length;
  }
  return work_to_look * tries;
}

}  // namespace sonde
