// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/static_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <vector>

#include "engine/penetration/leap_descent.hpp"
#include "engine/penetration/lower_bound.hpp"
#include "engine/penetration/random.hpp"
#include "engine/penetration/result.hpp"
#include "engine/proximity/intersect.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

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

/// Starts that are descended side by side; what they find counts from the next round on, so that it
/// does not matter how many threads there are.
constexpr std::size_t per_round = 8;
/// So many starts that ended at the best depth, to within the tolerance, are enough.
constexpr int enough_agreement = 5;

class Search {
 public:
  Search(const Body& probe, const Body& fixed, const Pose& device, const StaticOptions& options)
      : probe_(probe),
        fixed_(fixed),
        chart_(probe.mass, device),
        options_(options),
        deadline_{options.budget.microseconds, now_us()},
        leaps_{{{probe, fixed, options.method}, {probe, fixed, options.method}}},
        translating_{{{probe, fixed, Method::pdt}, {probe, fixed, Method::pdt}}},
        descent_(probe, fixed, options.method) {}

  Separation run() {
    translations();
    near_samples();
    for (int start = 0; start < options_.starts && !done(); start += int{per_round})
      random_starts(start);
    return finish();
  }

 private:
  struct Found {
    Vec6 y = Vec6::Zero();
    double depth = std::numeric_limits<double>::infinity();
    int iterations = 0;
  };
  using Round = std::array<Found, per_round>;
  bool rotates() const { return options_.method == Method::pdg; }

  bool out_of_budget() const {
    return deadline_.passed() ||
           (options_.budget.steps > 0 && iterations_ >= options_.budget.steps);
  }
  bool done() const { return out_of_budget() || agreeing_ >= enough_agreement; }
  int steps_left() const {
    return options_.budget.steps > 0 ? std::max(0, options_.budget.steps - iterations_)
                                     : std::numeric_limits<int>::max();
  }
  /// Of the starts of a round, so many are made, each with an equal share of the steps left.
  std::size_t starts_worth_while() const {
    return std::min(per_round, static_cast<std::size_t>(std::max(1, steps_left() / 4)));
  }

  /// Runs start(k, thread) for each of a round, and takes down what they found.
  template <class Start>
  void round(const Start& start) {
    if (out_of_budget() && !found_.empty()) return;
    Round found;
    const std::size_t count = starts_worth_while();
    share_ = std::max(1, steps_left() / static_cast<int>(count));
    const auto every_other = [&](std::size_t first, std::size_t stride, std::size_t thread) {
      for (std::size_t k = first; k < count; k += stride) found[k] = start(k, thread);
    };
    if (options_.two_threads) {
      auto other = std::async(std::launch::async, [&] { every_other(1, 2, 1); });
      every_other(0, 2, 0);
      other.get();
    } else {
      every_other(0, 1, 0);
    }
    for (const Found& f : found) note(f);
  }

  void note(const Found& f) {
    iterations_ += f.iterations;
    if (!std::isfinite(f.depth)) return;
    if (f.depth < 0.98 * best_) agreeing_ = 0;
    agreeing_ += f.depth < 1.02 * std::min(best_, f.depth);
    best_ = std::min(best_, f.depth);
    found_.push_back(f);
  }

  /// Down by leaps, roughly and where that is promising by the true contacts.
  Found descend(LeapDescent& leaps, const Vec6& y, double beat) const {
    const auto rough = leaps.run(
        chart_, y, {.steps = std::min(15, share_), .reach = 0.3, .beat = 1.1 * beat}, deadline_);
    Found out{rough.y, rough.y.norm(), rough.iterations};
    const int left = share_ - out.iterations;
    if (left <= 0 || (beat > 0 && out.depth > 1.3 * beat)) return out;
    const auto exact = leaps.run(chart_, rough.y,
                                 {.tolerance = 0.01,
                                  .steps = std::min(12, left),
                                  .reach = 0.1,
                                  .beat = 1.02 * beat,
                                  .roughly = false},
                                 deadline_);
    return {exact.y, exact.y.norm(), out.iterations + exact.iterations};
  }

  /// From outside, along fixed directions, to contact; the best of them on by translation alone,
  /// and from there by all six.
  void translations() {
    const Vec3 center = (fixed_.tree.low + fixed_.tree.high) / 2;
    const Vec3 half = fixed_.tree.high - center;
    const double away = 1.01 * ((chart_.com() - center).norm() + half.norm() + probe_.mass.radius);
    std::vector<Found> outside;
    for (const Vec3& d : directions(chart_)) {
      Vec6 y = Vec6::Zero();
      y.tail<3>() = away * d;
      y = translating_[0].pull_in(chart_, y);
      outside.push_back({y, y.norm(), 0});
      if (deadline_.passed()) break;
    }
    std::stable_sort(outside.begin(), outside.end(), nearer);
    outside.resize(std::min(outside.size(), per_round));
    for (const Found& f : outside) translated_.push_back(f);
    round([&](std::size_t k, std::size_t thread) {
      return k < outside.size() ? descend(translating_[thread], outside[k].y, outside[0].depth)
                                : Found{};
    });
    translated_ = found_;
    std::stable_sort(translated_.begin(), translated_.end(), nearer);
    if (!rotates()) return;
    agreeing_ = 0;
    round([&](std::size_t k, std::size_t thread) {
      return k < std::min<std::size_t>(2, translated_.size())
                 ? descend(leaps_[thread], translated_[k].y, best_)
                 : Found{};
    });
  }

