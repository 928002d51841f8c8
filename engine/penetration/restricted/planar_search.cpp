// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/planar_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "engine/base/elementary.hpp"
#include "engine/base/progress.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/geometry/random.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/leap_descent.hpp"
#include "engine/penetration/descent/refinement.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde {
namespace {

/// Factor on the best depth so far: later starts are free poses no farther away.
constexpr double farther = 1.5;
constexpr double same = 1.02;  ///< factor on the best: ends below it agree with it
constexpr int tries = 16;      ///< attempts to find a free pose
/// Number of ends, the nearest, that are refined to full accuracy.
constexpr std::size_t refined = 3;

/// A basis of the motions in a plane, in the coordinates of a chart: one for turns, two for slides.
struct Basis {
  Vec6 turn = Vec6::Zero();  // unit; 0 if there is no turn
  Vec6 slide[2];             // unit
  double most_turn = 0;      // m of `turn`: nearly half a turn

  Basis(const Chart& chart, const Vec3& normal, bool turning) {
    const Vec3 axis = chart.principal().conjugate() * normal;
    const Vec3 root = 2 * chart.mass().inertia.cwiseSqrt();
    const Vec3 weighted = root.cwiseProduct(axis);
    if (turning && weighted.norm() > 0) {
      most_turn = Chart::largest_v * weighted.norm();
      turn.head<3>() = weighted.normalized();
    }
    const Vec3 across = normal.unitOrthogonal();
    for (Vec6& y : slide) y.setZero();
    slide[0].tail<3>() = across;
    slide[1].tail<3>() = normal.cross(across);
  }
  Mat6 onto() const {
    Mat6 out = turn * turn.transpose();
    for (const Vec6& y : slide) out += y * y.transpose();
    return out;
  }
  Vec6 at(double u, double v, double w) const { return u * slide[0] + v * slide[1] + w * turn; }
};

class Planar {
 public:
  Planar(const Pair& pair, const Pose& X, const Vec3& normal, bool turning,
         const StaticOptions& options)
      : probe_(pair.probe()),
        fixed_(pair.fixed()),
        chart_(probe_.mass, X),
        basis_(chart_, normal, turning),
        method_(basis_.most_turn > 0 ? Method::pdg : Method::pdt),
        leaps_(probe_, fixed_, method_),
        random_(options.seed),
        deadline_{options.budget.microseconds, now_us()},
        far_((X * probe_.mass.com - fixed_.mass.com).norm() + probe_.mass.radius +
             fixed_.mass.radius) {
    leaps_.stay_within(basis_.onto());
  }

  Separation run(int starts, int agreement, const Progress& progress) {
    for (int i = 0; i < starts && agreeing() < agreement; ++i) {
      if (deadline_.passed() && !ends_.empty()) break;
      report(progress, double(i) / starts);
      const bool outside = i < agreement || ends_.empty();
      if (const auto y = outside ? from_far() : nearby()) descend(*y);
      if (outside) from_outside_ = ends_.size();
    }
    return finish();
  }
  const Deadline& deadline() const { return deadline_; }

 private:
  std::ptrdiff_t agreeing() const {
    return std::ranges::count_if(std::span(ends_).subspan(from_outside_),
                                 [&](const Vec6& y) { return y.norm() <= same * best_; });
  }
  std::optional<Vec6> from_far() {
    const double angle = random_.uniform(0, 2 * std::numbers::pi);
    const double turn = random_.uniform(-1, 1) * basis_.most_turn;
    const double reach = far_ * (1 + 1e-6);
    const Vec6 y = basis_.at(reach * elementary::cos(angle), reach * elementary::sin(angle), turn);
    return leaps_.is_free(chart_, y) ? std::optional(y) : std::nullopt;
  }
  std::optional<Vec6> nearby() {
    const double reach = farther * best_;
    for (int i = 0; i < tries; ++i) {
      const double turns = std::min(reach, basis_.most_turn);
      const double turn = turns * random_.uniform(-1, 1), second = reach * random_.uniform(-1, 1);
      const Vec6 y = basis_.at(reach * random_.uniform(-1, 1), second, turn);
      if (y.norm() < reach && leaps_.is_free(chart_, y)) return y;
    }
    return std::nullopt;
  }
  void descend(const Vec6& from) {
    const Vec6 y = leaps_.pull_in(chart_, from);
    const Vec6 end = leaps_.run(chart_, y, {.guide = Guide::few}, deadline_).y;
    ends_.push_back(end);
    best_ = std::min(best_, end.norm());
  }

  Separation finish() {
    std::ranges::stable_sort(ends_, {}, [](const Vec6& y) { return y.norm(); });
    Separation best = failed(chart_.device(), "no separated pose stood the exact test");
    Refinement refinement(probe_, fixed_, method_);
    refinement.stay_within(basis_.onto());
    for (std::size_t i = 0; i < std::min(refined, ends_.size()); ++i) {
      const Separation end =
          make_separation(chart_, refinement.run(chart_, ends_[i], leaps_, most_steps, deadline_));
      if (best.status == Status::penetrating && !(end.depth < best.depth)) continue;
      if (!overlap(probe_, fixed_, Transform(end.separated), Doubt::exact)) best = end;
    }
    return best;
  }

  static constexpr int most_steps = 200;
  const Body& probe_;
  const Body& fixed_;
  Chart chart_;
  Basis basis_;
  Method method_;
  LeapDescent leaps_;
  Random random_;
  Deadline deadline_;
  double far_;  // m: at this distance of the centres the bodies are apart
  double best_ = std::numeric_limits<double>::infinity();
  std::vector<Vec6> ends_;
  std::size_t from_outside_ = 0;  // number of ends, the first, of descents from outside
};

}  // namespace

Separation planar_separation(const Pair& pair, const Pose& X_FM, const Vec3& normal_F, bool turning,
                             const StaticOptions& options, const Progress& progress) {
  Planar search(pair, X_FM, normal_F, turning, options);
  Separation out =
      search.run(std::max(options.starts, 1), std::max(options.agreement, 1), progress);
  if (options.want_lower_bound && out.status == Status::penetrating)
    out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), X_FM, search.deadline(),
                                        {.translations = !turning, .known = out.depth});
  return out;
}

}  // namespace sonde
