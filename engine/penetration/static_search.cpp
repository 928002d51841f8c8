// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/static_search.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/penetration/lower_bound.hpp"
#include "engine/penetration/random.hpp"
#include "engine/penetration/result.hpp"
#include "engine/proximity/intersect.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

const DescentGoal coarse{.residual = 2e-2, .clearance = 20, .steps = 20};
const DescentGoal fine{.residual = 1e-4, .clearance = 1, .steps = 60};

/// Directions of the translational starts: the axes of both frames and the diagonals.
std::vector<Vec3> directions(const Chart& chart) {
  std::vector<Vec3> out;
  const Mat3 axes = chart.principal().toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0}) {
      out.push_back(sign * Vec3::Unit(i));
      out.push_back(sign * axes.col(i));
    }
  for (int i = 0; i < 8; ++i)
    out.push_back(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).normalized());
  return out;
}

class Search {
 public:
  Search(const Body& probe, const Body& fixed, const Pose& device, const StaticOptions& options)
      : probe_(probe),
        fixed_(fixed),
        chart_(probe.mass, device),
        options_(options),
        random_(options.seed),
        deadline_{options.budget.microseconds, now_us()},
        pdg_(probe, fixed, Method::pdg),
        pdt_(probe, fixed, Method::pdt) {}

  Separation run() {
    translations();
    const bool rotate = options_.method == Method::pdg;
    if (rotate)
      for (std::size_t i = 0; i < std::min<std::size_t>(3, found_.size()); ++i)
        descend(found_[i].y);
    if (rotate) sort();
    random_starts(rotate);
    return finish(rotate);
  }

 private:
  struct Found {
    Vec6 y;
    double depth;
  };

  bool out_of_budget() const {
    return deadline_.passed() ||
           (options_.budget.steps > 0 && iterations_ >= options_.budget.steps);
  }
  DescentGoal limited(DescentGoal goal) const {
    if (options_.budget.steps > 0)
      goal.steps = std::clamp(options_.budget.steps - iterations_, 1, goal.steps);
    return goal;
  }
  bool is_free(const Vec6& y) const {
    return !overlap(probe_, fixed_, Transform(chart_.pose(y)), Doubt::contact);
  }
  bool meets(const Separation& answer) const {
    return overlap(probe_, fixed_, Transform(answer.separated), Doubt::exact);
  }
  void sort() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Found& a, const Found& b) { return a.depth < b.depth; });
  }
  double best_depth() const {
    double best = std::numeric_limits<double>::infinity();
    for (const Found& f : found_) best = std::min(best, f.depth);
    return best;
  }
  void descend(const Vec6& y, bool translate = false) {
    const auto o = (translate ? pdt_ : pdg_).run(chart_, y, limited(coarse), 0, deadline_);
    iterations_ += o.iterations;
    found_.push_back({o.y, o.y.norm()});
    if (translate) translated_.push_back(found_.back());
  }

  /// From outside, along fixed directions, to contact, and on by translation alone.
  void translations() {
    const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
    const Vec3 half = fixed_.tree.high - center;
    const double away = 1.01 * ((chart_.com() - center).norm() + half.norm() + probe_.mass.radius);
    for (const Vec3& d : directions(chart_)) {
      Vec6 y = Vec6::Zero();
      y.tail<3>() = away * d;
      descend(y, true);
      if (out_of_budget()) break;
    }
    sort();
  }

  /// From random free poses in a ball of the weighted space (translations alone: of the three)
  /// somewhat larger than the best depth so far: what lies inside a tangle cannot be reached from
  /// outside.
  void random_starts(bool rotate) {
    for (int start = 0; start < options_.starts && !out_of_budget(); ++start) {
      const double widest = start % 3 == 2 ? 2.0 : 1.4;
      if (const auto y = free_sample(widest * best_depth(), rotate)) descend(*y, !rotate);
    }
    sort();
  }

  std::optional<Vec6> free_sample(double radius, bool rotate) {
    for (int tries = 0; tries < 60 && !deadline_.passed(); ++tries) {
      const double grown = radius * (1 + tries * 0.02);
      Vec6 y = random_.in_ball(grown);
      if (!rotate) y.head<3>().setZero();
      for (int i = 0; i < 3; ++i)
        if (!(probe_.mass.inertia[i] > 0)) y[i] = 0;
      if (chart_.v(y).norm() < 0.9 && is_free(y)) return y;
    }
    return std::nullopt;
  }

  /// The best few to the last digit; the best of them that stands the exact test.
  Separation finish(bool rotate) {
    std::vector<Separation> answers;
    std::optional<Separation> translated = polish_translation();
    if (translated && meets(*translated)) translated.reset();
    if (translated && rotate)
      answers.push_back(
          polish(pdg_, {chart_.coordinates(translated->separated), translated->depth}));
    if (translated) answers.push_back(*translated);
    const double worth = 1.1 * best_depth();
    for (std::size_t i = 0; i < std::min<std::size_t>(4, found_.size()); ++i) {
      if (found_[i].depth > worth || (deadline_.passed() && !answers.empty())) break;
      answers.push_back(polish(rotate ? pdg_ : pdt_, found_[i]));
    }
    std::stable_sort(answers.begin(), answers.end(),
                     [](const Separation& a, const Separation& b) { return a.depth < b.depth; });
    for (Separation& answer : answers) {
      if (meets(answer)) continue;
      answer.iterations = iterations_;
      if (translated) answer.pdt = translated->depth;
      return answer;
    }
    return failed(chart_.device(), "no separated pose stood the exact test");
  }

  Separation polish(Descent& descent, const Found& from) {
    // At least a few steps even past the budget: a pose fit to be returned, with its multipliers.
    const auto o = descent.run(chart_, from.y, limited(fine), 0.1 * from.depth, deadline_);
    iterations_ += o.iterations;
    return make_separation(chart_, o);
  }

  /// The translational depth to the last digit; among the starts from here on.
  std::optional<Separation> polish_translation() {
    const Found* best = nullptr;
    for (const Found& f : translated_)
      if (!best || f.depth < best->depth) best = &f;
    if (!best) return std::nullopt;
    return polish(pdt_, *best);
  }

  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  Random random_;
  Deadline deadline_;
  Descent pdg_, pdt_;
  std::vector<Found> found_;
  std::vector<Found> translated_;
  int iterations_ = 0;
};

}  // namespace

Separation separate_static(const Body& probe, const Body& fixed, const Pose& X_FM,
                           const StaticOptions& options) {
  if (!is_finite(X_FM)) return failed(X_FM, "the pose is not finite");
  const Pose device{X_FM.q.normalized(), X_FM.p};
  Separation out;
  if (!overlap(probe, fixed, Transform(device), Doubt::exact))
    out = separated_at(device);
  else
    out = Search(probe, fixed, device, options).run();
  if (options.want_lower_bound && out.status == Status::penetrating)
    out.lower_bound = depth_lower_bound(probe, fixed, device);
  return out;
}

}  // namespace sonde