  /// Random poses of the ball of some radius: a free one, if there is one among so many.
  std::optional<Vec6> free_sample(const LeapDescent& leaps, Random& random, double radius,
                                  int tries) const {
    for (int i = 0; i < tries && !deadline_.passed(); ++i) {
      Vec6 y = random.in_ball(radius);
      if (!rotates()) y.head<3>().setZero();
      for (int k = 0; k < 3; ++k)
        if (!(probe_.mass.inertia[k] > 0)) y[k] = 0;
      if (chart_.v(y).norm() < 0.9 && leaps.is_free(chart_, y)) return y;
    }
    return std::nullopt;
  }
  Random stream(std::uint64_t number) const {
    Random mixed(options_.seed + 0x51ed270b0f5a1d27ULL * number);
    return Random(mixed.next());
  }

  /// Free poses far nearer than the best, where there are any: what lies inside a tangle is not
  /// reached from outside.
  void near_samples() {
    if (out_of_budget()) return;
    const double best = best_;
    round([&](std::size_t k, std::size_t thread) {
      Random random = stream(1000 + k);
      const double radius = best * std::exp2(-0.5 * static_cast<double>(per_round - k));
      const auto y = free_sample(leaps_[thread], random, radius, 150);
      return y ? descend(leaps_[thread], *y, std::min(best, y->norm())) : Found{};
    });
  }

  /// From random free poses of balls somewhat larger than the best depth so far.
  void random_starts(int first) {
    const double best = best_;
    round([&](std::size_t k, std::size_t thread) {
      Random random = stream(static_cast<std::uint64_t>(first) + k);
      const double widest = k % 3 == 2 ? 2.0 : k % 3 == 1 ? 1.4 : 1.15;
      std::optional<Vec6> y;
      for (double grown = 1; !y && grown < 3 && !deadline_.passed(); grown *= 1.2)
        y = free_sample(leaps_[thread], random, grown * widest * best, 50);
      return y ? descend(leaps_[thread], *y, best) : Found{};
    });
  }

  /// The best few to the last digit; the best of them that stands the exact test.
  Separation finish() {
    std::vector<Separation> answers;
    if (rotates()) {
      std::optional<Separation> translated = polish_translation();
      if (translated) answers.push_back(*translated);
    }
    std::stable_sort(found_.begin(), found_.end(), nearer);
    std::vector<Vec6> taken;
    for (const Found& f : found_) {
      if (f.depth > 1.1 * best_ || taken.size() >= 4) break;
      if (out_of_budget() && !answers.empty()) break;
      const bool known = std::ranges::any_of(
          taken, [&](const Vec6& y) { return (y - f.y).norm() < 0.02 * f.depth; });
      if (known) continue;
      taken.push_back(f.y);
      answers.push_back(polish(leaps_[0], descent_, f));
    }
    const std::optional<double> pdt =
        rotates() && !answers.empty() ? std::optional(answers.front().depth) : std::nullopt;
    std::stable_sort(answers.begin(), answers.end(),
                     [](const Separation& a, const Separation& b) { return a.depth < b.depth; });
    for (Separation& answer : answers) {
      if (overlap(probe_, fixed_, Transform(answer.separated), Doubt::exact)) continue;
      answer.iterations = iterations_;
      answer.pdt = rotates() ? pdt : answer.depth;
      return answer;
    }
    return failed(chart_.device(), "no separated pose stood the exact test");
  }

  Separation polish(LeapDescent& leaps, Descent& descent, const Found& from) {
    const auto near = leaps.run(
        chart_, from.y,
        {.tolerance = 1e-3, .steps = std::min(20, steps_left()), .reach = 0.05, .roughly = false},
        deadline_);
    DescentGoal fine{.residual = 1e-4, .clearance = 1, .steps = 60};
    if (options_.budget.steps > 0)
      fine.steps = std::clamp(steps_left() - near.iterations, 1, fine.steps);
    const double step = std::max(near.last_step, 1e-3 * near.y.norm());
    // At least a few steps even past the budget: a pose fit to be returned, with its multipliers.
    const auto o = descent.run(chart_, near.y, fine, step, deadline_);
    iterations_ += near.iterations + o.iterations;
    return make_separation(chart_, o);
  }

  /// The translational depth to the last digit.
  std::optional<Separation> polish_translation() {
    if (translated_.empty()) return std::nullopt;
    Descent descent(probe_, fixed_, Method::pdt);
    const Separation out = polish(translating_[0], descent, translated_.front());
    if (overlap(probe_, fixed_, Transform(out.separated), Doubt::exact)) return std::nullopt;
    return out;
  }

  static bool nearer(const Found& a, const Found& b) { return a.depth < b.depth; }

  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  StaticOptions options_;
  Deadline deadline_;
  std::array<LeapDescent, 2> leaps_, translating_;
  Descent descent_;
  std::vector<Found> found_;
  std::vector<Found> translated_;
  double best_ = std::numeric_limits<double>::infinity();
  int agreeing_ = 0;
  int share_ = 0;  // of the steps, for each start of a round
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
