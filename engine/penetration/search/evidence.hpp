// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/penetration/search/local_optima.hpp"
#include "engine/penetration/search/sketch_search.hpp"

namespace sonde {

/// Decides whether the best result of a search so far is probably the global optimum: from the
/// number of independent starts that agree on it, and from the descents on sketches. Each call
/// reads the current results of the search.
class Evidence {
 public:
  struct Rules {
    int agreement = 12;       ///< agreeing starts that suffice, whatever the sketches show
    bool by_sketches = true;  ///< whether sketches may suffice (StaticOptions::by_evidence)
    const SearchTuning& tuned = search_tuning;
  };
  /// `descents`: empty if the pair has no sketches.
  Evidence(const Chart& chart, const Rules& rules, const LocalOptima& optima,
           SketchSearch& sketches, std::span<SketchDescent> descents)
      : chart_(chart), rules_(rules), optima_(optima), sketches_(sketches), descents_(descents) {}

  /// The best result so far is probably the global optimum.
  bool is_conclusive() const;
  /// Whether the sketches can be trusted: the best depth found on the bodies is about the best
  /// depth found on the sketches.
  bool sketches_see() const;
  /// Whether a shorter separating motion may exist through a gap too narrow for the sketches to
  /// resolve: the evidence is not conclusive, or the best one is rather long compared with the
  /// overlap. Requires sketches.
  bool may_be_narrow() const;
  /// Whether the best separating motion found is long compared with the overlap. The number of
  /// agreeing starts does not count here: agreement shows that many starts reach a separating
  /// motion, not that no shorter one exists through a narrower gap. False if there are no sketches,
  /// or if none of their points lies inside the other body.
  bool may_be_deep() const { return !optima_.empty() && is_far_out(optima_.best()); }
  /// Whether a separating motion of this length, m, is long compared with the overlap
  /// (Separation::far_out).
  bool is_far_out(double depth) const;
  /// Estimated error, m, of depths found on sketches. Requires sketches.
  double sketch_error() const { return rules_.tuned.sketch_error * descents_[0].spacing(); }

 private:
  int agreeing() const;
  /// Whether a separating motion of this length, m, exceeds so many times the depth of the deepest
  /// sketch point.
  bool exceeds(double depth, double times) const;
  bool sketches_are_clear() const;

  const Chart& chart_;
  Rules rules_;
  const LocalOptima& optima_;
  SketchSearch& sketches_;
  std::span<SketchDescent> descents_;
};

}  // namespace sonde
