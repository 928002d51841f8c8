// SPDX-License-Identifier: GPL-3.0-or-later
// One run of a descent: its steps from a pose to a local optimum.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/penetration/descent/chart_rim.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"
#include "engine/penetration/descent/pace.hpp"
#include "engine/penetration/descent/step_mixing.hpp"

namespace sonde {
namespace {

/// Cost of a step in units of Effort, besides what is counted where it is spent.
constexpr int work_of_step = 500;

/// m²: the decrease of ½|y|² from y along the straight motion `way`, where it falls more steeply
/// than `slope` (m), less what it rises again at its end: the next step undoes that.
double fallen(const Vec6& y, const Vec6& way, double slope) {
  const double length = way.norm();
  const double steeper = length > 0 ? -y.dot(way) / length - slope : 0;
  const double steep = std::clamp(steeper, 0.0, length);  // beyond, the way is less steep
  const double along = length > 0 ? y.dot(way) / length : 0;
  const double lowest = std::clamp(-along, 0.0, length);
  const double risen = (along + 0.5 * (length + lowest)) * (length - lowest);
  return (steeper - 0.5 * steep) * steep - risen;
}

}  // namespace

/// The state that the steps of one run share.
class Descent::Run {
 public:
  Run(Descent& descent, const Chart& chart, const Vec6& start, const DescentGoal& goal,
      double expected_step, const Deadline& deadline, Effort& effort) noexcept
      : descent_(descent),
        rows_(descent.rows_),
        chart_(chart),
        goal_(goal),
        deadline_(deadline),
        effort_(effort),
        start_(start),
        y_(start) {
    const double radius = chart.mass().radius;
    pace_.scale = expected_step > 0 ? expected_step : descent_tuning.first_scale * radius;
    pace_.bending = descent_tuning.first_bending / radius;
    pace_.ceiling = start.norm() + descent_tuning.most_lift * descent.margin(chart, start.norm());
    if (expected_step > 0)
      pace_.longest = std::max(descent_tuning.longest_per_expected * expected_step,
                               descent_tuning.first_longest * radius);
  }

  Outcome descend() noexcept {
    // If the run starts at the pose at which the last run ended, the rows are still valid and give
    // the first step. This is so in most ticks.
    bool known = rows_.reuse_rows(chart_, y_);
    while (look_around(known) && !went_straight(nearest_.y - y_) && !is_at_end() && advance())
      known = false;
    // What a replaced row would allow does not hold the probe before it has moved there.
    if (replaced_) {
      out_.contacts = real_contacts_;
      out_.held = real_held_;
      out_.move_to(y_);
    }
    // Paths that were cut short cost nothing but time where the descent converged all the same.
    if (!out_.converged) out_.limited += cut_short_;
    return out_;
  }

 private:
  double flat() const { return descent_tuning.flat_within * margin_; }

  /// Of a run that is to, at its first step that leaves the straight way to the origin: moves there
  /// if that way is free. A row is a half-space, and may forbid a way through a hole or past an
  /// edge that nothing obstructs; and steps leave room at contacts that a straight way passes by.
  bool went_straight(const Vec6& step) noexcept {
    const double along = -step.dot(y_), longest = step.norm() * y_.norm();
    if (!may_go_straight_ || !(along < (1 - 1e-12) * longest)) return false;
    may_go_straight_ = false;
    // In pieces: for one long sweep with a large turn, the bound of the path's curvature is too
    // loose.
    const auto pieces = static_cast<int>(1 + chart_.v(y_).norm() / descent_tuning.largest_turn);
    const auto is_free = [&](Effort& part) {
      Vec6 from = y_;
      for (int left = pieces - 1; left >= 0; --left) {
        const Vec6 to = y_ * left / pieces;
        if (descent_.short_sweep_to(chart_, from, to, part).hit) return false;
        from = to;
      }
      return true;
    };
    // The rest is for a step, if this is none.
    if (!effort_.within(0.5, is_free)) return false;
    out_.iterations = std::max(out_.iterations, 1);
    effort_.spend(work_of_step);
    replaced_ = false;  // nothing holds the probe
    y_.setZero();
    out_.contacts = {};
    out_.held.setZero();
    out_.move_to(y_);
    return out_.converged = true;
  }

  /// m: the distance within which rows are gathered.
  double reach() const {
    const double nearest = descent_tuning.least_reach * margin_;
    const double widest = std::max(descent_tuning.widest_reach * chart_.mass().radius, nearest);
    const double wanted =
        out_.iterations == 0 ? descent_tuning.reach_at_first : descent_tuning.reach_later;
    return std::clamp(wanted * pace_.scale, nearest, widest);
  }

  void solve() noexcept {
    nearest_ = rows_.solve(margin_, ContactRows::SmallGaps::keep);
    descent_.report(out_, y_, nearest_);
  }

