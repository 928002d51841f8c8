// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/penetration/search/local_optima.hpp"
#include "engine/penetration/search/sketch_search.hpp"

namespace sonde {

/// Decides whether the best result of a search so far is probably the global optimum: by the number
/// of independent starts that agree on it, and by the sketches. It reads the search's current
/// results at each call.
class Evidence {
 public:
  struct Rules {
    int agreement = 12;  ///< number of agreeing starts that suffices, whatever the sketches show
    bool by_sketches = true;  ///< whether sketches may suffice (StaticOptions::by_evidence)
    const SearchTuning& tuned = search_tuning;
  };
  /// `sketched`: empty if the pair has no sketches.
  Evidence(const Chart& chart, const Rules& rules, const LocalOptima& optima,
           SketchSearch& sketches, std::span<SketchDescent> sketched)
      : chart_(chart), rules_(rules), optima_(optima), sketches_(sketches), sketched_(sketched) {}

  /// The best result so far is probably the global optimum.
  bool settles() const;
  /// The best depth of the bodies is about that of the sketches.
  bool sketches_see() const;
  /// The best way out is much longer than the overlap: a shorter one may exist that is too narrow
  /// for the sketches to resolve. Requires sketches.
  bool may_be_narrow() const;
  /// The same, however many starts agree: agreement shows that a way out is wide, not that no
  /// shorter and narrower one exists. False if there are no sketches, or if no point of theirs lies
  /// deep.
  bool may_be_deep() const { return !optima_.empty() && is_far_out(optima_.best()); }
  /// Whether a way out of this length, m, is long compared with the overlap (Separation::far_out).
  bool is_far_out(double depth) const;
  /// Estimated error of depths on sketches, m. Requires sketches.
  double sketch_error() const { return rules_.tuned.sketch_error * sketched_[0].spacing(); }

 private:
  int agreeing() const;
  bool sketches_are_clear() const;

  const Chart& chart_;
  Rules rules_;
  const LocalOptima& optima_;
  SketchSearch& sketches_;
  std::span<SketchDescent> sketched_;
};

}  // namespace sonde
