// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_worker.hpp"

#include <algorithm>
#include <cmath>

#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {

SearchWorker::SearchWorker(const Body& probe, const Body& fixed, const SearchTuning& tuning)
    : smallest_free_radius(tuning.smallest_ball * probe.mass.radius),
      probe_(probe),
      fixed_(fixed),
      tuned_(tuning),
      pdg_(probe, fixed, Method::pdg),
      pdt_(probe, fixed, Method::pdt),
      push_pdg_(probe, fixed, Method::pdg),
      push_pdt_(probe, fixed, Method::pdt) {}

void SearchWorker::time_into(PhaseTimes* times) noexcept {
  for (LeapDescent* leaps : {&pdg_, &pdt_}) leaps->time_into(times);
  for (PushApart* push : {&push_pdg_, &push_pdt_}) push->time_into(times);
}

LocalOptimum SearchWorker::descend(const Chart& chart, const Vec6& y, Method method,
                                   const Limits& limits) {
  const double beat = limits.beat;
  const auto rough = leaps(method).run(chart, y,
                                       {.steps = std::min(tuned_.descent_steps, limits.steps),
                                        .reach = tuned_.reach,
                                        .beat = tuned_.rough_error * beat},
                                       limits.before);
  LocalOptimum roughly{rough.y, rough.y.norm(), rough.iterations};
  const int left = limits.steps - roughly.iterations;
  if (left <= 0 || (beat > 0 && roughly.depth > tuned_.rough_error * beat)) return roughly;
  LocalOptimum out = descend_exactly(chart, rough.y, method, {left, beat, limits.before});
  out.iterations += roughly.iterations;
  return out;
}

LocalOptimum SearchWorker::descend_exactly(const Chart& chart, const Vec6& y, Method method,
                                           const Limits& limits) {
  const auto exact =
      leaps(method).run(chart, y,
                        {.guide = Guide::few,
                         .tolerance = tuned_.same / 2,
                         .steps = std::min(tuned_.descent_steps, limits.steps),
                         .reach = tuned_.reach,
                         .beat = std::isfinite(limits.beat) ? (1 + tuned_.same) * limits.beat : 0},
                        limits.before);
  return {exact.y, exact.y.norm(), exact.iterations};
}

Vec6 SearchWorker::sample(Random& random, double radius, Method method) const {
  Vec6 y = random.in_ball(radius);
  y.tail<3>() = fixed_.mass.R_MP * y.tail<3>();
  if (method == Method::pdt) y.head<3>().setZero();
  for (int k = 0; k < 3; ++k)
    if (!(probe_.mass.inertia[k] > 0)) y[k] = 0;
  return y;
}

std::optional<Vec6> SearchWorker::free_sample(const Chart& chart, Random& random,
                                              const Vec6& center, double radius, Method method,
                                              const Deadline& before, SketchDescent* sketches) {
  const double deepest = sketches ? tuned_.sketch_error * sketches->spacing() : 0;
  for (int i = 0; i < tuned_.tries_in_a_ball && !before.passed(); ++i) {
    Vec6 y = center + sample(random, radius, method);
    if (method == Method::pdt) y.head<3>().setZero();
    if (chart.v(y).norm() < descent_tuning.largest_start_v &&
        (!sketches || sketches->is_free(chart, y, deepest)) && leaps(method).is_free(chart, y))
      return y;
  }
  return std::nullopt;
}

}  // namespace sonde