  /// Gathers the rows here, unless they are known, and solves for their nearest point. Returns
  /// false if the effort did not suffice.
  bool look_around(bool known) noexcept {
    margin_ = descent_.margin(chart_, y_.norm());
    out_.move_to(y_);
    const bool found = known || rows_.gather(chart_, y_, reach(), flat(), effort_);
    if (!found && out_.iterations > 0) return false;
    if (!found) {
      rows_.halve_next_reach(flat());
      rows_.move_rows_with_probe(chart_, y_);
    }
    solve();
    wanted_ = (nearest_.y - y_).norm();
    return found;
  }

  /// m: a pose this near its optimum counts as the optimum.
  double enough() const {
    return std::max(goal_.residual * y_.norm(), descent_tuning.off_in_margins * margin_);
  }

  bool is_settled() const {
    // Not counting what the rim of the chart holds: a descent that ends there is not converged.
    const double off = (out_.held - y_).norm();
    // If no row holds the probe, it can move to the device pose, so it is not settled before that,
    // however near that pose is.
    const bool held = out_.contacts.size > 0 && off <= enough() &&
                      rows_.smallest_gap() <= descent_tuning.settled_gap * margin_;
    return held || !(off > 0);
  }

  /// Replaces a row that forbids what its pair does not obstruct. Returns false if there is none.
  bool replaces_row() noexcept {
    if (rows_.replace_far_rows(chart_, y_, nearest_, margin_)) return true;
    if (refuted_) return false;
    const ContactSet contacts = out_.contacts;
    const Vec6 held = out_.held;
    if (!rows_.replace_blocking_row(chart_, y_, nearest_, margin_, enough())) return false;
    if (!std::exchange(replaced_, true)) real_contacts_ = contacts, real_held_ = held;
    return true;
  }

  /// Whether the probe is at an optimum: a pose that is one only because of rows that are no real
  /// constraints is none.
  bool settles() noexcept {
    for (int replaced = 0; is_settled(); ++replaced) {
      if (!replaces_row()) return true;
      solve();
      if (replaced == descent_tuning.most_replaced) break;
    }
    return false;
  }

  bool is_at_end() noexcept {
    out_.converged = settles();
    // At least one step, however late it is: a tick that never moves would never catch up.
    const bool late = out_.iterations > 0 && deadline_.passed();
    if (out_.converged) return true;
    const bool stalled = pace_.stalled >= descent_tuning.most_stalled;
    if (!late && !stalled && out_.iterations < goal_.steps) return false;
    out_.limited += stalled || at_rim(chart_, y_);
    if (rows_.smallest_gap() > descent_tuning.touching_gap * margin_)
      descent_.approach_contact(chart_, margin_, effort_, out_);
    return true;
  }

  /// The step from here, recomputed as long as the check of its end finds obstacles. Zero if the
  /// rows found in this way show that the descent has ended.
  Vec6 step_round_obstacles() noexcept {
    double rise = 0;
    Vec6 step = descent_.next_step(chart_, y_, nearest_, margin_, rise, pace_);
    for (int round = 0; round < descent_tuning.most_cuts; ++round) {
      const ContactRows::PathCheck look =
          rows_.add_cuts(chart_, y_, Motion(chart_, y_, y_ + step), margin_, effort_);
      if (look.clear || effort_.is_spent()) return step;
      if (look.news) {
        solve();
        out_.converged = settles();
        if (out_.converged) return Vec6::Zero();
      }
      out_.limited += !look.news && rows_.is_full();
      // Contacts that already have rows bend into the path by this much.
      rise = look.news ? 0 : rise + descent_tuning.rise_per_loss * look.lost;
      const Vec6 before = step;
      step = descent_.next_step(chart_, y_, nearest_, margin_, rise, pace_);
      // Nothing new was found: the sweep decides how far the step is free.
      if (!look.news && step == before) return step;
    }
    ++out_.limited;
    return step;
  }

  /// The step that is taken for a wanted one. Steps that turn back, or make up a series, are not
  /// mixed.
  Vec6 step_of(const Vec6& wanted) noexcept {
    mixing_.note(y_, nearest_.y - y_);
    const Vec6 damped = pace_.damped(wanted);
    Vec6 step = with_those_to_come(damped);
    if (pace_.extrapolates || pace_.in_series || damped != wanted) return step;
    if (const std::optional<Vec6> mixed = mixed_step()) {
      mixing_.take();
      step = *mixed;
    }
    return step;
  }

  /// Of a run that takes many steps: a mixed step, within all limits of a step, if it is longer
  /// than what the rows want and meets nothing that they do not know. As other steps may, it may
  /// end above where it began, since the way down bends. (Ended where |y| is least on it, it gains
  /// nothing: of the 140 paths that did not choose `steps_before_mixing`, 91 ticks do not converge
  /// then. Going back to the lowest pose where a run ends early costs a ball in its socket and a
  /// nut on its bolt a tenth more ticks that do not.)
  std::optional<Vec6> mixed_step() noexcept {
    if (out_.iterations < descent_tuning.steps_before_mixing) return std::nullopt;
    const std::optional<Vec6> mixed = mixing_.mixed();
    if (!mixed || !(mixed->dot(y_) < 0)) return std::nullopt;
    const double most =
        std::min({1.0, pace_.to_ceiling(y_, *mixed), pace_.longest / mixed->norm(),
                  descent_.most_of_path(chart_, y_, *mixed, margin_, pace_),
                  descent_tuning.largest_turn / std::max(chart_.v(*mixed).norm(), 1e-30)});
    Vec6 step = most * *mixed;
    const bool pays = step.norm() > descent_tuning.least_extrapolation * (nearest_.y - y_).norm();
    if (!pays || !is_clear_until(y_ + step)) return std::nullopt;
    return step;
  }

