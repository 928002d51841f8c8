// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/sketch_descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/ordering.hpp"
#include "engine/base/phase_timer.hpp"
#include "engine/penetration/descent/leap_tuning.hpp"
#include "engine/penetration/descent/sketch_descent_tuning.hpp"

namespace sonde {
/// The pose of the probe's principal frame in that of the fixed body, and its inverse.
struct SketchDescent::Frame {
  Quad R[3], p, R_t[3], p_t;
  Mat3 R_BA;
  Frame(const Chart& chart, const Vec6& y, const Mat3& R_FB, const Vec3& com_B) {
    const Vec3 u = chart.v(y);
    const Quat turn(std::sqrt(std::max(0.0, 1 - u.squaredNorm())), u.x(), u.y(), u.z());
    R_BA = R_FB.transpose() * (chart.principal() * turn).toRotationMatrix();
    const Vec3 p_BA = R_FB.transpose() * (chart.com() + y.tail<3>() - com_B);
    for (int i = 0; i < 3; ++i) R[i] = quad(R_BA.col(i)), R_t[i] = quad(R_BA.row(i).transpose());
    p = quad(p_BA);
    p_t = quad(-(R_BA.transpose() * p_BA));
  }
  Quad to_fixed(const Quad& x) const { return x[0] * R[0] + x[1] * R[1] + x[2] * R[2] + p; }
  Quad to_probe(const Quad& x) const { return x[0] * R_t[0] + x[1] * R_t[1] + x[2] * R_t[2] + p_t; }
};

SketchDescent::SketchDescent(const Sketch& probe, const Sketch& fixed,
                             const MassProperties& fixed_mass)
    : probe_(probe),
      fixed_(fixed),
      R_FB_(fixed_mass.R_MP),
      com_B_(fixed_mass.com),
      spacing_(std::max(probe.field.spacing(), fixed.field.spacing())),
      of_probe_(probe.more.size()),
      of_fixed_(fixed.more.size()) {}

bool SketchDescent::is_free(const Chart& chart, const Vec6& y, double deepest) {
  const PhaseTimer timer(times_, Phase::sketch);
  const Frame frame(chart, y, R_FB_, com_B_);
  const auto least = -static_cast<float>(deepest);
  const auto all_out = [least](const PointGroup& group, const DistanceField& field,
                               const auto& place) {
    const Quad center = place(group.center);
    if (static_cast<double>(field.at_least(center)) > group.radius) return true;
    if (static_cast<double>(field.at(center)[3]) > group.radius) return true;
    return std::ranges::all_of(group.points, [&](const Quad& x) {
      const Quad placed = place(x);
      return field.at_least(placed) >= least || field.at(placed)[3] >= least;
    });
  };
  const auto probe_is_out = [&](const PointGroup& group) {
    return all_out(group, fixed_.field, [&](const Quad& x) { return frame.to_fixed(x); });
  };
  const auto fixed_is_out = [&](const PointGroup& group) {
    return all_out(group, probe_.field, [&](const Quad& x) { return frame.to_probe(x); });
  };
  if (!probe_is_out(probe_.few[deep_of_probe_]) || !fixed_is_out(fixed_.few[deep_of_fixed_]))
    return false;
  for (std::size_t i = 0; i < probe_.few.size(); ++i)
    if (!probe_is_out(probe_.few[i])) return deep_of_probe_ = i, false;
  for (std::size_t i = 0; i < fixed_.few.size(); ++i)
    if (!fixed_is_out(fixed_.few[i])) return deep_of_fixed_ = i, false;
  return true;
}

double SketchDescent::depth_of_points(const Chart& chart, const Vec6& y) {
  const PhaseTimer timer(times_, Phase::sketch);
  for (auto* groups : {&of_probe_, &of_fixed_})
    for (Known& k : *groups) k = {-std::numeric_limits<double>::infinity(), 0};
  travelled_ = 0;
  return std::max(0.0, -find_near(Frame(chart, y, R_FB_, com_B_), 0, false));
}

/// The least gap of a group, m, if it is within `reach`, otherwise some value beyond `reach`. Calls
/// add(point, placed point, field there) for all points within. The field has Lipschitz constant 1
/// to a third of a cell, so points that are too far from the centre for `reach` are skipped.
template <class Place, class Add>
double SketchDescent::find_near_in(const PointGroup& group, const DistanceField& field,
                                   Known& known, double reach, const Place& place, const Add& add) {
  if (known.gap - (travelled_ - known.seen) > reach) return reach;
  const Quad center = place(group.center);
  known = {static_cast<double>(field.at_least(center)) - group.radius, travelled_};
  if (known.gap > reach) return reach;
  const float from_center = field.at(center)[3];
  known.gap = static_cast<double>(from_center) - group.radius;
  if (known.gap > reach) return reach;
  auto least = std::numeric_limits<float>::infinity();
  const auto within = static_cast<float>(reach);
  const auto look_at = [&](const Quad& x) {
    if (const float at_least = from_center - x[3]; at_least > within) return at_least;
    const Quad placed = place(x);
    if (const float at_least = field.at_least(placed); at_least > within) return at_least;
    const Quad there = field.at(placed);
    if (there[3] < within) add(x, placed, there);
    return there[3];
  };
  for (const Quad& x : group.points) least = std::min(least, look_at(x));
  known.gap = static_cast<double>(least);
  return known.gap;
}

double SketchDescent::find_near(const Frame& frame, double reach, bool rough) {
  const std::vector<PointGroup>& of_probe = rough ? probe_.few : probe_.more;
  const std::vector<PointGroup>& of_fixed = rough ? fixed_.few : fixed_.more;
  near_.clear();
  double least = reach;
  for (std::size_t i = 0; i < of_probe.size(); ++i) {
    const double gap = find_near_in(
        of_probe[i], fixed_.field, of_probe_[i], reach,
        [&](const Quad& x) { return frame.to_fixed(x); },
        [&](const Quad& x, const Quad&, const Quad& d) {
          near_.push_back({x, d, d[3], true});
        });
    least = std::min(least, gap);
  }
  for (std::size_t i = 0; i < of_fixed.size(); ++i) {
    const double gap = find_near_in(
        of_fixed[i], probe_.field, of_fixed_[i], reach,
        [&](const Quad& x) { return frame.to_probe(x); },
        [&](const Quad&, const Quad& x, const Quad& d) {
          near_.push_back({x, d, d[3], false});
        });
    least = std::min(least, gap);
  }
  if (near_.size() > sketch_descent_tuning.most_rows) {
    ordering::nth_element(near_.begin(),
                          near_.begin() + std::ptrdiff_t{sketch_descent_tuning.most_rows},
                          near_.end(), [](const Near& a, const Near& b) { return a.gap < b.gap; });
    near_.resize(sketch_descent_tuning.most_rows);
  }
  return least;
}

void SketchDescent::make_rows(const Chart& chart, const Vec6& y, const Frame& at, Method method) {
  const Vec3 u = chart.v(y);
  const double w = std::sqrt(std::max(1e-12, 1 - u.squaredNorm()));
  Mat3 to_v = Mat3::Zero();  // from the moment of a normal to its row
  to_v << 0, -u[2], u[1], u[2], 0, -u[0], -u[1], u[0], 0;
  to_v = 2 * (to_v + w * Mat3::Identity() + u * u.transpose() / w);
  for (int k = 0; k < 3; ++k) {
    const double root = 2 * std::sqrt(chart.mass().inertia[k]);
    to_v.row(k) *= root > 0 && method == Method::pdg ? 1 / root : 0;
  }
  const Mat3 R_FA = R_FB_ * at.R_BA;
  rows_.resize(near_.size());
  at_.resize(near_.size());
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const Near& c = near_[i];
    const Vec3 out = vec3(c.out).normalized();
    const Vec3 normal = c.of_probe ? Vec3(at.R_BA.transpose() * out) : Vec3(-out);
    rows_[i].normal.head<3>() = to_v * vec3(c.on_probe).cross(normal);
    rows_[i].normal.tail<3>() = R_FA * normal;
    at_[i] = rows_[i].normal.dot(y);
  }
}

