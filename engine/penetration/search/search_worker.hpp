// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/geometry/random.hpp"
#include "engine/penetration/descent/leap_descent.hpp"
#include "engine/penetration/descent/push_apart.hpp"
#include "engine/penetration/descent/sketch_descent.hpp"
#include "engine/penetration/search/local_optima.hpp"

namespace sonde {

/// What one thread of a search works with, one start after the other.
class SearchWorker {
 public:
  SearchWorker(const Body& probe, const Body& fixed, const SearchTuning& tuning = search_tuning);

  struct Limits {
    int steps;        ///< at most
    double beat;      ///< m: given up where it will not end much below; 0 or infinite: never
    Deadline before;  ///< the search's
  };
  /// Down by leaps, roughly and where that is promising by the true contacts.
  LocalOptimum descend(const Chart& chart, const Vec6& y, Method method, const Limits& limits);
  LocalOptimum descend_exactly(const Chart& chart, const Vec6& y, Method method,
                               const Limits& limits);

  /// Adds the times of phases to `times` from now on; null: to nothing.
  void time_into(PhaseTimes* times) noexcept;

  LeapDescent& leaps(Method method) { return method == Method::pdg ? pdg_ : pdt_; }
  const LeapDescent& leaps(Method method) const { return method == Method::pdg ? pdg_ : pdt_; }
  PushApart& push(Method method) { return method == Method::pdg ? push_pdg_ : push_pdt_; }
  int limited() const { return pdg_.limited() + pdt_.limited(); }

  /// A random displacement, not depending on how the world is turned.
  Vec6 sample(Random& random, double radius, Method method) const;
  /// Random poses of a ball about y: a free one, if there is one among so many. Where sketches lie
  /// plainly too deep, the bodies are not asked.
  std::optional<Vec6> free_sample(const Chart& chart, Random& random, const Vec6& center,
                                  double radius, int tries, Method method, const Deadline& before,
                                  SketchDescent* sketches = nullptr);

  double near;  ///< m: no free pose was found in smaller balls
  double smallest_ball() const { return tuned_.smallest_ball * probe_.mass.radius; }

 private:
  const Body& probe_;
  const Body& fixed_;
  const SearchTuning& tuned_;
  LeapDescent pdg_, pdt_;
  PushApart push_pdg_, push_pdt_;
};

}  // namespace sonde