  /// The step and those that are to follow it in its direction, if nothing is in their way that the
  /// rows do not know.
  Vec6 with_those_to_come(const Vec6& step) noexcept {
    const double most =
        std::min(descent_.most_of_path(chart_, y_, step, margin_, pace_),
                 descent_tuning.largest_turn / std::max(chart_.v(step).norm(), 1e-30));
    const std::optional<Vec6> all = pace_.extrapolated(y_, step, most);
    pace_.extrapolates = all && is_clear_until(y_ + *all);
    if (all && !pace_.extrapolates) pace_.end_series();
    return pace_.extrapolates ? *all : step;
  }

  bool is_clear_until(const Vec6& target) noexcept {
    if (chart_.v(target).norm() > Chart::largest_v) return false;
    const ContactRows::PathCheck look =
        rows_.add_cuts(chart_, y_, Motion(chart_, y_, target), margin_, effort_);
    return look.looked && look.clear;
  }

  /// Takes a step, as far as its path is free. Returns false if the descent has ended.
  bool advance() noexcept {
    ++out_.iterations;
    effort_.spend(work_of_step);
    pace_.longest *= descent_tuning.longest_growth;
    const Vec6 wanted = step_round_obstacles();
    if (out_.converged) return false;
    if (!(wanted.squaredNorm() > 0)) {
      refuted_ = refuted_ || replaced_;
      if (std::exchange(replaced_, false)) return true;
      out_.limited += at_rim(chart_, y_);
      return false;
    }
    if (went_straight(wanted)) return false;
    const Vec6 step = step_of(wanted);
    const Vec6 target = y_ + step;
    const Sweep swept = descent_.short_sweep_to(chart_, y_, target, effort_);
    learn_path_length(swept, target);
    cut_short_ += swept.given_up && !effort_.is_spent();
    out_.fallen += fallen(y_, swept.free_until * step, goal_.held_slope);
    y_ = swept.hit ? Vec6(y_ + swept.free_until * step) : target;
    pace_.learn(step, swept, descent_tuning.nowhere * std::max(margin_, 1e-3 * wanted_),
                chart_.mass().radius);
    refuted_ = refuted_ || (replaced_ && pace_.stalled > 0);
    replaced_ = false;
    const bool too_dear = swept.given_up && start_.norm() > goal_.held_off;
    if (too_dear || (y_ - start_).norm() > goal_.far) limit_fall();
    return true;
  }

  void limit_fall() noexcept {
    if (goal_.work_of_fall == 0 || effort_.is_limited()) return;
    const std::int64_t spent = left_at_start_ - effort_.left();
    effort_ = {std::max<std::int64_t>(1, goal_.work_of_fall - spent), 0};
  }

  void learn_path_length(const Sweep& swept, const Vec6& target) noexcept {
    if (swept.given_up)
      descent_.path_length_.gave_up(Motion(chart_, y_, target).farthest(chart_.mass().radius),
                                    !effort_.is_spent());
    else
      descent_.path_length_.went();
  }

  Descent& descent_;
  ContactRows& rows_;
  const Chart& chart_;
  const DescentGoal& goal_;
  const Deadline& deadline_;
  Effort& effort_;
  const Vec6 start_;
  Vec6 y_;  // the current pose: free
  Pace pace_{};
  StepMixing mixing_;
  double margin_ = 0;      // m: the gap aimed at, at y_
  LeastDistance nearest_;  // solution of the current rows
  double wanted_ = 0;      // m: length of the first undamped step here
  bool may_go_straight_ = goal_.straight_first;
  ContactSet real_contacts_;  // before a row was replaced
  Vec6 real_held_ = Vec6::Zero();
  bool replaced_ = false;  // the step is one that a replaced row allows
  bool refuted_ = false;   // such a step led nowhere: the rows were right
  int cut_short_ = 0;      // paths whose sweep was given up
  const std::int64_t left_at_start_ = effort_.left();  // units of Effort
  Outcome out_;
};

Descent::Outcome Descent::run(const Chart& chart, const Vec6& start, const DescentGoal& goal,
                              double expected_step, const Deadline& deadline) noexcept {
  Effort unlimited;
  return Run(*this, chart, start, goal, expected_step, deadline, unlimited).descend();
}

Descent::Outcome Descent::run(const Chart& chart, const Vec6& start, const DescentGoal& goal,
                              double expected_step, Effort& effort) noexcept {
  return Run(*this, chart, start, goal, expected_step, {}, effort).descend();
}

}  // namespace sonde