LeastDistance SketchDescent::solve(double margin, bool open) {
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const double room = static_cast<double>(near_[i].gap) - margin;
    rows_[i].bound = at_[i] - (open ? room : std::max(0.0, room));
  }
  return least_distance(rows_, sketch_descent_tuning.solved_to * spacing_);
}

SketchDescent::End SketchDescent::run(const Chart& chart, const Vec6& start, const Goal& goal) {
  const PhaseTimer timer(times_, Phase::sketch);
  const double margin = goal.margin, shortest = goal.rough ? sketch_descent_tuning.rough_tolerance
                                                           : sketch_descent_tuning.tolerance;
  for (auto* groups : {&of_probe_, &of_fixed_})
    for (Known& k : *groups) k = {-std::numeric_limits<double>::infinity(), 0};
  travelled_ = 0;
  const double radius = chart.mass().radius;
  End out{start, 0, 0, false};
  Vec6 from = start;
  double trust = sketch_descent_tuning.first_trust * std::max(start.norm(), spacing_), moved = 0;
  for (;;) {
    const double reach = sketch_descent_tuning.reach * trust + margin;
    const Frame frame(chart, out.y, R_FB_, com_B_);
    out.gap = find_near(frame, reach, goal.rough);
    const double too_deep = margin - out.gap;
    const double least = sketch_descent_tuning.too_deep_at_least * spacing_;
    if (moved > least && too_deep > std::max(sketch_descent_tuning.too_deep * moved, least) &&
        out.steps < goal.steps) {
      // The step went too far beyond the range of the linearisation.
      out.y = from + sketch_descent_tuning.taken_back_to * (out.y - from);
      moved *= sketch_descent_tuning.taken_back_to;
      trust = sketch_descent_tuning.trust_after_too_deep * moved;
      travelled_ += 2 * moved;
      ++out.steps;
      continue;
    }
    make_rows(chart, out.y, frame, goal.method);
    LeastDistance nearest = solve(margin, true);
    if (!nearest.feasible) nearest = solve(margin, false);
    Vec6 step = nearest.y - out.y;
    double length = step.norm();
    if (length < std::max(shortest * out.y.norm(), sketch_descent_tuning.shortest * spacing_)) {
      out.arrived = out.gap > margin - sketch_descent_tuning.arrived_within * spacing_;
      return out;
    }
    if (out.steps >= goal.steps) return out;
    if (out.steps >= sketch_descent_tuning.steps_before_hopeless &&
        out.y.norm() > leap_tuning.hopeless * goal.beat && nearest.y.norm() > goal.beat)
      return out;
    const double turn = chart.v(step).norm();
    step *=
        std::min({1.0, sketch_descent_tuning.largest_turn / std::max(turn, 1e-30), trust / length});
    const double limit = std::max(Chart::largest_v, chart.v(out.y).norm());
    while (chart.v(out.y + step).norm() > limit) step *= 0.5;
    from = out.y;
    out.y += step;
    moved = step.norm();
    trust = std::max(sketch_descent_tuning.trust_growth * moved,
                     sketch_descent_tuning.trust_decay * trust);
    travelled_ += step.tail<3>().norm() +
                  sketch_descent_tuning.travel_per_turn * radius * chart.v(step).norm();
    ++out.steps;
  }
}

}  // namespace sonde
