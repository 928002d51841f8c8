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

/// The workspace of one thread of a search, which runs one start after the other.
class SearchWorker {
 public:
  SearchWorker(const Body& probe, const Body& fixed, const SearchTuning& tuning = search_tuning);

  struct Limits {
    int steps;        ///< maximum number of steps
    double beat;      ///< m: given up if it will not end much below; 0 or infinite: never
    Deadline before;  ///< the end of the search's time
  };
  /// Descends by leaps: roughly by outlines, and then, if that is promising, by the true contacts.
  LocalOptimum descend(const Chart& chart, const Vec6& y, Method method, const Limits& limits);
  LocalOptimum descend_exactly(const Chart& chart, const Vec6& y, Method method,
                               const Limits& limits);

  /// From now on, adds the time spent in each phase to `times`. Null: records no times.
  void time_into(PhaseTimes* times) noexcept;

  LeapDescent& leaps(Method method) { return method == Method::pdg ? pdg_ : pdt_; }
  const LeapDescent& leaps(Method method) const { return method == Method::pdg ? pdg_ : pdt_; }
  PushApart& push(Method method) { return method == Method::pdg ? push_pdg_ : push_pdt_; }
  int limited() const { return pdg_.limited() + pdt_.limited(); }

  /// A random displacement that does not depend on the orientation of the world frame.
  Vec6 sample(Random& random, double radius, Method method) const;
  /// A free pose among SearchTuning::tries_in_a_ball random poses of a ball about `center`, if
  /// there is one. Where the sketches overlap by more than SearchTuning::sketch_error, the bodies
  /// are not tested.
  std::optional<Vec6> free_sample(const Chart& chart, Random& random, const Vec6& center,
                                  double radius, Method method, const Deadline& before,
                                  SketchDescent* sketches = nullptr);

  double smallest_free_radius;  ///< m: smaller balls had no free pose
  double smallest_ball() const { return tuned_.smallest_ball * probe_.mass.radius; }

 private:
  const Body& probe_;
  const Body& fixed_;
  const SearchTuning& tuned_;
  LeapDescent pdg_, pdt_;
  PushApart push_pdg_, push_pdt_;
};

}  // namespace sonde
